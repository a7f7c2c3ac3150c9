#include "programs/story/director_report.hpp"

#include <algorithm>
#include <array>

namespace pizarra::story {

bool DirectorReport::refused_correctly() const {
  static constexpr std::array<std::string_view, 4> reasons{"no-plan", "missing-object", "unknown-object",
                                                           "contradictory"};
  const bool for_a_reason =
      outcome == "refused" && refusal && std::ranges::find(reasons, refusal->symbol) != reasons.end();
  return for_a_reason && (!possible || blind);
}

}  // namespace pizarra::story
