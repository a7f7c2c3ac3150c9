// The shipped server, client session and journal, in virtual time over a simulated network and disk.

#include <gtest/gtest.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/simulated/board_process.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::simulated {
namespace {

class SimulatedBoard : public testing::Test {
 protected:
  SimulatedBoard() {
    start();
    client_ = connect("alice", process_, *wires_);
    Relation goal = relation_from_datum(read_one("(relation goal ((n integer)) (key n) (durable))").value()).value();
    Relation seen = relation_from_datum(read_one("(relation seen ((n integer)) (key n))").value()).value();
    EXPECT_TRUE(await(client_->declare({goal, seen})).has_value());
  }

  void start() { ASSERT_TRUE(board_.start({.ahead = std::chrono::hours(24)}).has_value()); }

  std::unique_ptr<client::RemoteBoard> connect(const std::string& name, Process& process, wire::Transport& wires) {
    return client::RemoteBoard::connect(process, board_.address(), name, 5s, {}, wires).value();
  }

  template <class T>
  T await(Task<T> task) {
    std::optional<T> result;
    const auto run = [](Task<T> running, std::optional<T>& out) -> Task<void> { out = co_await running; };
    const Job job = process_.spawn(run(std::move(task), result));
    time_.run_until([&] { return job.done(); });
    return std::move(*result);
  }

  Result<Revision> tell(const std::string& fact) {
    Transaction transaction;
    transaction.tell(read_one(fact).value());
    return await(client_->transact(std::move(transaction)));
  }

  std::size_t facts(const std::string& pattern) {
    return board_.board()->store().ask(query_for(read_one(pattern).value()))->answers.size();
  }

  VirtualExecutor time_;
  Network network_{time_, Random(1), {}};
  SimulatedDisk disk_{Random(2)};
  BoardProcess board_{time_, network_, disk_, Random(3), "tcp://127.0.0.1:7000"};
  Process process_{time_, {.ahead = std::chrono::hours(25), .drift = 2e-4}};
  std::unique_ptr<wire::Transport> wires_ = network_.plug("alice", process_);
  std::unique_ptr<client::RemoteBoard> client_;
};

TEST_F(SimulatedBoard, WhatWasAnsweredAsDurableSurvivesAPowerCutAndTheRestGoes) {
  ASSERT_TRUE(tell("(goal 1)").has_value());
  ASSERT_TRUE(tell("(seen 1)").has_value());
  board_.cut_power();
  start();
  EXPECT_EQ(facts("(goal 1)"), 1U);
  EXPECT_EQ(facts("(seen 1)"), 0U);
  EXPECT_TRUE(tell("(goal 2)").has_value());
}

TEST_F(SimulatedBoard, AReplyThatIsLostAfterItsCommitIsGivenAgainAndNothingIsDoneTwice) {
  ASSERT_TRUE(tell("(goal 1)").has_value());
  const Revision before = board_.board()->store().revision();
  network_.lose_next_reply("alice");
  ASSERT_TRUE(tell("(goal 2)").has_value());
  EXPECT_EQ(network_.counts().lost_replies, 1U);
  EXPECT_EQ(board_.board()->store().revision(), before + 1);
}

TEST_F(SimulatedBoard, AClientWhoseConnectionIsLostGoesOnInItsSession) {
  for (int n = 0; n < 5; ++n) {
    network_.break_connections("alice");
    ASSERT_TRUE(tell("(goal " + std::to_string(n) + ")").has_value());
  }
  EXPECT_EQ(facts("(goal ?)"), 5U);
}

TEST_F(SimulatedBoard, AFullDiskRefusesWhatIsDurableUntilItHasSpaceAgain) {
  ASSERT_TRUE(tell("(goal 1)").has_value());
  disk_.fail(true);
  // The first one stands in memory and is in doubt; the next one is refused.
  EXPECT_FALSE(tell("(goal 2)").has_value());
  EXPECT_FALSE(tell("(goal 3)").has_value());
  EXPECT_TRUE(tell("(seen 1)").has_value());
  disk_.fail(false);
  time_.run_for(1s);
  EXPECT_TRUE(tell("(goal 4)").has_value());
}

TEST_F(SimulatedBoard, ASlowDiskTakesItsTime) {
  disk_.set_flush_time(300ms);
  const Time begun = time_.now();
  ASSERT_TRUE(tell("(goal 1)").has_value());
  EXPECT_GE(time_.now() - begun, 300ms);
}

TEST_F(SimulatedBoard, AProcessThatIsHeldUpDoesWhatWasDueWhenItGoesOn) {
  board_.process()->pause();
  time_.call_at(time_.now() + 1s, [&] { board_.process()->resume(); });
  const Time begun = time_.now();
  ASSERT_TRUE(tell("(goal 1)").has_value());
  EXPECT_GE(time_.now() - begun, 1s);
}

TEST_F(SimulatedBoard, AProcessEndsAtItsSuspensionPoint) {
  bool ended = false;
  const std::uint64_t last = board_.process()->steps() + 3;
  board_.process()->kill_at(last, [&] {
    EXPECT_EQ(board_.process()->steps(), last);
    ended = true;
    board_.kill();
  });
  EXPECT_FALSE(tell("(goal 1)").has_value());
  EXPECT_TRUE(ended);
}

TEST_F(SimulatedBoard, AProcessIsHeldUpAtItsSuspensionPoint) {
  Process& board = *board_.process();
  const std::uint64_t last = board.steps() + 3;
  board.hold_at(last, [&] { board.pause(); });
  time_.call_at(time_.now() + 1s, [&] {
    EXPECT_EQ(board.steps(), last);
    board.resume();
  });
  const Time begun = time_.now();
  ASSERT_TRUE(tell("(goal 1)").has_value());
  EXPECT_GE(time_.now() - begun, 1s);
}

}  // namespace
}  // namespace pizarra::simulated
