#include "agents/person/person_agent.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/runtime/declared.hpp"

namespace pizarra::person {

namespace {

constexpr const char* contract_text = R"((contract person
  (offers (teach (name string)))
  (posts (relation person ((state symbol) (detail datum)) (key) (durable))
         (relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))
         (relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role)))
  (reads agent bound body learned wired)))";

constexpr const char* end_effector = "end-effector";
constexpr int tries = 5;
constexpr Duration pause_between_tries = 500ms;
constexpr Duration look_timeout = 2s;
constexpr Duration arm_timeout = 30s;
constexpr Duration vision_timeout = 10s;
constexpr Duration longest_wait = 10s;  // for a robot, and for eyes
// The arm comes down by these steps until its mark is in the image, and no lower than that many.
constexpr std::int64_t step_down_mm = 50;
constexpr int most_steps_down = 6;

// Of a failure to teach: its subject is the eyes' reply, (TEXT SYMBOL SENTENCE) where TEXT says FAIL.
bool looks_like_another(const Failure& why) {
  const Datum& reply = why.subject;
  return why.symbol == "not-learned" && reply.is_list() && reply.size() == 3 && reply[1] == "ambiguous"_sym;
}

Datum learned_pattern(const std::string& eyes, const Datum& name) {
  std::vector<Datum> any(10, "?"_sym);
  any[0] = "learned"_sym;
  any[1] = Datum::symbol(eyes);
  any[2] = name;
  return Datum::list(std::move(any));
}

}  // namespace

PersonAgent::PersonAgent(runtime::AgentContext context, simulation::Link& link, std::vector<std::string> names)
    : context_(std::move(context)),
      link_(link),
      names_(std::move(names)),
      service_(context_, runtime::contract_from_text(contract_text).value()),
      caller_(context_, service_),
      roles_(context_, service_, {runtime::robot_role(), runtime::eyes_role()}) {}

Task<void> PersonAgent::say(Datum state, Datum detail) {
  Datum fact = list("person"_sym, std::move(state), std::move(detail));
  const Result<Revision> told = co_await context_.board.tell(std::move(fact));
  static_cast<void>(told);
}

Task<Result<bool>> PersonAgent::any_fact(Datum pattern) {
  // Vision may have yet to come and declare what it tells.
  const Result<std::vector<Fact>> facts = co_await runtime::facts_if_declared(context_.board, std::move(pattern));
  if (!facts) co_return fail(facts);
  co_return !facts->empty();
}

// As an object, or as a body of several marks.
Task<Result<bool>> PersonAgent::known(std::string name) {
  const std::string eyes = roles_.holder("eyes").server;
  const Result<bool> learned = co_await any_fact(learned_pattern(eyes, Datum::string(name)));
  const bool settled = !learned || *learned;
  if (settled) co_return learned;
  co_return co_await any_fact(list("body"_sym, Datum::symbol(eyes), name, "?"_sym));
}

// A motion that was stopped, as where the robot agent began anew, is asked for again.
Task<Result<void>> PersonAgent::move_arm(Datum operation) {
  Result<Datum> moved = fail("stopped", "the arm was not moved");
  for (int n = 0; n < tries; ++n) {
    moved = co_await caller_.call(roles_.player("robot"), operation, arm_timeout);
    if (moved) co_return {};
    if (moved.error().symbol != "stopped") break;
  }
  co_return fail(moved);
}

Task<Result<Datum>> PersonAgent::ask_eyes(Datum operation) {
  co_return co_await caller_.call(roles_.player("eyes"), std::move(operation), vision_timeout);
}

Task<Result<void>> PersonAgent::show_end_effector() {
  Datum question = list("where-seen"_sym, end_effector);
  const Result<simulation::Message> at_once = co_await link_.call(question, look_timeout);
  if (at_once) co_return {};
  Datum ready = list("ready"_sym);
  const Result<void> stood = co_await move_arm(ready);
  if (!stood) co_return stood;
  steps_below_ready_ = 0;
  while (true) {
    const Result<simulation::Message> seen = co_await link_.call(question, look_timeout);
    if (seen) co_return {};
    if (seen.error().symbol != "not-seen") co_return fail(seen);
    const Result<void> moved = co_await lower_arm();
    if (!moved) co_return moved;
  }
}

Task<Result<void>> PersonAgent::lower_arm() {
  if (steps_below_ready_ == most_steps_down)
    co_return fail("not-seen", "the end effector does not come into the image");
  ++steps_below_ready_;
  Datum down = list("move-v"_sym, "down"_sym, step_down_mm);
  co_return co_await move_arm(down);
}

Task<Result<void>> PersonAgent::teach_once(std::string name) {
  Datum question = list("where-seen"_sym, name);
  const Result<simulation::Message> seen = co_await link_.call(question, look_timeout);
  if (!seen) co_return fail(seen);
  const Datum& at = seen->head;
  Datum learn = list("learn"_sym, at[0], at[1], name);
  const Result<Datum> reply = co_await ask_eyes(std::move(learn));
  if (!reply) co_return fail(reply);
  const std::string expected = fmt::format("(LEARN \"{}\" OK)", name);
  if (reply->size() == 1 && (*reply)[0].text() == expected) co_return {};
  co_return fail("not-learned", fmt::format("vision could not learn {}", name), *reply);
}

// Whether it could not be learned because it looks like an object that bears a name of nothing in the cell: somebody
// has renamed it since it was taught.
Task<bool> PersonAgent::renamed(Failure why) {
  if (!looks_like_another(why)) co_return false;
  const std::string eyes = roles_.holder("eyes").server;
  const Datum anything = learned_pattern(eyes, "?"_sym);
  const Result<std::vector<Fact>> samples = co_await context_.board.facts(anything);
  if (!samples) co_return false;
  co_return std::ranges::any_of(
      *samples, [&](const Fact& sample) { return std::ranges::find(names_, sample.datum[2].text()) == names_.end(); });
}

Task<Result<void>> PersonAgent::teach(std::string name) {
  Result<void> taught = fail("not-learned", fmt::format("{} was not taught", name));
  for (int n = 0; n < tries; ++n) {
    const Result<bool> is_known = co_await known(name);
    if (is_known.value_or(false)) co_return {};
    co_await say("teaching"_sym, Datum::string(name));
    taught = co_await teach_once(name);
    if (taught) co_return {};
    const bool was_renamed = co_await renamed(taught.error());
    if (was_renamed) co_return {};
    if (name == end_effector) {
      // The border of the image may cut its mark.
      const Result<void> lowered = co_await lower_arm();
      if (!lowered) co_return taught;
    }
    co_await sleep(context_.executor, pause_between_tries);
  }
  co_return taught;
}

Task<Result<void>> PersonAgent::teach_cell() {
  // Nobody can be taught before somebody has come.
  const Time deadline = context_.executor.now() + longest_wait;
  co_await roles_.wait_for("robot", deadline);
  co_await roles_.wait_for("eyes", deadline);
  Result<void> shown = fail("not-seen", "the end effector was not shown");
  for (int n = 0; n < tries; ++n) {
    shown = co_await show_end_effector();
    if (shown) break;
    co_await sleep(context_.executor, pause_between_tries);
  }
  if (!shown) co_return shown;
  Datum connect = list("connect"_sym);
  const Result<Datum> connected = co_await ask_eyes(std::move(connect));
  if (!connected) co_return fail(connected);
  for (const std::string& name : names_) {
    const Result<void> taught = co_await teach(name);
    if (!taught) co_return taught;
  }
  co_return {};
}

// Learning the next object accepts the one before; nothing is learned after the last. An object that was known already
// needs no acceptance.
Task<void> PersonAgent::accept(std::string name) {
  Datum accepting = list("accept"_sym, Datum::string(name));
  [[maybe_unused]] const Result<Datum> accepted = co_await ask_eyes(std::move(accepting));
}

Task<void> PersonAgent::teach_all() {
  const Result<void> taught = co_await teach_cell();
  if (taught) {
    std::vector<Datum> taught_names;
    for (const std::string& name : names_) taught_names.push_back(Datum::string(name));
    co_await say("done"_sym, Datum::list(std::move(taught_names)));
    co_await accept(names_.back());
    co_return;
  }
  co_await say("failed"_sym, failure_to_datum(taught.error()));
}

Task<Result<Datum>> PersonAgent::serve(Datum operation) {
  const std::string name(operation[1].text());
  const Result<void> taught = co_await teach(name);
  if (!taught) co_return fail(taught);
  co_await accept(name);
  co_return Datum();
}

Task<Result<void>> PersonAgent::run() {
  names_.insert(names_.begin(), end_effector);
  const Result<void> started = co_await service_.start();
  if (!started) co_return started;
  roles_.start();
  const Job teaching = context_.executor.spawn(teach_all());
  runtime::Handler handler = [this](Datum operation) { return serve(std::move(operation)); };
  co_return co_await service_.serve(std::move(handler));
}

}  // namespace pizarra::person
