// A board that takes over and what was to end by itself: lifetimes of facts begin anew, leases end with their board.

#include <gtest/gtest.h>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/standby.hpp"
#include "blackboard/server/kept_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"
#include "tests/run_task.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys kept_cell("kept");

class LeasesTakenOver : public testing::Test {
 protected:
  LeasesTakenOver() { etcd_.trouble = 0; }

  // A board that took the lead from whoever had it, in etcd's good days.
  std::unique_ptr<server::KeptBoard> take_over(std::uint64_t nonce) {
    Standby standby(*client_, kept_cell, "board-pc", nonce, etcd_.now);
    const auto leads = [&] { return standby.step([this] { return etcd_.now; }).value(); };
    if (!leads()) {
      // It has seen who leads now, and takes that one for dead.
      standby.suspect();
      EXPECT_TRUE(leads());
    }
    const WonEpoch won = standby.take_epoch();
    const std::string head = get(*client_, kept_cell.head()).value().value_or("0");
    EXPECT_TRUE(standby.followed().follow_to(std::stoull(head)).has_value());
    const auto log = std::make_shared<ClusterLog>(client_, client_, kept_cell, won.value(), standby.followed().number(),
                                                  "etcd://model");
    std::unique_ptr<store::Store> store = standby.followed().take_store();
    store->restore_counters(won.first_revision(), won.first_fact());
    auto board = std::make_unique<server::KeptBoard>(executor_);
    board->lead(std::move(store), won.value().number << 40, {}, log);
    return board;
  }
  std::size_t standing(server::KeptBoard& board, const char* pattern) {
    const auto view = board.board().view("judge");
    return run(executor_, view->facts(read_one(pattern).value())).value().size();
  }

  EtcdModel etcd_{1};
  const std::shared_ptr<ModelClient> client_ = std::make_shared<ModelClient>(etcd_);
  VirtualExecutor executor_;
};

TEST_F(LeasesTakenOver, AFactWithALifetimeHasAllOfItAgainAndALeaseEndsWithItsBoard) {
  std::vector<Relation> relations;
  for (const char* text :
       {"(relation wish ((n integer)) (key n) (durable) (lease 10000))",
        "(relation goal ((n integer)) (key n) (durable))", "(relation seen ((n integer)) (key n))"}) {
    relations.push_back(relation_from_datum(read_one(text).value()).value());
  }
  auto former = take_over(1);
  const auto alice = former->board().view("alice");
  ASSERT_TRUE(run(executor_, alice->declare(relations)).has_value());
  const LeaseId lease = run(executor_, alice->lease(60s)).value();
  Transaction telling;
  telling.tell(list("wish"_sym, 1)).tell(list("goal"_sym, 1)).tell(list("goal"_sym, 2), {}, lease);
  telling.tell(list("goal"_sym, 3)).tell(list("seen"_sym, 1), {}, lease);
  ASSERT_TRUE(run(executor_, alice->transact(std::move(telling))).has_value());
  ASSERT_TRUE(run(executor_, alice->take(read_one("(goal 3)").value(), lease)).has_value());
  executor_.run_for(6s);
  ASSERT_EQ(former->journal()->kept(), former->journal()->position());

  const auto next = take_over(2);
  const auto bob = next->board().view("bob");
  EXPECT_EQ(standing(*next, "(seen ?)"), 0u);
  EXPECT_EQ(standing(*next, "(goal 2)"), 0u) << "it stood under the lease";
  EXPECT_EQ(standing(*next, "(goal 1)"), 1u);
  EXPECT_EQ(standing(*next, "(goal 3)"), 1u) << "who took it has lost it";
  EXPECT_EQ(run(executor_, bob->renew(lease)).error().symbol, "unknown-lease");
  EXPECT_GT(run(executor_, bob->lease(1s)).value(), lease) << "nor is it given out again";
  executor_.run_for(10s - 1ms);
  EXPECT_EQ(standing(*next, "(wish 1)"), 1u) << "16 s after it was told";
  executor_.run_for(1s);
  EXPECT_EQ(standing(*next, "(wish 1)"), 0u);
  EXPECT_EQ(standing(*former, "(wish 1)"), 0u) << "as with its first board";
}

}  // namespace
}  // namespace pizarra::cluster
