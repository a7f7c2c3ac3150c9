#include "agents/planner/explanation/no_plan.hpp"

#include <cassert>
#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

std::string in_words(const std::vector<Datum>& facts) {
  std::string words;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    if (i > 0) words += i + 1 == facts.size() ? " and " : ", ";
    words += write(facts[i]);
  }
  return words;
}

}  // namespace

Failure explain(const Problem& problem, const Outcome& outcome) {
  assert(outcome.kind != Outcome::Kind::plan);
  if (outcome.kind == Outcome::Kind::cancelled) return {"cancelled", "another plan is wanted now", {}, {}};
  if (outcome.kind == Outcome::Kind::gave_up) {
    return {"gave-up", fmt::format("no plan was found within {}; there may be one", outcome.spent), {}, {}};
  }
  std::vector<Datum> culprits;
  for (const std::size_t fact : outcome.culprits) culprits.push_back(problem.facts[fact]);
  const std::string sentence = fmt::format("no plan exists: {} can never hold{} from here", in_words(culprits),
                                           culprits.size() > 1 ? " together" : "");
  return {"no-plan", sentence, Datum::list(std::move(culprits)), {}};
}

}  // namespace pizarra::planner
