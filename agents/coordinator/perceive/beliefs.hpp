#pragma once

// Beliefs, made of perceptions: a fact must be perceived, or be missing, for a few looks in a row before it counts. A
// hand that passes before the camera changes nothing.
//
//   Beliefs beliefs(3);
//   Beliefs::Change change = beliefs.perceive(facts, {frame, look.id});     // once a look
//   for (const Datum& fact : change.gone) ...

#include <map>
#include <vector>

#include "agents/coordinator/plan/ground_operation.hpp"
#include "blackboard/fact.hpp"

namespace pizarra::coordinator {

class Beliefs {
 public:
  struct Change {
    std::vector<Datum> come;
    std::vector<Datum> gone;
    bool any() const { return !come.empty() || !gone.empty(); }
  };
  // The look that showed something: its frame, and its fact on the board.
  struct Evidence {
    std::int64_t frame = 0;
    FactId look = 0;
  };

  // `patience`: for how many looks in a row a difference must be perceived, at least 1.
  explicit Beliefs(int patience) : patience_(patience) {}

  Change perceive(const Facts& perceived, Evidence shown_by);
  const Facts& facts() const { return believed_; }
  // The look in which a fact came to be believed last, or ceased to be; frame 0 if it never did.
  Evidence changed_in(const Datum& fact) const;
  // Whether the newest look said just what is believed.
  bool settled() const { return doubts_.empty(); }

 private:
  int patience_;
  Facts believed_;
  std::map<Datum, int> doubts_;  // facts whose truth was perceived to differ, and how often in a row
  std::map<Datum, Evidence> changed_in_;
};

}  // namespace pizarra::coordinator
