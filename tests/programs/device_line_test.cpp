#include "programs/chaos/device_line.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/virtual_executor.hpp"

namespace pizarra::chaos {
namespace {

constexpr Duration answer_time = 1s;
constexpr Duration until_it_has_braked = 300ms;
constexpr Duration first_part = 100ms;

// An arm on its way, of which nobody asks anything more.
class SilentLine : public testing::Test {
 protected:
  SilentLine() { world_.world = std::make_unique<simulation::World>(world_.process, config_); }

  simulation::Message ask(Datum request) {
    std::optional<Result<simulation::Message>> answer;
    const Job job = client_.spawn(call(std::move(request), answer));
    time_.run_until([&] { return job.done(); });
    return answer->value();
  }
  void begin_long_motion() {
    ask(list("arm"_sym, "take-control"_sym));
    std::vector<Datum> target;
    for (const double angle : config_.arm.ready) target.push_back(Datum::real(angle));
    target.front() = Datum::real(config_.arm.ready[0] + 90);
    ask(list("arm"_sym, "move"_sym, 0.5, Datum::list(std::move(target))));
  }
  // The simulated arm itself, without its controller.
  bool moves_after(Duration length) {
    bool moves = false;
    const Job job = client_.spawn(look_after(length, moves));
    time_.run_until([&] { return job.done(); });
    return moves;
  }

  VirtualExecutor time_;
  simulation::WorldConfig config_;
  WorldProcess world_{time_, {}, ""};
  simulated::Process client_{time_, {}};
  DeviceLine line_{"robot", client_, world_};

 private:
  Task<void> call(Datum request, std::optional<Result<simulation::Message>>& answer) {
    answer = co_await line_.call(std::move(request), answer_time);
  }
  Task<void> look_after(Duration length, bool& moves) {
    co_await sleep(client_, length);
    const Datum read = list("arm"_sym, "read"_sym);
    const Result<simulation::Message> reading = co_await world_.world->handle(read);
    moves = reading->head[1].is_symbol("yes");
  }
};

TEST_F(SilentLine, AControllerWithASilenceLimitStopsItsArm) {
  world_.silence_limit = 200ms;
  begin_long_motion();
  EXPECT_TRUE(moves_after(first_part));
  EXPECT_FALSE(moves_after(until_it_has_braked));
}

TEST_F(SilentLine, AControllerWithoutOneMovesOn) {
  begin_long_motion();
  EXPECT_TRUE(moves_after(first_part));
  EXPECT_TRUE(moves_after(until_it_has_braked));
}

TEST_F(SilentLine, WhatIsAskedBreaksTheSilence) {
  world_.silence_limit = 200ms;
  begin_long_motion();
  for (int asked = 0; asked < 4; ++asked) {
    EXPECT_TRUE(moves_after(first_part));
    ask(list("arm"_sym, "read"_sym));
  }
}

TEST_F(SilentLine, AMotionThatTheControllerTookIsTold) {
  std::vector<Datum> begun;
  world_.on_motion = [&](const Datum& motion) { begun.push_back(motion); };
  begin_long_motion();
  ask(list("arm"_sym, "gripper"_sym, 40.0));
  ASSERT_EQ(begun.size(), 2U);
  EXPECT_TRUE(begun[0][1].is_symbol("move"));
  EXPECT_TRUE(begun[1][1].is_symbol("gripper"));
}

}  // namespace
}  // namespace pizarra::chaos
