#include "agents/launcher/director.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr Duration agents_timeout = 20s;
constexpr Duration teaching_timeout = 120s;
constexpr Duration goal_timeout = 30s;
constexpr Duration hand_timeout = 20s;
constexpr Duration busy_pause = 200ms;
constexpr Duration declared_pause = 100ms;
constexpr Duration look_pause = 250ms;
constexpr Duration blind_after = 2s;
constexpr double visible_enough = 0.5;
// What was built stands still, or falls, before it is judged.
constexpr Duration settle = 1500ms;
// How long a story may go on after its goal ended, for events that have not come yet.
constexpr Duration afterwards = 5s;
// Longer than any story.
constexpr Duration for_ever = 86400s;

// As await_answer(), also when the relations are yet to be declared.
Task<Result<Answer>> await_when_declared(Board& board, Executor& executor, Query query, Time deadline) {
  while (true) {
    Result<Answer> answer = co_await await_answer(board, query, deadline, executor);
    if (answer || answer.error().symbol != "undeclared-relation") co_return answer;
    if (executor.now() >= deadline) co_return answer;
    co_await sleep(executor, declared_pause);
  }
}

void collect_symbols(const Datum& datum, std::vector<std::string>& out) {
  if (datum.is_symbol()) out.emplace_back(datum.text());
  for (const Datum& item : datum.items()) collect_symbols(item, out);
}

std::vector<Datum> facts_of_goal(std::span<const Datum> forms) {
  std::vector<Datum> facts;
  for (const Datum& form : forms) {
    if (form.is_form("and")) {
      const std::vector<Datum> inner = facts_of_goal(form.items().subspan(1));
      facts.insert(facts.end(), inner.begin(), inner.end());
    } else {
      facts.push_back(form);
    }
  }
  return facts;
}

}  // namespace

bool DirectorReport::refused_correctly() const {
  static constexpr std::array<std::string_view, 4> reasons{"no-plan", "missing-object", "unknown-object",
                                                           "contradictory"};
  const bool for_a_reason =
      outcome == "refused" && refusal && std::ranges::find(reasons, refusal->symbol) != reasons.end();
  return for_a_reason && (!possible || blind);
}

Director::Director(LocalCell& cell, const Scenario& scenario, const Judge& judge, Narrator& narrator,
                   DirectorOptions options)
    : cell_(cell),
      scenario_(scenario),
      judge_(judge),
      narrator_(narrator),
      options_(std::move(options)),
      board_(cell.board().view("director")),
      context_{"director", "localhost", cell.executor(), *board_, cell.random("director")},
      service_(context_, contract_from_text("(contract director)").value()),
      caller_(context_, service_),
      seen_(scenario.expect_seen.size() + scenario.expect_never.size(), 0) {}

Director::~Director() = default;

Task<Result<void>> Director::await_agents() {
  const Time deadline = cell_.executor().now() + agents_timeout;
  for (const std::string& kind : agent_kinds()) {
    Query query = query_for(list("agent"_sym, "?"_sym, Datum::symbol(kind), "?"_sym));
    const Result<Answer> there = co_await await_when_declared(*board_, cell_.executor(), std::move(query), deadline);
    if (there) continue;
    const std::optional<Failure> why = cell_.ended(kind);
    const std::string reason = why.has_value() ? ": " + describe(*why) : std::string();
    co_return fail("no-agents", fmt::format("the {} agent does not come up{}", kind, reason));
  }
  co_return {};
}

Task<Result<void>> Director::await_teaching() {
  const Time deadline = cell_.executor().now() + teaching_timeout;
  const Datum form =
      list("and"_sym, list("person"_sym, "?state"_sym, "?detail"_sym), list("/="_sym, "?state"_sym, "teaching"_sym));
  Query query = query_from_datum(form).value();
  const Result<Answer> end = co_await await_when_declared(*board_, cell_.executor(), std::move(query), deadline);
  if (!end) co_return fail("not-taught", "the objects were not learned in time");
  if (end->bindings.find("?state")->is_symbol("done")) co_return {};
  const Failure why = failure_from_datum(*end->bindings.find("?detail"));
  co_return fail("not-taught", why.sentence, why.subject);
}

Task<Result<void>> Director::prepare() {
  const Result<void> started = co_await service_.start();
  if (!started) co_return started;
  const Result<void> there = co_await await_agents();
  if (!there) co_return there;
  const Result<void> taught = co_await await_teaching();
  if (!taught) co_return taught;
  for (const Datum& action : scenario_.before_goal) {
    const Result<void> done = co_await perform(action);
    if (!done) co_return done;
  }
  co_return {};
}

Task<Result<void>> Director::give_goal(std::vector<Datum> goal) {
  report_.goal = facts_of_goal(goal);
  std::vector<Datum> request{"goal"_sym};
  request.insert(request.end(), goal.begin(), goal.end());
  const std::string text = write(Datum::list(goal));
  narrator_.say(cell_.executor().now(), "goal", text.substr(1, text.size() - 2));
  Datum operation = Datum::list(std::move(request));
  const Result<Datum> accepted = co_await caller_.call("coordinator", std::move(operation), goal_timeout);
  if (!accepted) co_return fail(accepted);
  goal_number_ = (*accepted)[0].integer();
  co_return {};
}

Task<Result<void>> Director::begin_goal() {
  std::vector<Datum> goal = scenario_.goal;
  if (options_.read_goal) {
    std::vector<std::string> objects;
    for (const CubePlacement& cube : cell_.description().cubes) objects.push_back(cube.name);
    Result<std::vector<Datum>> read = options_.read_goal(objects);
    if (!read) {
      report_.outcome = "malformed";
      co_return fail(read);
    }
    goal = std::move(*read);
  }
  const Result<void> given = co_await give_goal(std::move(goal));
  if (!given) report_.outcome = "refused";
  co_return given;
}

// Until the newest goal has ended and every event has come, or the deadline.
Task<void> Director::await_end(Time deadline) {
  Executor& executor = cell_.executor();
  while (true) {
    const std::int64_t number = goal_number_;
    const Datum form = list("and"_sym, list("goal-state"_sym, number, "?state"_sym, "?detail"_sym),
                            list("/="_sym, "?state"_sym, "running"_sym));
    Query query = query_from_datum(form).value();
    const Result<Answer> end = co_await await_when_declared(*board_, executor, std::move(query), deadline);
    if (!end) {
      report_.outcome = "timeout";
      co_return;
    }
    report_.outcome = end->bindings.find("?state")->text();
    const Datum detail = *end->bindings.find("?detail");
    report_.refusal_told = report_.outcome == "refused";
    if (report_.refusal_told) report_.refusal = failure_from_datum(detail);
    const Time last = std::min(executor.now() + afterwards, deadline);
    if (options_.events_may_fail) {
      const Result<void> ended = co_await end_events(last);
      if (!ended) {
        report_.outcome = "refused";
        report_.refusal = ended.error();
        report_.refusal_told = false;
        co_return;
      }
    } else {
      while (events_done_ < scenario_.events.size() && executor.now() < last) {
        co_await sleep(executor, declared_pause);
      }
    }
    if (goal_number_ == number) co_return;
    report_.refusal.reset();
  }
}

// No event begins any more; one that has begun ends, and then the goal is given again.
Task<Result<void>> Director::end_events(Time last) {
  const bool disturbed = acting_;
  while (acting_ && cell_.executor().now() < last) {
    co_await sleep(cell_.executor(), declared_pause);
  }
  if (disturbed && !acting_) ++events_done_;
  events_ = Job();
  if (!disturbed) co_return {};
  std::vector<Datum> again = report_.goal;
  co_return co_await give_goal(std::move(again));
}

Task<Result<void>> Director::move_hand(Datum action) {
  const Time deadline = cell_.executor().now() + hand_timeout;
  narrator_.say(cell_.executor().now(), "hand", write(action), action);
  while (true) {
    const Result<Message> moved = co_await cell_.link().call(action, hand_timeout);
    if (moved) co_return {};
    if (moved.error().symbol != "busy" || cell_.executor().now() >= deadline) co_return fail(moved);
    co_await sleep(cell_.executor(), busy_pause);
  }
}

Task<Result<void>> Director::perform(Datum action) {
  if (action.is_form("wait")) {
    const auto pause = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(action[1].number()));
    co_await sleep(cell_.executor(), pause);
    co_return {};
  }
  acting_ = true;
  const Result<void> done = co_await act(std::move(action));
  acting_ = false;
  co_return done;
}

Task<Result<void>> Director::act(Datum action) {
  if (action.is_form("hand")) co_return co_await move_hand(action);
  if (action.is_form("goal")) {
    std::vector<Datum> goal(action.items().begin() + 1, action.items().end());
    co_return co_await give_goal(std::move(goal));
  }
  const std::string kind(action[1].text());
  narrator_.say(cell_.executor().now(), "agent", fmt::format("{} is {}ed", kind, action.head()), action);
  if (action.is_form("kill")) co_return cell_.kill(kind);
  co_return cell_.start(kind);
}

Task<void> Director::happen_once(ScenarioEvent event) {
  Query query = query_from_datum(event.condition).value();
  const Time never = cell_.executor().now() + for_ever;
  const Result<Answer> come = co_await await_when_declared(*board_, cell_.executor(), std::move(query), never);
  if (!come) {
    report_.unmet.push_back(describe(come.error()));
    co_return;
  }
  for (const Datum& action : event.actions) {
    Datum ground = substitute(action, come->bindings);
    const Result<void> done = co_await perform(std::move(ground));
    if (!done) report_.unmet.push_back(fmt::format("{}: {}", write(action), describe(done.error())));
  }
}

Task<void> Director::happen() {
  for (const ScenarioEvent& event : scenario_.events) {
    co_await happen_once(event);
    ++events_done_;
  }
}

Task<void> Director::watch_for(Datum pattern, char* seen) {
  Query query = query_from_datum(pattern).value();
  const Time never = cell_.executor().now() + for_ever;
  const Result<Answer> come = co_await await_when_declared(*board_, cell_.executor(), std::move(query), never);
  if (come) *seen = 1;
}

Task<void> Director::keep_eyes_open() {
  while (true) {
    const Result<Truth> truth = co_await read_truth(cell_.link());
    const Time now = cell_.executor().now();
    if (truth) {
      for (const auto& [name, cube] : truth->cubes) {
        const auto [entry, first] = last_visible_.try_emplace(name, now);
        if (cube.visible >= visible_enough) entry->second = now;
      }
    }
    co_await sleep(cell_.executor(), look_pause);
  }
}

Task<Result<void>> Director::look_at_world() {
  const Result<Truth> truth = co_await read_truth(cell_.link());
  if (!truth) co_return fail(truth);
  const Result<std::vector<Datum>> facts = judge_.facts(*truth);
  if (!facts) co_return fail(facts);
  report_.truth_holds = Judge::holds(report_.goal, *facts);
  if (report_.truth_holds) co_return {};
  const Result<bool> possible = judge_.plan_exists(report_.goal, *truth, *facts);
  if (!possible) co_return fail(possible);
  report_.possible = *possible;
  co_return {};
}

Task<void> Director::give_judgement() {
  const Time ended = cell_.executor().now();
  std::vector<std::string> names;
  for (const Datum& fact : report_.goal) {
    const Datum folded = in_small_letters(fact);
    for (const Datum& argument : folded.items().subspan(1)) collect_symbols(argument, names);
  }
  report_.blind = std::ranges::any_of(names, [&](const std::string& name) {
    const auto seen = last_visible_.find(name);
    return seen != last_visible_.end() && ended - seen->second >= blind_after;
  });
  co_await sleep(cell_.executor(), settle);
  const Result<void> looked = co_await look_at_world();
  if (!looked) report_.unmet.push_back(describe(looked.error()));
}

void Director::check_expectations() {
  const std::size_t must = scenario_.expect_seen.size();
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (i < must && !seen_[i]) report_.unmet.push_back("never came: " + write(scenario_.expect_seen[i]));
    if (i >= must && seen_[i]) report_.unmet.push_back("came: " + write(scenario_.expect_never[i - must]));
  }
  if (!options_.events_may_fail && events_done_ < scenario_.events.size()) {
    report_.unmet.push_back("its time never came: " + write(scenario_.events[events_done_].condition));
  }
  if (scenario_.expect_reached && report_.outcome != "reached") {
    const std::string why = report_.refusal ? ": " + describe(*report_.refusal) : "";
    report_.unmet.push_back(fmt::format("expected the goal to be reached, and it ended as {}{}", report_.outcome, why));
  } else if (scenario_.expect_reached && !report_.truth_holds) {
    report_.unmet.push_back("the cell says reached, and in the world it is not so");
  } else if (!scenario_.expect_reached && report_.outcome != "refused") {
    report_.unmet.push_back(fmt::format("expected the goal to be refused, and it ended as {}", report_.outcome));
  } else if (!scenario_.refusal.empty() && report_.refusal->symbol != scenario_.refusal) {
    report_.unmet.push_back(
        fmt::format("expected the refusal {}, and it was {}", scenario_.refusal, report_.refusal->symbol));
  }
}

Task<void> Director::story() {
  Executor& executor = cell_.executor();
  const Result<void> prepared = co_await prepare();
  if (!prepared) {
    report_.outcome = prepared.error().symbol;
    report_.unmet.push_back(describe(prepared.error()));
    co_return;
  }
  jobs_.push_back(executor.spawn(keep_eyes_open()));
  const Time begun = executor.now();
  const Time deadline = begun + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(scenario_.within_s));
  const Result<void> given = co_await begin_goal();
  if (given) {
    events_ = executor.spawn(happen());
    co_await await_end(deadline);
  } else {
    report_.refusal = given.error();
  }
  report_.took = executor.now() - begun;
  report_.events = events_done_;
  co_await give_judgement();
}

Task<void> Director::run() {
  const std::size_t must = scenario_.expect_seen.size();
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Datum& pattern = i < must ? scenario_.expect_seen[i] : scenario_.expect_never[i - must];
    jobs_.push_back(cell_.executor().spawn(watch_for(pattern, &seen_[i])));
  }
  co_await story();
  check_expectations();
}

}  // namespace pizarra
