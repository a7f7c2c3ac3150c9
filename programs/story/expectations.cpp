#include "programs/story/expectations.hpp"

#include <fmt/format.h>

#include "agents/launcher/readiness.hpp"
#include "lisp/writer.hpp"

namespace pizarra::story {

Expectations::Expectations(const forms::Scenario& scenario, Board& board, Executor& executor)
    : scenario_(scenario), board_(board), executor_(executor) {
  for (const Datum& pattern : scenario.expect_seen) expected_.push_back({pattern, true});
  for (const Datum& pattern : scenario.expect_never) expected_.push_back({pattern, false});
}

void Expectations::begin() {
  for (Expected& expected : expected_) jobs_.push_back(executor_.spawn(watch_for(expected)));
}

Task<void> Expectations::watch_for(Expected& expected) {
  Query query = query_from_datum(expected.pattern).value();
  const Time never = executor_.now() + launcher::for_ever;
  const Result<Answer> come = co_await launcher::await_when_declared(board_, executor_, std::move(query), never);
  if (come) expected.came = true;
}

std::vector<std::string> Expectations::unmet(const DirectorReport& report) const {
  std::vector<std::string> unmet;
  for (const Expected& expected : expected_) {
    if (expected.came == expected.wanted) continue;
    unmet.push_back((expected.wanted ? "never came: " : "came: ") + write(expected.pattern));
  }
  if (scenario_.expect_reached && report.outcome != "reached") {
    const std::string why = report.refusal ? ": " + describe(*report.refusal) : "";
    unmet.push_back(fmt::format("expected the goal to be reached, and it ended as {}{}", report.outcome, why));
  } else if (scenario_.expect_reached && !report.truth_holds) {
    unmet.push_back("the cell says reached, and in the world it is not so");
  } else if (!scenario_.expect_reached && report.outcome != "refused") {
    unmet.push_back(fmt::format("expected the goal to be refused, and it ended as {}", report.outcome));
  } else if (!scenario_.refusal.empty() && report.refusal->symbol != scenario_.refusal) {
    unmet.push_back(fmt::format("expected the refusal {}, and it was {}", scenario_.refusal, report.refusal->symbol));
  }
  return unmet;
}

}  // namespace pizarra::story
