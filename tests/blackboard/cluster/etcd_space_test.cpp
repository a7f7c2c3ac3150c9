// Members of one etcd have a quota each: the smallest one's alarm keeps all from writing.

#include <chrono>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <thread>

#include "blackboard/cluster/etcd_client.hpp"
#include "blackboard/cluster/log_upkeep.hpp"
#include "tests/blackboard/cluster/real_etcd.hpp"
#include "tests/free_port.hpp"

namespace pizarra::cluster {
namespace {

// Two members with etcd's own quota, of which the board asks the first, and one with 8 MB.
class EtcdOfUnequalMembers : public testing::Test {
 protected:
  void SetUp() override {
    if (!RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    std::vector<std::string> peers;
    std::string cluster;
    for (std::size_t number = 0; number < members; ++number) {
      peers.push_back(fmt::format("http://127.0.0.1:{}", free_port()));
      cluster += fmt::format("{}m{}={}", number == 0 ? "" : ",", number, peers.back());
    }
    for (std::size_t number = 0; number < members; ++number) {
      std::vector<std::string> words = {fmt::format("--name=m{}", number), "--listen-peer-urls=" + peers[number],
                                        "--initial-advertise-peer-urls=" + peers[number],
                                        "--initial-cluster=" + cluster};
      if (number == small_one) words.push_back(fmt::format("--quota-backend-bytes={}", 8 << 20));
      etcds_.push_back(std::make_unique<RealEtcd>("", words));
    }
    std::string log = "etcd://";
    for (std::size_t number = 0; number < members; ++number) log += (number == 0 ? "" : ",") + place(number);
    client_ = EtcdClient::open(LogAddress::from(log + "/cell", "", false).value()).value();
    ASSERT_TRUE(comes_true([this] { return put("ready", 1); }));
  }
  // HOST:PORT
  std::string place(std::size_t number) const {
    const std::string address = etcds_[number]->address("cell");
    const std::size_t begin = std::string("etcd://").size();
    return address.substr(begin, address.find('/', begin) - begin);
  }
  bool put(const std::string& key, std::size_t bytes) {
    return client_->transact({.compares = {}, .puts = {{key, std::string(bytes, 'x')}}}, 5s).has_value();
  }
  static bool comes_true(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return true;
  }

  static constexpr std::size_t members = 3;
  static constexpr std::size_t small_one = 2;
  std::vector<std::unique_ptr<RealEtcd>> etcds_;
  std::unique_ptr<EtcdClient> client_;
};

TEST_F(EtcdOfUnequalMembers, TakesAgainWhenTheFullOneIsFreedWhoeverIsAsked) {
  int before_full = 0;
  while (before_full < 100 && put("again and again", 1 << 20)) ++before_full;
  ASSERT_LT(before_full, 100) << "the small member gave no alarm";
  ASSERT_TRUE(comes_true([this] { return make_space(*client_).has_value(); }));
  const auto space = client_->space(patience);
  ASSERT_TRUE(space.has_value()) << describe(space.error());
  EXPECT_FALSE(space->refuses);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(put("again and again", 1 << 20)) << i;
}

TEST_F(EtcdOfUnequalMembers, SaysWhichOneIsFullWhoeverIsAsked) {
  // A first alarm may come of holes in the small member's file, which can be closed.
  Result<void> made;
  for (int i = 0; i < 100 && made; ++i) {
    if (!put(fmt::format("needed-{}", i), 1 << 20)) made = make_space(*client_);
  }
  ASSERT_FALSE(made.has_value()) << "the small member gave no alarm that lasts";
  EXPECT_TRUE(lacks_space(made.error()));
  EXPECT_TRUE(made.error().sentence.contains("at the member " + place(small_one))) << made.error().sentence;
  EXPECT_TRUE(client_->space(patience).value().refuses);
}

}  // namespace
}  // namespace pizarra::cluster
