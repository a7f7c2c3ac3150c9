#include "agents/coordinator/pursue/differences.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ranges>
#include <set>

#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

bool share_an_object(const Datum& a, const Datum& b) {
  return std::ranges::any_of(a.items().subspan(1), [&b](const Datum& object) {
    return std::ranges::find(b.items().subspan(1), object) != b.items().end();
  });
}

}  // namespace

// Which fact, seen in which frame, broke which expectation: what is believed instead is what came with that frame about
// the same objects.
Task<void> Differences::tell(std::vector<Datum> lost, std::string expected_by) {
  std::set<FactId> because;
  std::string sentence;
  for (const Datum& literal : lost) {
    const Datum& fact = literal.is_form("not") ? literal[1] : literal;
    const std::int64_t frame = surroundings_.changed_in(fact).frame;
    std::string instead;
    for (const Datum& belief : surroundings_.beliefs()) {
      const Beliefs::Evidence came = surroundings_.changed_in(belief);
      if (frame == 0 || came.frame < frame || !share_an_object(fact, belief)) continue;
      instead += (instead.empty() ? "" : " ") + write(belief);
      because.insert(came.look);
    }
    if (!sentence.empty()) sentence += "; ";
    sentence += fmt::format("{} does not hold", write(literal));
    if (frame != 0) sentence += fmt::format(" since frame {}", frame);
    if (!instead.empty()) sentence += fmt::format(", which shows {}", instead);
  }
  sentence += fmt::format("; it was expected by {}", expected_by);
  std::vector<FactId> looks(because.begin(), because.end());
  co_await story_.tell("difference", sentence, Datum::list(lost), std::move(looks));
}

Task<void> Differences::tell_unexpected(NextOperation expected, std::size_t next) {
  if (next > expected.index) {
    std::string skipped;
    std::vector<Datum> operations;
    for (const GroundOperation& operation : expected.rest | std::views::take(next - expected.index)) {
      skipped += ' ' + write(operation.name);
      operations.push_back(operation.name);
    }
    const std::string sentence = fmt::format("somebody else did{}: it is skipped", skipped);
    co_await story_.tell("difference", sentence, Datum::list(operations));
    co_return;
  }
  std::vector<Datum> lost = missing_from(surroundings_.beliefs(), expected.needed);
  const std::string expected_by = expected.rest.empty() ? std::string("the goal") : write(expected.rest.front().name);
  co_await tell(std::move(lost), expected_by);
}

Task<void> Differences::tell_still_serves(std::int64_t goal, NextOperation next) {
  std::vector<Datum> rest;
  std::string told;
  for (const GroundOperation& operation : next.rest) {
    rest.push_back(operation.name);
    told += ' ' + write(operation.name);
  }
  const std::string sentence =
      rest.empty() ? "nothing is left to do of the plan in hand"
                   : fmt::format("the plan in hand still serves, from operation {} on:{}", next.index + 1, told);
  const Datum detail = list("plan"_sym, goal, Datum::list(rest));
  co_await story_.tell("plan", sentence, detail);
}

}  // namespace pizarra::coordinator
