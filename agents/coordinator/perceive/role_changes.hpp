#pragma once

// Follows changes of roles while the coordinator works. It follows the facts of the agent that now plays the role,
// tells it to track, and says so in the story.
//
//   RoleChanges changes(context, roles, surroundings, eyes, story, service);
//   Job following = executor.spawn(changes.follow());

#include "agents/coordinator/perceive/eyes.hpp"
#include "agents/runtime/patterns/send.hpp"

namespace pizarra::coordinator {

class RoleChanges {
 public:
  // All outlive it.
  RoleChanges(runtime::AgentContext& context, runtime::Roles& roles, Surroundings& surroundings, Eyes& eyes,
              Story& story, const runtime::Service& service)
      : context_(context),
        roles_(roles),
        surroundings_(surroundings),
        eyes_(eyes),
        story_(story),
        sender_(context, service) {}

  // Until destroyed.
  Task<void> follow();

 private:
  Task<void> say(const char* role, const std::string& before);
  Task<void> change_eyes(std::string before);
  Task<void> wake_eyes(std::string before);

  runtime::AgentContext& context_;
  runtime::Roles& roles_;
  Surroundings& surroundings_;
  Eyes& eyes_;
  Story& story_;
  runtime::Sender sender_;
  Job waking_;
};

}  // namespace pizarra::coordinator
