#pragma once

// Robot agents of the rows that time them, each in a process of its own, and what their clients share.
//
//   Child robot = Child::running([&](Pipe& parent) { be_a_simulated_robot(parent, board.address(), {"robot", 10}); });
//   Client client(board.address(), "bench");
//   wait_for_robots(client, {"robot"});

#include "agents/robot/robot_agent.hpp"
#include "tests/bench/blackboard/board_process.hpp"

namespace pizarra::bench {

struct RobotName {
  std::string name = "robot";
  double told_per_s = 10;
};

// A robot agent on the board, for as long as the process lives.
[[noreturn]] void be_a_robot(RealExecutor& executor, const std::string& address, const RobotName& robot,
                             arm::ArmDriver& arm, const arm::ArmModel& model);
// The simulated world's arm; says to the parent when its controller has braked.
[[noreturn]] void be_a_simulated_robot(Pipe& parent, const std::string& address, const RobotName& robot);

Datum form(const std::string& text);
Task<Result<Answer>> await_fact(Client& client, std::string pattern, Duration longest);
// Declares what clients of robots need, and waits until these are idle.
void wait_for_robots(Client& client, const std::vector<std::string>& names);
// Begins a motion; lets it run a while and tells a stop, and answers when that was told. go_on() takes it back.
void begin_turn(Client& client, const std::string& robot, std::uint64_t count);
double stop_turn(Client& client);
void go_on(Client& client, std::uint64_t count);

}  // namespace pizarra::bench
