#pragma once

// A robot agent over a FakeArm on an in-memory board in virtual time, and whoever asks it.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <optional>

#include "agents/robot/robot_agent.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/kinematics.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/robot/fake_arm.hpp"

namespace pizarra::robot {

inline Datum form(std::string_view text) { return read_one(text).value(); }

// One life of the agent: destroying it is the agent's death.
class RobotLife {
 public:
  RobotLife(Executor& executor, memory::MemoryBoard& board, arm::ArmDriver& arm,
            const arm::ArmModel& model = arm::crs_f3(), RobotOptions options = {}, const std::string& name = "robot")
      : RobotLife(executor, board.view(name), arm, model, options, name) {}
  RobotLife(Executor& executor, std::unique_ptr<Board> board, arm::ArmDriver& arm,
            const arm::ArmModel& model = arm::crs_f3(), RobotOptions options = {}, const std::string& name = "robot")
      : board_(std::move(board)), agent_({name, "localhost", executor, *board_, Random(1)}, arm, model, options) {
    job_ = executor.spawn(live());
  }
  RobotAgent& agent() { return agent_; }
  std::optional<Result<void>> ended;

 private:
  Task<void> live() { ended = co_await agent_.run(); }
  std::unique_ptr<Board> board_;
  RobotAgent agent_;
  Job job_;
};

class Robot : public testing::Test {
 protected:
  void SetUp() override {
    begin();
    executor.run_for(1s);
  }
  void begin() { life.emplace(executor, board, arm); }

  // Asks without waiting; the answer to `id` is what reply() says later.
  std::string ask(std::string_view operation, std::string id = "", std::string_view robot = "robot") {
    if (id.empty()) id = fmt::format("r{}", ++asked);
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), Datum::symbol(robot), form(operation)));
    const Result<Revision> told = board.transact("user", request);
    EXPECT_TRUE(told) << operation;
    return id;
  }
  // What was answered, as text; empty while nothing was.
  std::string reply(const std::string& id) { return first(fmt::format("(reply {} ?answer)", id), 2); }
  // Asks and waits for the answer.
  std::string call(std::string_view operation) {
    const std::string id = ask(operation);
    const Time deadline = executor.now() + 120s;
    executor.run_until([&] { return !reply(id).empty() || executor.now() > deadline; });
    return reply(id);
  }
  // The symbol of the failure that was answered.
  std::string refusal(std::string_view operation) {
    const std::string answer = call(operation);
    const Datum datum = form(answer.empty() ? "()" : answer);
    return datum.is_form("fail") ? std::string(datum[1].text()) : answer;
  }
  // The element at `index` of the first fact that fits, as text.
  std::string first(std::string_view pattern, std::size_t index) {
    const std::optional<Datum> fact = fact_like(pattern);
    return fact ? write((*fact)[index]) : "";
  }
  std::optional<Datum> fact_like(std::string_view pattern) {
    const Result<Answers> answers = board.ask(query_from_datum(form(pattern)).value());
    if (!answers || answers->answers.empty()) return std::nullopt;
    return answers->answers.front().facts.front().datum;
  }
  std::string fact(std::string_view pattern) {
    const std::optional<Datum> found = fact_like(pattern);
    return found ? write(*found) : "";
  }
  Eigen::Vector3d point() const { return arm::forward(arm::crs_f3(), arm.at()).translation(); }

  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  FakeArm arm{executor};
  std::optional<RobotLife> life;
  int asked = 0;
};

}  // namespace pizarra::robot
