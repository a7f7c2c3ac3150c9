#include "programs/commands/cell_sight.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>

#include "agents/runtime/declared.hpp"
#include "lisp/writer.hpp"

namespace pizarra::programs {

namespace {

Datum any_fact(std::string_view relation, std::size_t arguments) {
  std::vector<Datum> items{Datum::symbol(relation)};
  items.resize(1 + arguments, "?"_sym);
  return Datum::list(std::move(items));
}

// Of the fact with the highest number: (goal N (FORM ...)), (goal-state N STATE DETAIL).
const Datum* newest_of(const std::vector<Fact>& facts) {
  const auto found = std::ranges::max_element(facts, {}, [](const Fact& fact) { return fact.datum[1].integer(); });
  return found == facts.end() ? nullptr : &found->datum;
}

std::string goal_line(const std::vector<Fact>& goals, const std::vector<Fact>& states) {
  const Datum* const state = newest_of(states);
  if (state == nullptr) return "";
  std::string text = fmt::format("{} {}", (*state)[1].integer(), (*state)[2].text());
  const auto goal = std::ranges::find(goals, (*state)[1], [](const Fact& fact) { return fact.datum[1]; });
  if (goal == goals.end()) return text;
  for (const Datum& form : goal->datum[2].items()) text += " " + write(form);
  return text;
}

// (arm ROBOT STATE ACTION)
std::string arm_line(const Datum& arm) {
  const bool says_why = arm[2].is_symbol("fault") || arm[2].is_symbol("stopped");
  return fmt::format("{} {}{}", arm[1].text(), arm[2].text(), says_why ? fmt::format(": {}", arm[3].text()) : "");
}

// (stop WHO REASON)
std::string stop_line(const Datum& stop) { return fmt::format("{}: {}", stop[1].text(), stop[2].text()); }

std::string joined(const std::vector<Fact>& facts, std::string (*text_of)(const Datum&)) {
  std::vector<std::string> texts;
  for (const Fact& fact : facts) texts.push_back(text_of(fact.datum));
  std::ranges::sort(texts);
  return fmt::format("{}", fmt::join(texts, ", "));
}

// None, and why, where the board does not say.
Task<std::vector<Fact>> facts_of(Board& board, Datum pattern, CellSight* cell) {
  if (cell->fault) co_return std::vector<Fact>();
  Result<std::vector<Fact>> facts = co_await runtime::facts_if_declared(board, std::move(pattern));
  if (!facts) cell->fault = facts.error();
  co_return facts.value_or(std::vector<Fact>());
}

Task<void> look_at_cell(std::unique_ptr<client::RemoteBoard> board, CellSight* cell) {
  const std::vector<Fact> agents = co_await facts_of(*board, any_fact("agent", 3), cell);
  const std::vector<Fact> goals = co_await facts_of(*board, any_fact("goal", 2), cell);
  const std::vector<Fact> states = co_await facts_of(*board, any_fact("goal-state", 3), cell);
  const std::vector<Fact> arms = co_await facts_of(*board, any_fact("arm", 3), cell);
  const std::vector<Fact> stops = co_await facts_of(*board, any_fact("stop", 2), cell);
  cell->agents = agents.size();
  cell->goal = goal_line(goals, states);
  cell->arms = joined(arms, arm_line);
  cell->stops = joined(stops, stop_line);
}

Task<void> list_boards(client::Contexts& contexts, std::string root, std::vector<CellSight>* cells) {
  const std::vector<client::Contexts::Row> rows = co_await contexts.list(std::move(root));
  for (const client::Contexts::Row& row : rows)
    cells->push_back({.path = row.path, .address = row.address, .fault = row.fault});
}

}  // namespace

std::vector<CellSight> look_at_cells(Executor& executor, client::Contexts& contexts, const std::string& root,
                                     const Reach& reach) {
  std::vector<CellSight> cells;
  const Job listing = executor.spawn(list_boards(contexts, root, &cells));
  executor.run_until([&] { return listing.done(); });
  constexpr std::size_t together = client::Contexts::most_asked_at_once;
  for (std::size_t begun = 0; begun < cells.size(); begun += together) {
    std::vector<Job> looking;
    for (CellSight& cell : std::span(cells).subspan(begun, std::min(together, cells.size() - begun))) {
      if (cell.fault) continue;
      Result<std::unique_ptr<client::RemoteBoard>> board = reach(cell.address);
      if (!board) cell.fault = board.error();
      if (board) looking.push_back(executor.spawn(look_at_cell(std::move(*board), &cell)));
    }
    executor.run_until([&] { return std::ranges::all_of(looking, &Job::done); });
  }
  return cells;
}

}  // namespace pizarra::programs
