#pragma once

// Hold-ups stop the cell and say nothing of its goal: somebody's stop, the pendant, a line to board or arm that was
// silent, an arm that has an alarm, a full disk. The pursuit waits until one ends, and then begins with a look.
//
//   HoldUp hold_up(context, story, interruption);
//   if (is_hold_up(why)) done = co_await hold_up.await_end(why);      // interrupted, or it lasts too long
//   hold_up.went_on();                                                 // an operation was done
//
// A stop is waited for as long as it stands, any other hold-up ten minutes at most. It is tried again after a second at
// first, and after eight in the end.

#include <optional>

#include "agents/coordinator/plan/interruption.hpp"
#include "agents/coordinator/story.hpp"
#include "agents/runtime/agent.hpp"

namespace pizarra::coordinator {

bool is_hold_up(const Failure& failure);

class HoldUp {
 public:
  HoldUp(runtime::AgentContext& context, Story& story, const Interruption& interruption)
      : context_(context), story_(story), interruption_(interruption) {}

  // Failures: interrupted, and what it waited for in vain.
  Task<Result<void>> await_end(Failure why);
  void went_on();

 private:
  Task<void> await_no_stop();
  Task<void> pause(Duration length);

  runtime::AgentContext& context_;
  Story& story_;
  const Interruption& interruption_;
  std::string told_;           // the reason that the story has
  std::optional<Time> since_;  // nothing was done
  Duration pause_{};
};

}  // namespace pizarra::coordinator
