// A board and a client whose clocks do not agree, as after one of them was set.

#include <gtest/gtest.h>
#include <thread>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

// A board on a thread of its own, whose clock is so much ahead.
class BoardElsewhere {
 public:
  explicit BoardElsewhere(Duration ahead) : thread_([this, ahead] { serve(ahead); }) {}
  ~BoardElsewhere() {
    ended_ = true;
    thread_.join();
  }
  const std::string address = ipc_address();

 private:
  void serve(Duration ahead) {
    RealExecutor executor(RealExecutor::wall_clock() + ahead);
    memory::MemoryBoard board(executor);
    const auto server = server::BoardServer::open(executor, board, {.addresses = {address}}).value();
    const std::function<void()> look = [&] { executor.call_at(executor.now() + 10ms, [&] { look(); }); };
    look();
    executor.run_until([this] { return ended_.load(); });
  }
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

class ClocksTest : public testing::TestWithParam<Duration>, public Wall {
 protected:
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override { return connect(teller); }
  std::unique_ptr<client::RemoteBoard> connect(const std::string& teller) {
    return client::RemoteBoard::connect(executor_, board_.address, teller).value();
  }
  BoardElsewhere board_{GetParam()};
  RealExecutor executor_;
};

TEST_P(ClocksTest, ALeaseLastsAsLongAsItSays) {
  const auto alice = connect("alice");
  ASSERT_EQ(symbol_of(run(alice->declare({relation("(relation mode ((name symbol)) (key))")}))), "ok");
  const std::unique_ptr<Watch> watch = run(alice->watch(query("(mode ?m)"))).value();
  run(watch->next()).value();
  const LeaseId lease = run(alice->lease(400ms)).value();
  Transaction transaction;
  transaction.tell(read("(mode ready)"), {}, lease);
  const Time told = executor_.now();
  ASSERT_EQ(symbol_of(run(alice->transact(transaction))), "ok");
  EXPECT_EQ(run(watch->next())->added.size(), 1U);
  EXPECT_EQ(run(watch->next())->removed.size(), 1U);
  EXPECT_GT(executor_.now() - told, 350ms);
  EXPECT_LT(executor_.now() - told, 5s);
}

TEST_P(ClocksTest, TheClientKnowsTheBoardsTimeAndJourneysAreNotConfused) {
  const auto alice = connect("alice");
  ASSERT_EQ(symbol_of(run(alice->declare({relation("(relation mode ((name symbol)) (key))")}))), "ok");
  ASSERT_TRUE(comes([&] { return alice->board_time().has_value(); }));
  const Duration ahead = *alice->board_time() - executor_.now();
  EXPECT_LT(std::chrono::abs(ahead - GetParam()), 1s);
  const std::unique_ptr<Watch> watch = run(alice->watch(query("(mode ?m)"))).value();
  run(watch->next()).value();
  ASSERT_EQ(symbol_of(run(alice->tell(read("(mode ready)")))), "ok");
  run(watch->next()).value();
  std::vector<Answer> journeys;
  for (int tries = 0; tries < 100 && journeys.empty(); ++tries) {
    pass(20ms);
    journeys = run(alice->ask(query("(journey-stats mode (?told ? ? ?took) ?)")))->answers;
  }
  ASSERT_EQ(journeys.size(), 1U);
  EXPECT_EQ(journeys.front().bindings.find("?told")->integer(), 1);
  EXPECT_LT(journeys.front().bindings.find("?took")->integer(), 5'000'000);
}

INSTANTIATE_TEST_SUITE_P(Clocks, ClocksTest, testing::Values(Duration(0s), Duration(3600s), Duration(-3600s)),
                         [](const auto& tested) {
                           return tested.param == 0s ? "Agree" : tested.param > 0s ? "BoardAhead" : "BoardBehind";
                         });

}  // namespace
}  // namespace pizarra
