#pragma once

// The scripted person: clicks on each object in the camera's image and names it, as a user would at the console.
//
// It has eyes, which is the device link's `where-seen`, and asks like any user: the arm to show its end effector,
// the eyes to connect and to learn: those that play its roles `robot` and `eyes`. Objects that these eyes know already
// are not taught again, so a restarted person goes on.
//
//   PersonAgent person(context, link, {"circle", "triangle"});
//   Job job = executor.spawn(...person.run()...);
//
// It tells (person STATE DETAIL): `teaching` with the object's name in hand, `done` with the names, or `failed` with a
// failure form. It offers (teach "name"), for what comes into the cell later.

#include <string>
#include <vector>

#include "agents/runtime/roles.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::person {

class PersonAgent : public runtime::Agent {
 public:
  // The link outlives it.
  PersonAgent(runtime::AgentContext context, simulation::Link& link, std::vector<std::string> names);
  Task<Result<void>> run() override;

 private:
  Task<void> accept(std::string name);
  Task<void> teach_all();
  Task<Result<void>> teach_cell();
  Task<Result<void>> teach(std::string name);
  Task<Result<void>> teach_once(std::string name);
  Task<Result<Datum>> ask_eyes(Datum operation);
  Task<Result<void>> move_arm(Datum operation);
  Task<Result<void>> show_end_effector();
  Task<Result<void>> lower_arm();
  Task<Result<bool>> any_fact(Datum pattern);
  Task<Result<bool>> known(std::string name);
  Task<bool> renamed(Failure why);
  Task<Result<Datum>> serve(Datum operation);
  Task<void> say(Datum state, Datum detail);

  runtime::AgentContext context_;
  simulation::Link& link_;
  std::vector<std::string> names_;
  runtime::Service service_;
  runtime::Caller caller_;
  runtime::Roles roles_;
  // How often it has lowered the arm since that was ready: to be seen, and to be learned.
  int steps_below_ready_ = 0;
};

}  // namespace pizarra::person
