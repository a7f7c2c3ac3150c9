#include "agents/coordinator/story.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "agents/coordinator/retried_commit.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

const Datum& any_event() {
  static const Datum pattern = list("event"_sym, "?seq"_sym, "?kind"_sym, "?sentence"_sym, "?detail"_sym);
  return pattern;
}

// The facts that fit, by the number that they are known under.
Task<std::vector<Datum>> in_order(Board& board, Executor& executor, Datum pattern) {
  const std::vector<Fact> facts = co_await facts_now(board, executor, std::move(pattern));
  std::vector<Datum> numbered;
  for (const Fact& fact : facts) numbered.push_back(fact.datum);
  std::ranges::sort(numbered, {}, [](const Datum& datum) { return datum[1].integer(); });
  co_return numbered;
}

}  // namespace

std::string goal_sentence(const Datum& goal) {
  std::string sentence = fmt::format("goal {}:", goal[1].integer());
  for (const Datum& fact : goal[2].items()) sentence += ' ' + write(fact);
  return sentence;
}

std::string outcome_sentence(const Datum& goal_state) {
  std::string sentence = fmt::format("goal {} is {}", goal_state[1].integer(), goal_state[2].text());
  if (!goal_state[3].is_form("fail")) return sentence;
  return sentence + ": " + describe(failure_from_datum(goal_state[3]));
}

Task<void> Story::resume() {
  const std::vector<Datum> events = co_await in_order(board_, executor_, any_event());
  if (events.empty()) co_return;
  oldest_ = events.front()[1].integer();
  next_ = events.back()[1].integer() + 1;
}

// An event that could not be told, or whose successor could not, leaves a gap: what is too old goes when it can.
void Story::add(Transaction& transaction, std::string_view kind, std::string_view sentence, const Datum& detail,
                std::vector<FactId> because) {
  const std::int64_t number = next_++;
  transaction.tell(list("event"_sym, number, Datum::symbol(kind), sentence, detail), std::move(because));
  for (std::int64_t old = oldest_; old <= number - kept; ++old) {
    transaction.retract(list("event"_sym, old, "?kind"_sym, "?sentence"_sym, "?detail"_sym));
  }
}

Task<Result<Revision>> Story::tell(std::string_view kind, std::string_view sentence, const Datum& detail,
                                   std::vector<FactId> because) {
  Transaction transaction;
  add(transaction, kind, sentence, detail, std::move(because));
  const std::int64_t oldest = std::max(oldest_, next_ - kept);
  const Result<Revision> told = co_await commit(board_, executor_, std::move(transaction));
  if (told) oldest_ = std::max(oldest_, oldest);
  co_return told;
}

// The newest goal, then what followed the newest difference under it (or all of it where nothing differed), and what
// is being done. The goal's own facts stand longer than the events that tell of it.
Task<std::vector<std::string>> Story::why() const {
  const Datum any = "?"_sym;
  const Datum a_goal = list("goal"_sym, any, any);
  const std::vector<Datum> goals = co_await in_order(board_, executor_, a_goal);
  std::vector<std::string> sentences;
  if (goals.empty()) {
    sentences.emplace_back("nothing was wanted yet");
    co_return sentences;
  }
  const Datum its_state = list("goal-state"_sym, goals.back()[1], any, any);
  const std::vector<Datum> states = co_await in_order(board_, executor_, its_state);
  const std::vector<Datum> events = co_await in_order(board_, executor_, any_event());
  std::size_t from = 0;
  std::optional<std::size_t> operation;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const std::string_view kind = events[i][2].text();
    const bool follows_difference = i > 0 && events[i - 1][2].is_symbol("difference");
    if (kind == "goal") from = i;
    if (kind == "difference" && !follows_difference) from = i;
    if (kind == "operation") operation = i;
  }
  sentences.push_back(goal_sentence(goals.back()));
  bool outcome_told = states.empty() || states.back()[2].is_symbol("running");
  for (std::size_t i = from; i < events.size(); ++i) {
    const std::string_view kind = events[i][2].text();
    const bool tells =
        kind == "difference" || kind == "plan" || kind == "result" || kind == "missing" || operation == i;
    if (tells) sentences.emplace_back(events[i][3].text());
    outcome_told = outcome_told || kind == "result";
  }
  if (!outcome_told) sentences.push_back(outcome_sentence(states.back()));
  co_return sentences;
}

}  // namespace pizarra::coordinator
