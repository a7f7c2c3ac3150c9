#pragma once

// What is believed of what is perceived: a fact must be perceived, or be missing, for a few looks in a row before it
// counts. A hand that passes before the camera changes nothing.
//
//   Beliefs beliefs(3);
//   Beliefs::Change change = beliefs.perceive(facts);     // once a look
//   for (const Datum& fact : change.gone) ...

#include <map>
#include <vector>

#include "agents/coordinator/plan/triangle_table.hpp"

namespace pizarra::coordinator {

class Beliefs {
 public:
  struct Change {
    std::vector<Datum> come;
    std::vector<Datum> gone;
    bool any() const { return !come.empty() || !gone.empty(); }
  };

  // `patience`: for how many looks in a row a difference must be perceived, at least 1.
  explicit Beliefs(int patience) : patience_(patience) {}

  Change perceive(const Facts& perceived);
  const Facts& facts() const { return believed_; }
  // Whether the newest look said just what is believed.
  bool settled() const { return doubts_.empty(); }

 private:
  int patience_;
  Facts believed_;
  std::map<Datum, int> doubts_;  // facts whose truth was perceived to differ, and how often in a row
};

}  // namespace pizarra::coordinator
