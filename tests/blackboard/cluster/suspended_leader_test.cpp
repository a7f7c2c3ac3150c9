// A machine that is suspended stops its own clock, and the rest of the cell goes on: its board must know when it wakes.

#include <gtest/gtest.h>

#include "blackboard/cluster/log_leader.hpp"
#include "blackboard/time/uptime.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys blocks_keys("blocks");

class SuspendedLeader : public testing::Test {
 protected:
  SuspendedLeader() {
    etcd_.trouble = 0;
    EXPECT_EQ(standby_->step([this] { return executor_.now(); }), true);
    leader_.emplace(executor_, needs(), blocks_keys, standby_, Duration::zero());
    confirming_ = executor_.spawn(leader_->confirm());
    executor_.run_for(2 * confirms_every);
  }
  LogLeader::Needs needs() {
    return {.connect = [this] { return std::shared_ptr<KeyValues>(client_); },
            .nonce = [] { return std::uint64_t{1}; },
            .uptime = [this] { return executor_.now().time_since_epoch() + asleep_; },
            .on_log = [](const Result<void>&) {},
            .on_upkeep = [](const Result<void>&) {},
            .on_end = [] {}};
  }

  EtcdModel etcd_{1};
  const std::shared_ptr<ModelClient> client_ = std::make_shared<ModelClient>(etcd_);
  VirtualExecutor executor_;
  Duration asleep_{};
  const std::shared_ptr<Standby> standby_ = std::make_shared<Standby>(*client_, blocks_keys, "a", 1, executor_.now());
  std::optional<LogLeader> leader_;
  Job confirming_;
};

TEST_F(SuspendedLeader, AnswersNothingWhenItWakesUntilItsLeadIsConfirmed) {
  ASSERT_TRUE(leader_->may_answer());
  asleep_ = std::chrono::minutes(10);
  EXPECT_FALSE(leader_->may_answer());
  EXPECT_GE(*leader_->age(), std::chrono::minutes(10));
  executor_.run_for(2 * confirms_every);
  EXPECT_TRUE(leader_->may_answer());
  EXPECT_LT(*leader_->age(), answers_for);
}

TEST_F(SuspendedLeader, ThatWasReplacedMeanwhileAnswersNothingAnyMore) {
  Standby other(*client_, blocks_keys, "b", 2, executor_.now());
  other.suspect();
  asleep_ = std::chrono::minutes(10);
  const auto now = [this] { return executor_.now(); };
  bool won = other.step(now).value();
  if (!won) {
    other.suspect();
    won = other.step(now).value();
  }
  ASSERT_TRUE(won);
  EXPECT_FALSE(leader_->may_answer());
  executor_.run_for(2 * confirms_every);
  EXPECT_FALSE(leader_->may_answer());
  EXPECT_EQ(leader_->ended()->symbol, "deposed");
}

TEST(Uptime, OnlyGrowsAndIsThatOfTheMachine) {
  const Duration before = uptime();
  timespec machine{};
  ASSERT_EQ(clock_gettime(CLOCK_BOOTTIME, &machine), 0);
  const Duration after = uptime() + 1ms;
  const Duration between = std::chrono::seconds(machine.tv_sec) + Duration(machine.tv_nsec / 1000);
  EXPECT_LE(before, between);
  EXPECT_LE(between, after);
}

}  // namespace
}  // namespace pizarra::cluster
