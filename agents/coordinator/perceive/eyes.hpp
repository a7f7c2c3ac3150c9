#pragma once

// Whoever plays the eyes, as the coordinator uses them: which objects there are, where, and that they are tracked.
//
//   Result<std::vector<std::string>> names = co_await eyes.objects();
//   Result<void> tracked = co_await eyes.track();
//   Result<void> looked = co_await eyes.fresh_look();      // then surroundings.scene() has it

#include "agents/coordinator/perceive/surroundings.hpp"
#include "agents/coordinator/story.hpp"
#include "agents/runtime/roles.hpp"

namespace pizarra::coordinator {

class Eyes {
 public:
  Eyes(runtime::AgentContext& context, const CoordinatorOptions& options, runtime::Roles& roles,
       runtime::Caller& caller, Surroundings& surroundings, Story& story)
      : context_(context),
        options_(options),
        roles_(roles),
        caller_(caller),
        surroundings_(surroundings),
        story_(story) {}

  // Step a: the objects that vision has learned, without the end effector, as they are spelled there. A goal asks once.
  Task<Result<std::vector<std::string>>> objects();
  // Whether it was one of them when that was asked last.
  bool knows(const std::string& name) const;
  // Step b: whether the object is found in the image now.
  Task<Result<bool>> find(std::string name);
  // Step g: the end effector and the objects that were asked for last are tracked, and looks come in that tell of each.
  // Does nothing where they do.
  Task<Result<void>> track();
  // Looks that began after this call: the next one may have been under way. Tracks again where no looks come, as after
  // a restart of vision. Failure `absent` when that does not help for long.
  Task<Result<void>> fresh_look() { return await_look(&Surroundings::second_look_after); }
  // The same, as soon as a look shows the arm as it rests.
  Task<Result<void>> look_at_rest() { return await_look(&Surroundings::look_at_rest_after); }
  // After others have become the eyes: they learn what those before knew, and track what was tracked.
  Task<Result<void>> take_over(std::string before);

 private:
  using Wait = Task<bool> (Surroundings::*)(std::uint64_t looks, Time deadline);
  Task<Result<void>> await_look(Wait wait);
  Failure nothing_shown() const;
  Task<Result<void>> look_again();
  bool tracks_all() const;
  Task<Result<void>> begin_tracking();
  Task<Result<Datum>> ask(Datum operation);
  // The reply's text, as data.
  Task<Result<Datum>> answer_to(Datum operation);

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  runtime::Roles& roles_;
  runtime::Caller& caller_;
  Surroundings& surroundings_;
  Story& story_;
  std::optional<std::vector<std::string>> known_;  // the objects; none before they were asked for
};

}  // namespace pizarra::coordinator
