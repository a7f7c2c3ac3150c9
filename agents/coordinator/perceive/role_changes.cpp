#include "agents/coordinator/perceive/role_changes.hpp"

#include <fmt/format.h>

namespace pizarra::coordinator {

Task<void> RoleChanges::follow() {
  std::string eyes = roles_.holder("eyes").server, robot = roles_.holder("robot").server;
  std::string planner = roles_.holder("planner").server;
  surroundings_.follow_eyes(eyes);
  surroundings_.follow_robot(robot);
  while (true) {
    co_await roles_.changed().wait();
    if (roles_.holder("eyes").server != eyes) {
      const std::string before = std::exchange(eyes, roles_.holder("eyes").server);
      surroundings_.follow_eyes(eyes);
      co_await say("eyes", before);
      co_await change_eyes(before);
    }
    if (roles_.holder("robot").server != robot) {
      const std::string before = std::exchange(robot, roles_.holder("robot").server);
      surroundings_.follow_robot(robot);
      co_await say("robot", before);
    }
    if (roles_.holder("planner").server != planner) {
      const std::string before = std::exchange(planner, roles_.holder("planner").server);
      co_await say("planner", before);
    }
  }
}

Task<void> RoleChanges::say(const char* role, const std::string& before) {
  const runtime::Holder holder = roles_.holder(role);
  const bool stands_in = holder.state == "stands-in";
  const std::string sentence = stands_in
                                   ? fmt::format("{} stands in as {}: {} is not there", holder.server, role, before)
                                   : fmt::format("{} serves as {}, no longer {}", holder.server, role, before);
  const Datum detail = list("holder"_sym, Datum::symbol(context_.name), Datum::symbol(role),
                            Datum::symbol(holder.server), Datum::symbol(holder.state));
  co_await story_.tell("agent", sentence, detail);
}

// Eyes that stood in, or were wired before, need not go on looking for this client. Nobody waits for their answer.
Task<void> RoleChanges::change_eyes(std::string before) {
  if (roles_.holder("eyes").state == "wired") {
    const Datum end = list("end-track"_sym);
    [[maybe_unused]] const Result<void> sent = co_await sender_.send(before, end);
  }
  waking_ = context_.executor.spawn(wake_eyes(std::move(before)));
}

Task<void> RoleChanges::wake_eyes(std::string before) {
  const Result<void> taken = co_await eyes_.take_over(std::move(before));
  if (taken) co_return;
  const Datum why = failure_to_datum(taken.error());
  const std::string sentence = "the new eyes do not track: " + taken.error().sentence;
  co_await story_.tell("agent", sentence, why);
}

}  // namespace pizarra::coordinator
