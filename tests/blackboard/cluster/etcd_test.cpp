// Requests of the cluster log, made to etcd itself.

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/etcd_client.hpp"
#include "tests/blackboard/cluster/real_etcd.hpp"

namespace pizarra::cluster {
namespace {

class Etcd : public testing::Test {
 protected:
  void SetUp() override {
    if (!RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    etcd_ = std::make_unique<RealEtcd>();
    client_ = EtcdClient::open(LogAddress::from(etcd_->address("cell"), "", false).value()).value();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!get(*client_, "ready") && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  std::unique_ptr<RealEtcd> etcd_;
  std::unique_ptr<EtcdClient> client_;
};

TEST_F(Etcd, ComparesAndPutsAsAWholeOrNotAtAll) {
  const std::string bytes("\0\xff\n\"(", 5);
  const auto put = client_->transact({.compares = {{"a", std::nullopt}}, .puts = {{"a", bytes}, {"b", ""}}}, patience);
  ASSERT_TRUE(put && put->succeeded) << describe(put.error());
  EXPECT_EQ(get(*client_, "a").value(), bytes);
  EXPECT_EQ(get(*client_, "b").value(), "");
  EXPECT_EQ(get(*client_, "c").value(), std::nullopt);
  const auto again = client_->transact({.compares = {{"a", std::nullopt}, {"b", ""}}, .puts = {{"c", "1"}}}, patience);
  ASSERT_TRUE(again.has_value());
  EXPECT_FALSE(again->succeeded);
  EXPECT_EQ(again->found, (std::vector<KeyValue>{{"a", bytes}, {"b", ""}}));
  EXPECT_EQ(get(*client_, "c").value(), std::nullopt);
  const auto gone = client_->transact({.compares = {{"a", bytes}}, .deletes = {{"a", "b"}}}, patience);
  EXPECT_TRUE(gone && gone->succeeded);
  EXPECT_EQ(client_->range({"a", "z"}, 10, patience).value(), (std::vector<KeyValue>{{"b", ""}}));
}

TEST_F(Etcd, GivesARangeInOrderUpToALimit) {
  for (const int i : {3, 1, 2}) {
    (void)client_->transact({.compares = {}, .puts = {{"k" + std::to_string(i), std::to_string(i)}}}, patience);
  }
  EXPECT_EQ(client_->range({"k", "l"}, 2, patience).value(), (std::vector<KeyValue>{{"k1", "1"}, {"k2", "2"}}));
}

// 198.51.100.1 and .2 are addresses for documentation: no host has them.
TEST_F(Etcd, IsAskedFirstWhereItIsOnThisHost) {
  const std::string own = etcd_->address("cell").substr(std::string("etcd://").size());
  const LogAddress log = LogAddress::from("etcd://198.51.100.1,198.51.100.2," + own, "", true).value();
  const auto client = EtcdClient::open(log).value();
  const auto found = client->range({"k", "l"}, 2, patience);
  EXPECT_TRUE(found.has_value()) << found.error().sentence;
}

TEST_F(Etcd, ThatIsStoppedIsUnavailableWithinTheTimeAskedFor) {
  etcd_->signal(SIGSTOP);
  const auto begun = std::chrono::steady_clock::now();
  const auto failed = client_->transact({.compares = {}, .puts = {{"a", "1"}}}, 200ms);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2));
  ASSERT_FALSE(failed.has_value());
  EXPECT_EQ(failed.error().symbol, "unavailable");
  EXPECT_TRUE(failed.error().sentence.contains("127.0.0.1")) << failed.error().sentence;
  etcd_->signal(SIGCONT);
  // It may have lost its own lead meanwhile, and says so.
  bool goes_on = false;
  const auto end = begun + std::chrono::seconds(60);
  while (!goes_on && std::chrono::steady_clock::now() < end) {
    goes_on = client_->transact({.compares = {}, .puts = {{"a", "2"}}}, patience).has_value();
  }
  EXPECT_TRUE(goes_on);
}

TEST(LogAddress, NamesMembersAndACellAndIsRefusedWhereOthersCouldListen) {
  const LogAddress address = LogAddress::from("etcd://127.0.0.1:7,localhost/blocks", "", false).value();
  EXPECT_EQ(address.members, (std::vector<std::string>{"127.0.0.1:7", "localhost:2379"}));
  EXPECT_EQ(address.cell, "blocks");
  for (const char* wrong : {"etcd://a",
                            "etcd:///c",
                            "etcd://a,/c",
                            "etcd://a/",
                            "etcd://a/b c",
                            "http://a/b",
                            "etcd://127.0.0.1:42x79/b",
                            "etcd://a:99999/b",
                            "etcd://a:65536/b",
                            "etcd://a:0/b",
                            "etcd://a:-1/b",
                            "etcd://a:/b",
                            "etcd://:/b",
                            "etcd://:2379/b",
                            "etcd://a b/c",
                            "etcd:// a/c",
                            "etcd://a,a/c",
                            "etcd://a,b,a:2379/c",
                            "etcd://[fd00/c",
                            "etcd://[]/c",
                            "etcd://[fd00::1]x/c",
                            "etcd://[localhost]/c",
                            "etcd://fd00::1/c"}) {
    EXPECT_EQ(LogAddress::from(wrong, "", true).error().symbol, "bad-address") << wrong;
  }
  EXPECT_EQ(LogAddress::from("etcd://[fd00::1],[fd00::1]:65535/c", "", true).value().members,
            (std::vector<std::string>{"[fd00::1]:2379", "[fd00::1]:65535"}));
  for (const char* elsewhere : {"etcd://10.0.0.1/c", "etcd://127.evil.example/c", "etcd://127.0.0.1,localhost.b/c"}) {
    const Result<LogAddress> refused = LogAddress::from(elsewhere, "", false);
    ASSERT_FALSE(refused) << elsewhere;
    EXPECT_EQ(refused.error().symbol, "not-loopback") << elsewhere;
  }
  EXPECT_TRUE(LogAddress::from("etcd://10.0.0.1/c", "keys", false).has_value());
}

}  // namespace
}  // namespace pizarra::cluster
