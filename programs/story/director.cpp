#include "programs/story/director.hpp"

#include <algorithm>

#include "agents/launcher/readiness.hpp"
#include "agents/runtime/roles.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/writer.hpp"

namespace pizarra::story {

namespace {

constexpr Duration goal_timeout = 30s;
constexpr Duration events_pause = 100ms;
// How long a story may go on after its goal ended, for events that have not come yet.
constexpr Duration afterwards = 5s;

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

void add(std::vector<std::string>& sentences, const std::vector<std::string>& more) {
  sentences.insert(sentences.end(), more.begin(), more.end());
}

}  // namespace

Director::Director(launcher::LocalCell& cell, const forms::Scenario& scenario, const Judge& judge, Narrator& narrator,
                   DirectorOptions options)
    : cell_(cell),
      scenario_(scenario),
      options_(options),
      board_(cell.board().view("director")),
      context_{"director", "localhost", cell.executor(), *board_, cell.random("director")},
      service_(context_, runtime::contract_from_text("(contract director)").value()),
      caller_(context_, service_),
      expectations_(scenario, *board_, cell.executor()),
      events_(cell, *board_, scenario, narrator,
              [this](std::vector<Datum> goal) { return give_goal(std::move(goal)); }),
      witness_(cell, judge),
      stages_(context_, witness_, narrator) {}

Director::~Director() = default;

Task<Result<void>> Director::prepare() {
  const Result<void> started = co_await service_.start();
  if (!started) co_return started;
  std::vector<std::string> players = launcher::agent_kinds(cell_.description());
  const Result<void> there = co_await launcher::await_agents(cell_, *board_, std::move(players));
  if (!there) co_return there;
  const Result<void> taught = co_await launcher::await_teaching(*board_, cell_.executor());
  if (!taught) co_return taught;
  for (const Datum& action : scenario_.before_goal) {
    const Result<void> done = co_await events_.perform(action);
    if (!done) co_return done;
  }
  co_return {};
}

Task<Result<void>> Director::give_goal(std::vector<Datum> goal) {
  report_.goal = facts_of_goal(goal);
  std::vector<Datum> request{"goal"_sym};
  // A fact of the board, as a request is one, holds no variables.
  for (const Datum& form : goal) request.push_back(forms::without_variables(form));
  Datum operation = Datum::list(std::move(request));
  const runtime::Role role = runtime::coordinator_role();
  const Result<runtime::Holder> coordinator = co_await runtime::holder_of(*board_, context_.name, role);
  if (!coordinator) co_return fail(coordinator);
  const Result<Datum> accepted = co_await caller_.call(coordinator->server, std::move(operation), goal_timeout);
  if (!accepted) co_return fail(accepted);
  goal_number_ = (*accepted)[0].integer();
  stages_.begin(goal_number_, report_.goal);
  co_return {};
}

// Until the newest goal has ended and every event has come, or the deadline.
Task<void> Director::await_end(Time deadline) {
  Executor& executor = cell_.executor();
  while (true) {
    const std::int64_t number = goal_number_;
    const Datum form = list("and"_sym, list("goal-state"_sym, number, "?state"_sym, "?detail"_sym),
                            list("/="_sym, "?state"_sym, "running"_sym));
    Query query = query_from_datum(form).value();
    const Result<Answer> end = co_await launcher::await_when_declared(*board_, executor, std::move(query), deadline);
    if (!end) {
      report_.outcome = "timeout";
      co_return;
    }
    report_.outcome = end->bindings.find("?state")->text();
    // As good as reached, as long as it lasts.
    const bool kept = report_.outcome == "kept";
    if (kept) report_.outcome = "reached";
    const Datum detail = *end->bindings.find("?detail");
    report_.refusal_told = report_.outcome == "refused";
    if (report_.refusal_told) report_.refusal = failure_from_datum(detail);
    // A goal that is kept does not end, so the story goes on until its deadline.
    const Time last = kept ? deadline : std::min(executor.now() + afterwards, deadline);
    const Result<void> over = co_await await_events(last);
    if (!over) {
      report_.outcome = "refused";
      report_.refusal = over.error();
      report_.refusal_told = false;
      co_return;
    }
    const bool ended = goal_number_ == number && !kept;
    if (ended) co_return;
    if (goal_number_ == number) {
      // What came meanwhile may have felled it; it is noticed within a second.
      co_await sleep(executor, events_pause * 15);
      const Result<bool> stands = co_await is_kept(number);
      if (stands && *stands) co_return;
    }
    report_.refusal.reset();
  }
}

Task<Result<bool>> Director::is_kept(std::int64_t number) {
  const Datum kept = list("goal-state"_sym, number, "kept"_sym, "?"_sym);
  const Result<std::vector<Fact>> found = co_await board_->facts(kept);
  if (!found) co_return fail(found);
  co_return !found->empty();
}

Task<Result<void>> Director::await_events(Time deadline) {
  if (!options_.events_may_fail) {
    while (events_.awaited() && cell_.executor().now() < deadline) {
      co_await sleep(cell_.executor(), events_pause);
    }
    co_return {};
  }
  const bool disturbed = co_await events_.end(deadline);
  if (!disturbed) co_return {};
  std::vector<Datum> again = report_.goal;
  co_return co_await give_goal(std::move(again));
}

Task<void> Director::give_judgement() {
  report_.blind = witness_.blind_to(report_.goal);
  const Result<Verdict> verdict = co_await witness_.judge(report_.goal);
  add(report_.unmet, events_.troubles());
  report_.false_stages = stages_.unmet(report_.outcome);
  add(report_.unmet, report_.false_stages);
  if (!verdict) {
    report_.unmet.push_back(describe(verdict.error()));
    co_return;
  }
  report_.truth_holds = verdict->holds;
  report_.possible = verdict->possible;
}

Task<void> Director::story() {
  Executor& executor = cell_.executor();
  const Result<void> prepared = co_await prepare();
  if (!prepared) {
    report_.outcome = prepared.error().symbol;
    report_.unmet.push_back(describe(prepared.error()));
    co_return;
  }
  witness_.open_eyes();
  const Time begun = executor.now();
  const Time deadline = begun + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(scenario_.within_s));
  const Result<void> given = co_await give_goal(scenario_.goal);
  if (given) {
    events_.begin();
    co_await await_end(deadline);
  } else {
    report_.outcome = "refused";
    report_.refusal = given.error();
  }
  report_.took = executor.now() - begun;
  report_.events = events_.done();
  co_await give_judgement();
}

Task<void> Director::run() {
  expectations_.begin();
  co_await story();
  add(report_.unmet, expectations_.unmet(report_));
  const std::optional<Datum> missed = events_.awaited();
  if (missed && !options_.events_may_fail) report_.unmet.push_back("its time never came: " + write(*missed));
}

}  // namespace pizarra::story
