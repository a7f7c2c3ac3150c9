#pragma once

// The vision agent as the coordinator uses it: which objects there are, where, and that they are tracked.

#include "agents/coordinator/event_log.hpp"
#include "agents/coordinator/perceive/presence.hpp"
#include "agents/coordinator/perceive/surroundings.hpp"

namespace pizarra::coordinator {

class Eyes {
 public:
  Eyes(runtime::AgentContext& context, const CoordinatorOptions& options, Presence& presence,
       Surroundings& surroundings, Story& story, runtime::Caller& caller)
      : context_(context),
        options_(options),
        presence_(presence),
        surroundings_(surroundings),
        story_(story),
        caller_(caller) {}

  // Step a: the objects that vision has learned, without the end effector, as they are spelled there. A goal asks once.
  Task<Result<std::vector<std::string>>> objects();
  // Step b: whether the object is found in the image now.
  Task<Result<bool>> find(std::string name);
  // Step g: the end effector and the objects that were asked for last are tracked, and looks come in. Does nothing
  // where they do.
  Task<Result<void>> track();
  // Looks that began after this call: the next one may have been under way. Tracks again where no looks come, as after
  // a restart of vision. Failure `absent` when that does not help for long.
  Task<Result<void>> fresh_look();

 private:
  Task<Result<Datum>> ask(Datum operation);

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  Presence& presence_;
  Surroundings& surroundings_;
  Story& story_;
  runtime::Caller& caller_;
  std::optional<std::vector<std::string>> known_;  // the objects; none before they were asked for
};

}  // namespace pizarra::coordinator
