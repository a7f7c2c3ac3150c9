#include "agents/coordinator/story.hpp"

#include <algorithm>
#include <optional>

#include "agents/coordinator/telling.hpp"

namespace pizarra {

namespace {

const Datum& any_event() {
  static const Datum pattern = list("event"_sym, "?seq"_sym, "?kind"_sym, "?sentence"_sym, "?detail"_sym);
  return pattern;
}

Task<std::vector<Datum>> events_in_order(Board& board, Executor& executor) {
  const Datum pattern = any_event();
  const std::vector<Fact> facts = co_await facts_now(board, executor, pattern);
  std::vector<Datum> events;
  for (const Fact& fact : facts) events.push_back(fact.datum);
  std::ranges::sort(events, {}, [](const Datum& event) { return event[1].integer(); });
  co_return events;
}

}  // namespace

Task<void> Story::resume() {
  const std::vector<Datum> events = co_await events_in_order(board_, executor_);
  if (!events.empty()) next_ = events.back()[1].integer() + 1;
}

Task<Result<Revision>> Story::tell(std::string_view kind, std::string_view sentence, const Datum& detail,
                                   std::vector<FactId> because) {
  const std::int64_t number = next_++;
  Transaction transaction;
  transaction.tell(list("event"_sym, number, Datum::symbol(kind), sentence, detail), std::move(because));
  if (number > kept) {
    transaction.retract(list("event"_sym, number - kept, "?kind"_sym, "?sentence"_sym, "?detail"_sym));
  }
  return commit(board_, executor_, std::move(transaction));
}

// The newest goal, then what followed the newest difference under it (or all of it where nothing differed), and what
// is being done.
Task<std::vector<std::string>> Story::why() const {
  const std::vector<Datum> events = co_await events_in_order(board_, executor_);
  std::size_t from = 0;
  std::optional<std::size_t> goal;
  std::optional<std::size_t> operation;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const std::string_view kind = events[i][2].text();
    const bool follows_difference = i > 0 && events[i - 1][2].is_symbol("difference");
    if (kind == "goal") goal = from = i;
    if (kind == "difference" && !follows_difference) from = i;
    if (kind == "operation") operation = i;
  }
  std::vector<std::string> sentences;
  if (goal) sentences.emplace_back(events[*goal][3].text());
  for (std::size_t i = from; i < events.size(); ++i) {
    const std::string_view kind = events[i][2].text();
    const bool tells = kind == "difference" || kind == "plan" || kind == "result" || operation == i;
    if (tells) sentences.emplace_back(events[i][3].text());
  }
  if (sentences.empty()) sentences.emplace_back("nothing was wanted yet");
  co_return sentences;
}

}  // namespace pizarra
