#pragma once

// What a client asks of the eyes.
//
//   VisionOperations operations(parts);
//   Result<Datum> answer = co_await operations.handle(request);      // in the client's turn; what stands after `ok`

#include "agents/vision/agent/vision_parts.hpp"

namespace pizarra::vision {

class VisionOperations {
 public:
  explicit VisionOperations(VisionParts& eyes) : eyes_(eyes) {}

  Task<Result<Datum>> handle(Fact request);

 private:
  struct Asked {
    std::string client;
    Datum operation;   // (WORD ARGUMENT ...)
    std::string name;  // its last argument, of those that take one
    Time came;         // what is looked at for it was captured later
  };
  struct Operation {
    std::string_view word;
    std::optional<TurnQueue::Kind> turn;  // which it waits for; nothing: it is done at once
    Task<Result<Datum>> (VisionOperations::*run)(Asked);
  };
  static const Operation& operation_called(std::string_view word);
  // What they answer stands after `ok`.
  Task<Result<Datum>> learn(Asked asked);
  Task<Result<Datum>> find(Asked asked);
  Task<Result<Datum>> track(Asked asked);
  Task<Result<Datum>> end_track(Asked asked);
  Task<Result<Datum>> get_objects(Asked);
  Task<Result<Datum>> connect(Asked asked);
  Task<Result<Datum>> disconnect(Asked asked);
  Task<Result<Datum>> keep_modes(Asked asked);
  Task<Result<Datum>> accept(Asked asked) { return eyes_.known.accept(asked.client, asked.name); }
  Task<Result<Datum>> reject(Asked asked) { return eyes_.known.reject(asked.client, asked.name); }
  Task<Result<Datum>> forget(Asked asked);
  Task<Result<Datum>> rename(Asked asked);
  Task<Result<Datum>> learn_from(Asked asked);
  Task<Result<Datum>> search_in(Asked asked);
  Task<Result<Datum>> search_everywhere(Asked asked);
  Task<Result<Datum>> look_at_most(Asked asked);
  Task<Result<Datum>> look_always(Asked asked);
  Task<Result<Datum>> define_body(Asked asked) { return eyes_.bodies.define(asked.operation[1], asked.name); }
  Task<Result<Datum>> forget_body(Asked asked) { return eyes_.bodies.forget(asked.name); }
  // What is tracked for a name: an object, or those of a body that are known; and the end-effector with them.
  Result<std::vector<const LearnedObject*>> meant_by(const std::string& name) const;

  VisionParts& eyes_;
};

}  // namespace pizarra::vision
