#pragma once

// The options of `demo`, and whether they go together: an option that would have no effect is refused, not ignored.
//
//   DemoChoices choices;
//   choices.given = {"--random", "--journal"};      // the options that were typed
//   Result<void> sound = check_choices(choices);

#include <cstdint>
#include <set>
#include <string>

#include "lisp/result.hpp"

namespace pizarra::programs {

struct DemoChoices {
  std::string cell;
  std::string goal;
  std::string domain;
  std::string arm;
  std::uint64_t seed = 1;
  std::string journal;
  std::string film;
  std::string picture = "out/demo.png";
  bool realtime = false;
  bool json = false;
  bool random = false;
  std::uint64_t seeds = 1;
  std::uint64_t first_seed = 1;
  unsigned jobs = 0;            // 0: one a core
  std::set<std::string> given;  // names of the options that were typed

  bool has(const std::string& option) const { return given.contains(option); }
  // Many seeds, a line each, and not one story told in full.
  bool many() const { return has("--seeds"); }
};

// Failure bad-option, which names the option.
Result<void> check_choices(const DemoChoices& choices);

}  // namespace pizarra::programs
