#include "tests/programs/tapped_cell.hpp"

#include <utility>

#include "agents/runtime/caller.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration teaching_time = 120s;
constexpr Duration building_time = 240s;
constexpr Duration look_pause = 100ms;

bool holds(memory::MemoryBoard& board, const Datum& pattern) {
  const Result<Answers> answers = board.ask(query_for(pattern));
  return answers && !answers->answers.empty();
}

bool run_until_holds(VirtualExecutor& executor, memory::MemoryBoard& board, const Datum& pattern, Duration patience) {
  const Time end = executor.now() + patience;
  while (!holds(board, pattern) && executor.now() < end) executor.run_for(look_pause);
  return holds(board, pattern);
}

Task<void> give_goal(runtime::AgentContext& context, Datum goal, Result<Datum>* answer) {
  runtime::Service service(context, runtime::contract_from_text("(contract visitor)").value());
  const Result<void> started = co_await service.start();
  if (!started) {
    *answer = fail(started);
    co_return;
  }
  runtime::Caller caller(context, service);
  *answer = co_await caller.call("coordinator", std::move(goal), building_time);
}

Task<void> ask_link(simulation::Link& link, Datum question, Datum* answer) {
  const Result<simulation::Message> message = co_await link.call(std::move(question), building_time);
  if (message) *answer = message->head;
}

}  // namespace

Task<Result<simulation::Message>> Tap::call(Datum request, Duration timeout) {
  asked.push_back(request);
  Result<simulation::Message> answer = co_await link_.call(std::move(request), timeout);
  if (answer) answered.push_back(answer->head);
  co_return answer;
}

Result<void> teach_and_build(VirtualExecutor& executor, memory::MemoryBoard& board, std::vector<Datum> goal) {
  if (!run_until_holds(executor, board, list("person"_sym, "done"_sym, "?"_sym), teaching_time)) {
    return fail("timeout", "the person has not taught everything");
  }
  const std::unique_ptr<Board> view = board.view("visitor");
  runtime::AgentContext context{"visitor", "localhost", executor, *view, Random(1)};
  goal.insert(goal.begin(), "goal"_sym);
  Result<Datum> answer = fail("timeout", "the coordinator has not answered");
  const Job giving = executor.spawn(give_goal(context, Datum::list(std::move(goal)), &answer));
  executor.run_until([&giving] { return giving.done(); });
  if (!answer) return fail(answer);
  const Datum reached = list("goal-state"_sym, (*answer)[0], "reached"_sym, "?"_sym);
  if (!run_until_holds(executor, board, reached, building_time)) return fail("timeout", "the goal is not reached");
  return {};
}

TappedCell::TappedCell(const forms::CellDescription& description, const simulation::WorldConfig& config,
                       std::uint64_t seed)
    : world_(executor_, config) {
  board_.set_journal([this](std::string_view line) { journal_.append(line).append("\n"); });
  forms::CellDescription without_cubes = description;
  without_cubes.cubes.clear();
  const Random random(seed);
  for (const std::string& kind : launcher::agent_kinds(description)) {
    BoardTap& board = *boards_.emplace(kind, std::make_unique<BoardTap>(board_.view(kind))).first->second;
    Tap& tap = *taps_.emplace(kind, std::make_unique<Tap>(link_)).first->second;
    runtime::AgentContext context{kind, "localhost", executor_, board, random.split(kind)};
    const forms::CellDescription& told = kind == "person" ? description : without_cubes;
    agents_.push_back(launcher::build_agent(kind, std::move(context), told, tap, &streams_).value());
    jobs_.push_back(executor_.spawn(agents_.back()->run()));
  }
}

TappedCell::~TappedCell() = default;

Datum TappedCell::contract_of(const std::string& agent) {
  const Result<Answers> answers = board_.ask(query_for(list("contract"_sym, Datum::symbol(agent), "?"_sym)));
  if (!answers || answers->answers.empty()) return {};
  return answers->answers.front().facts.front().datum[2];
}

Datum TappedCell::ask_world(Datum question) {
  Datum answer;
  const Job asking = executor_.spawn(ask_link(link_, std::move(question), &answer));
  executor_.run_until([&asking] { return asking.done(); });
  return answer;
}

}  // namespace pizarra::programs
