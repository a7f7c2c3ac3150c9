// A board on an etcd of little space: large facts for many times that space, and an etcd that others filled.

#include <gtest/gtest.h>
#include <thread>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/cluster/etcd_client.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/blackboard/cluster/real_etcd.hpp"
#include "tests/campaign.hpp"
#include "tests/free_port.hpp"
#include "tests/run_task.hpp"

namespace pizarra::cluster {
namespace {

constexpr std::size_t megabyte = 1 << 20;
constexpr std::size_t quota = 32 * megabyte;

class BoardsWithLittleSpace : public testing::Test {
 protected:
  void SetUp() override {
    if (!RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    etcd_ = std::make_unique<RealEtcd>("", std::vector<std::string>{"--quota-backend-bytes=" + std::to_string(quota)});
    const std::string address = "tcp://127.0.0.1:" + std::to_string(free_port());
    board_ = std::make_unique<ChildProgram>(
        std::vector<std::string>{PIZARRA_BOARD, "--listen", address, "--log", etcd_->address("little")});
    // A board that makes space on a busy disk answers late.
    client_ = client::RemoteBoard::connect(executor_, address, "tester", 60s).value();
    const Relation picture =
        relation_from_datum(read_one("(relation picture ((n integer) (bytes string)) (key n) (durable))").value())
            .value();
    for (int tries = 0; tries < 10 && !run(executor_, client_->declare({picture})); ++tries) continue;
    own_ = EtcdClient::open(LogAddress::from(etcd_->address("little"), "", false).value()).value();
  }
  Result<Revision> tell(std::int64_t n, char letter, std::size_t bytes) {
    return run(executor_, client_->tell(list("picture"_sym, n, to_datum(std::string(bytes, letter)))));
  }

  std::unique_ptr<RealEtcd> etcd_;
  std::unique_ptr<ChildProgram> board_;
  RealExecutor executor_;
  std::unique_ptr<client::RemoteBoard> client_;
  std::unique_ptr<EtcdClient> own_;
};

TEST_F(BoardsWithLittleSpace, GoOnWithLargeFactsForManyTimesTheSpace) {
  int refused = 0;  // one after another
  const auto spaces = campaign<std::size_t>(3, 5);
  for (std::size_t told = 0; told < spaces * quota;) {
    const std::size_t bytes = 900'000;
    const Result<Revision> revision = tell(1, static_cast<char>('a' + told / bytes % 26), bytes);
    if (revision) {
      told += bytes;
      refused = 0;
      continue;
    }
    ASSERT_EQ(revision.error().symbol, "journal-full") << describe(revision.error());
    ASSERT_LT(++refused, 100);
    std::this_thread::sleep_for(50ms);
  }
  const Result<KeyValues::Space> space = own_->space(patience);
  ASSERT_TRUE(space.has_value());
  EXPECT_EQ(space->most, quota);
  EXPECT_LT(space->taken, quota);
  EXPECT_FALSE(space->refuses);
}

TEST_F(BoardsWithLittleSpace, GoOnWhenAnotherUserFilledEtcdWithWhatCanGo) {
  ASSERT_TRUE(tell(1, 'a', 1000));
  const KeyValues::Transaction junk{.compares = {}, .puts = {{"junk", std::string(megabyte, 'x')}}};
  Result<KeyValues::Reply> put = own_->transact(junk, 5 * patience);
  while (put) put = own_->transact(junk, 5 * patience);
  EXPECT_TRUE(lacks_space(put.error())) << describe(put.error());
  EXPECT_TRUE(put.error().sentence.contains("alarm NOSPACE")) << put.error().sentence;
  Result<Revision> told = tell(1, 'b', 1000);
  for (int tries = 0; tries < 10 && !told; ++tries) told = tell(1, 'b', 1000);
  EXPECT_TRUE(told) << describe(told.error());
  EXPECT_FALSE(own_->space(patience).value().refuses);
}

}  // namespace
}  // namespace pizarra::cluster
