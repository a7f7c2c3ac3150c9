#include "programs/commands/cell_sight.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/runtime/declared.hpp"
#include "blackboard/boards_own.hpp"
#include "blackboard/time/together.hpp"
#include "lisp/json.hpp"
#include "lisp/reader.hpp"
#include "lisp/shortened.hpp"
#include "lisp/writer.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration longest_look = 2s;  // and one question more, to each cell
constexpr std::size_t most_at_once = client::Contexts::most_asked_at_once;

// What is asked of each cell. Another board may hold any number of each.
constexpr const char* agents_there = "(query (agent ?name ?kind ?host) (limit 1000))";
constexpr const char* newest_goal = "(query (goal-state ?n ?state ?detail) (order (down ?n)) (limit 1))";
constexpr const char* arms_there = "(query (arm ?robot ?state ?action) (limit 20))";
constexpr const char* stops_standing = "(query (stop ?who ?reason) (limit 20))";
constexpr const char* who_leads = "(query (board-leads ?name) (limit 20))";
constexpr const char* newest_event = "(query (event ?n ?kind ?sentence ?detail) (order (down ?n)) (limit 1))";
constexpr const char* its_console = "(query (console-address ?client ?address) (limit 1))";

// (arm ROBOT STATE ACTION)
std::string arm_line(const Datum& arm) {
  const bool says_why = arm[2].is_symbol("fault") || arm[2].is_symbol("stopped");
  return fmt::format("{} {}{}", arm[1].text(), arm[2].text(), says_why ? fmt::format(": {}", arm[3].text()) : "");
}

// (stop WHO REASON)
std::string stop_line(const Datum& stop) { return fmt::format("{}: {}", stop[1].text(), stop[2].text()); }

// (board-leads NAME), where the board tells it.
std::string leader_of(const std::vector<Fact>& leaders) {
  const auto told = std::ranges::find(leaders, board_teller, &Fact::teller);
  return told == leaders.end() ? "" : std::string(told->datum[1].text());
}

std::string joined(const std::vector<Fact>& facts, std::string (*text_of)(const Datum&)) {
  std::vector<std::string> texts;
  for (const Fact& fact : facts) texts.push_back(text_of(fact.datum));
  std::ranges::sort(texts);
  return fmt::format("{}", fmt::join(texts, ", "));
}

// That text of the one fact that was asked for, where there is one.
std::string text_in(const std::vector<Fact>& facts, std::size_t argument) {
  return facts.empty() ? "" : std::string(facts.front().datum[argument].text());
}

// The questions to one cell. Once its board does not answer one, or takes too long, the cell's fault says so, and
// nothing more is asked.
class Questions {
 public:
  Questions(Executor& executor, Board& board, CellSight& cell)
      : executor_(executor), until_(executor.now() + longest_look), board_(board), cell_(cell) {}

  Task<std::vector<Fact>> ask(std::string question) {
    std::vector<Fact> facts;
    if (!cell_.fault && executor_.now() > until_) cell_.fault = Failure{"timeout", "its board answers slowly", {}, {}};
    if (cell_.fault) co_return facts;
    Query query = query_from_datum(read_one(question).value()).value();
    Result<Answers> answers = co_await runtime::answers_if_declared(board_, std::move(query));
    if (!answers) {
      cell_.fault = answers.error();
      co_return facts;
    }
    for (Answer& answer : answers->answers) facts.push_back(std::move(answer.facts.front()));
    co_return facts;
  }

 private:
  Executor& executor_;
  const Time until_;
  Board& board_;
  CellSight& cell_;
};

// (goal N (FORM ...)), (goal-state N STATE DETAIL)
Task<std::string> goal_line(Questions& questions) {
  const std::vector<Fact> states = co_await questions.ask(newest_goal);
  if (states.empty()) co_return "";
  const Datum& state = states.front().datum;
  std::string text = fmt::format("{} {}", state[1].integer(), state[2].text());
  std::string its_forms = fmt::format("(goal {} ?forms)", state[1].integer());
  const std::vector<Fact> goals = co_await questions.ask(std::move(its_forms));
  if (goals.empty()) co_return text;
  for (const Datum& form : goals.front().datum[2].items()) text += " " + write(form);
  co_return text;
}

Task<void> look_at_cell(Executor& executor, client::Contexts& contexts, CellSight* cell) {
  const Result<std::unique_ptr<client::RemoteBoard>> board = contexts.reach(cell->address);
  if (!board) {
    cell->fault = board.error();
    co_return;
  }
  Questions questions(executor, **board, *cell);
  const std::vector<Fact> agents = co_await questions.ask(agents_there);
  cell->agents = agents.size();
  cell->goal = co_await goal_line(questions);
  const std::vector<Fact> arms = co_await questions.ask(arms_there);
  cell->arms = joined(arms, arm_line);
  const std::vector<Fact> stops = co_await questions.ask(stops_standing);
  cell->stops = joined(stops, stop_line);
  const std::vector<Fact> leaders = co_await questions.ask(who_leads);
  cell->leads = leader_of(leaders);
  const std::vector<Fact> events = co_await questions.ask(newest_event);
  cell->said = text_in(events, 3);
  const std::vector<Fact> consoles = co_await questions.ask(its_console);
  cell->console = text_in(consoles, 2);
}

}  // namespace

std::string json_of(const CellSight& cell, std::size_t longest_text) {
  const auto text = [=](const std::string& whole) { return json_string(shortened(whole, longest_text)); };
  const std::string fault = cell.fault ? text(describe(*cell.fault)) : "null";
  return fmt::format(
      "{{\"path\":{},\"address\":{},\"fault\":{},\"agents\":{},\"goal\":{},\"arms\":{},\"stops\":{},\"leads\":{},"
      "\"said\":{},\"console\":{}}}",
      text(cell.path), text(cell.address), fault, cell.agents, text(cell.goal), text(cell.arms), text(cell.stops),
      text(cell.leads), text(cell.said), text(cell.console));
}

Task<std::vector<CellSight>> look_at_cells(Executor& executor, client::Contexts& contexts, std::string root,
                                           std::size_t most) {
  const std::vector<client::Contexts::Row> rows = co_await contexts.list(std::move(root), most);
  std::vector<CellSight> cells;
  for (const client::Contexts::Row& row : rows)
    cells.push_back({.path = row.path, .address = row.address, .fault = row.fault});
  std::vector<Task<void>> looking;
  for (CellSight& cell : cells) {
    if (!cell.fault) looking.push_back(look_at_cell(executor, contexts, &cell));
  }
  co_await run_together(executor, std::move(looking), most_at_once);
  co_return cells;
}

}  // namespace pizarra::programs
