#include "agents/follower/follower_agent.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "agents/runtime/follow.hpp"
#include "drivers/arm/meeting.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::follower {

namespace {

constexpr const char* contract_text = R"((contract follower
  (offers (follow) (rest))
  (posts (relation following ((slave symbol) (master symbol) (state symbol) (detail list)) (key slave))
         (relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))
         (relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role)))
  (reads agent arm arm-pose bound wired)
  (configures)
  (monitors following)))";

constexpr std::array<const char*, 4> state_names = {"resting", "following", "limited", "broken"};

const Datum any = "?"_sym;

constexpr double nearest_mm = 0.5;                         // a leg that is shorter is not begun
constexpr Duration longest_leg = 60s;                      // more than any move within an arm's reach takes
constexpr Duration stop_answer = arm::stopping_time + 1s;  // a robot agent waits until its arm stands
constexpr Duration busy_pause = 100ms;                     // before the slave is asked again

runtime::Role master_role() { return {"master", "robot", "arms", "robot"}; }
runtime::Role slave_role() { return {"slave", "robot", "second-arms", "slave"}; }

// The slave's answers where it cannot be at a place, rather than cannot go on.
bool is_limit(const Failure& failure) {
  constexpr std::array limits = {"joint-limit", "unreachable", "out-of-room"};
  return std::ranges::find(limits, failure.symbol) != limits.end();
}

}  // namespace

FollowerAgent::FollowerAgent(runtime::AgentContext context, FollowerOptions options)
    : context_(std::move(context)),
      options_(std::move(options)),
      master_(master_role().usual),
      slave_(slave_role().usual),
      told_slave_(slave_),
      changed_(context_.executor),
      service_(context_, runtime::contract_from_text(contract_text).value()),
      caller_(context_, service_),
      roles_(context_, service_, {master_role(), slave_role()}) {}

Task<Result<void>> FollowerAgent::run() {
  const Result<void> started = co_await service_.start();
  if (!started) co_return started;
  roles_.start();
  Executor& executor = context_.executor;
  watching_.push_back(executor.spawn(watch(list("agent"_sym, any, any, any), &FollowerAgent::see_presence)));
  watching_.push_back(executor.spawn(watch(list("arm"_sym, any, any, any), &FollowerAgent::see_arm)));
  Datum pose = list("arm-pose"_sym, any, any, any, any, any, any, any);
  watching_.push_back(executor.spawn(watch(std::move(pose), &FollowerAgent::see_pose)));
  watching_roles_ = executor.spawn(watch_roles());
  const Result<void> rests = co_await enter(State::resting, std::nullopt, false);
  if (!rests) co_return rests;
  runtime::Handler handler = [this](Datum operation) { return handle(std::move(operation)); };
  co_return co_await service_.serve(std::move(handler));
}

Task<void> FollowerAgent::watch(Datum pattern, See see) {
  return runtime::follow(context_, std::move(pattern),
                         [this, see](Change change) { return take(see, std::move(change)); });
}

Task<void> FollowerAgent::take(See see, Change change) {
  (this->*see)(change);
  changed_.wake_all();
  co_return;
}

Task<void> FollowerAgent::watch_roles() {
  while (true) {
    co_await roles_.changed().wait();
    see_role("master", master_);
    see_role("slave", slave_);
  }
}

// Another may stand far from there: it is followed, or moved, only when somebody asks for it.
void FollowerAgent::see_role(const std::string& role, const std::string& taken) {
  const std::string& server = roles_.holder(role).server;
  if (server == taken) return;
  give_up({"replaced", fmt::format("{} is the {} now", server, role), Datum::symbol(server), {}});
}

void FollowerAgent::see_pose(const Change& change) {
  for (const Answer& answer : change.added) {
    const Datum& pose = answer.facts.front().datum;
    mm_[std::string(pose[1].text())] = Eigen::Vector3d(pose[2].number(), pose[3].number(), pose[4].number());
  }
}

void FollowerAgent::see_presence(const Change& change) {
  const std::set<std::string> before = there_;
  if (change.resynchronised) there_.clear();
  for (const Answer& answer : change.removed) there_.erase(std::string(answer.facts.front().datum[1].text()));
  for (const Answer& answer : change.added) there_.emplace(answer.facts.front().datum[1].text());
  // Where one is when it comes back, it has to say itself.
  for (const std::string& agent : before) {
    if (!there_.contains(agent)) mm_.erase(agent);
  }
  if (there_.contains(master_)) return;
  give_up({"absent", fmt::format("{} is gone", master_), Datum::symbol(master_), {}});
}

void FollowerAgent::see_arm(const Change& change) {
  for (const Answer& answer : change.added) {
    const Datum& arm = answer.facts.front().datum;
    if (!arm[1].is_symbol(master_) || !arm[2].is_symbol("fault")) continue;
    give_up({"fault", fmt::format("nobody knows where the arm of {} is", master_), arm, {}});
  }
}

Eigen::Vector3d FollowerAgent::wanted_mm() const {
  const Eigen::Vector3d mirror(1, options_.mirrored ? -1 : 1, 1);
  return mm_.at(master_).cwiseProduct(mirror) + options_.offset_mm;
}

Task<Result<Datum>> FollowerAgent::handle(Datum operation) {
  if (operation.is_form("follow")) return follow();
  return rest();
}

Task<Result<Datum>> FollowerAgent::follow() {
  if (at_work()) co_return Datum();
  const std::string master = roles_.holder("master").server;
  const std::string slave = roles_.holder("slave").server;
  if (!there_.contains(master) || !mm_.contains(master)) {
    co_return fail("absent", fmt::format("{} does not say where its arm is", master), Datum::symbol(master));
  }
  if (!there_.contains(slave)) co_return fail("absent", fmt::format("{} is not there", slave), Datum::symbol(slave));
  master_ = master;
  slave_ = slave;
  given_up_.reset();
  const Result<void> begun = co_await enter(State::following, std::nullopt, true);
  if (!begun) co_return fail(begun);
  going_ = context_.executor.spawn(go_after());
  co_return Datum();
}

Task<Result<Datum>> FollowerAgent::rest() {
  const bool worked = at_work();
  going_ = Job();
  const Result<void> rests = co_await enter(State::resting, std::nullopt, false);
  if (!rests) co_return fail(rests);
  if (worked) co_await stop_slave();
  co_return Datum();
}

// Leg after leg to where the master is by then.
Task<void> FollowerAgent::go_after() {
  std::optional<Eigen::Vector3d> sent_mm;
  while (!given_up_) {
    const Eigen::Vector3d to_mm = wanted_mm();
    const bool there = sent_mm && (to_mm - *sent_mm).norm() < nearest_mm;
    if (there) {
      co_await changed_.wait();
      continue;
    }
    const std::optional<Failure> failure = co_await leg(to_mm);
    if (given_up_) break;
    const bool busy = failure && failure->symbol == "busy";
    if (busy) {
      co_await sleep(context_.executor, busy_pause);
      continue;
    }
    sent_mm = to_mm;
    if (failure && !is_limit(*failure)) {
      given_up_ = failure;
      break;
    }
    const State state = failure ? State::limited : State::following;
    const bool same = !failure && state_ == state;
    if (same) continue;
    const Result<void> said = co_await enter(state, failure, true);
    if (!said) given_up_ = said.error();
  }
  const std::optional<Failure> why = given_up_;
  [[maybe_unused]] const Result<void> ended = co_await enter(State::broken, why, false);
}

Task<std::optional<Failure>> FollowerAgent::leg(Eigen::Vector3d to_mm) {
  const Datum move = list("move-to"_sym, rounded(to_mm.x(), 100), rounded(to_mm.y(), 100), rounded(to_mm.z(), 100));
  const Result<Datum> moved = co_await caller_.call(slave_, move, longest_leg);
  if (moved) co_return std::nullopt;
  co_return moved.error();
}

void FollowerAgent::give_up(Failure why) {
  if (!at_work() || given_up_) return;
  given_up_ = std::move(why);
  changed_.wake_all();
  stopping_ = context_.executor.spawn(stop_slave());
}

Task<void> FollowerAgent::stop_slave() {
  const Datum stop = list("finish"_sym, "stop"_sym);
  [[maybe_unused]] const Result<Datum> stopped = co_await caller_.call(slave_, stop, stop_answer);
}

// Says so, and takes or gives back the command of the slave with it.
Task<Result<void>> FollowerAgent::enter(State state, std::optional<Failure> why, bool commands) {
  state_ = state;
  const Datum slave = Datum::symbol(slave_);
  const Datum name = Datum::symbol(state_names[static_cast<std::size_t>(state)]);
  const Datum detail = why ? failure_to_datum(*why) : Datum::list({});
  Transaction says;
  if (told_slave_ != slave_) says.retract(list("following"_sym, Datum::symbol(told_slave_), any, any, any));
  told_slave_ = slave_;
  says.tell(list("following"_sym, slave, Datum::symbol(master_), name, detail), {}, service_.presence());
  const Datum command = list("commander"_sym, slave, Datum::symbol(context_.name));
  if (commands) says.tell(command, {}, service_.presence());
  if (!commands && commands_) says.retract(command);
  commands_ = commands;
  const Result<Revision> told = co_await context_.board.transact(std::move(says));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

}  // namespace pizarra::follower
