#include "agents/robot/robot_agent.hpp"

#include <cmath>

#include "agents/robot/robot_contract.hpp"
#include "agents/robot/robot_state.hpp"
#include "blackboard/away.hpp"
#include "drivers/arm/placement.hpp"

namespace pizarra::robot {

namespace {

constexpr Duration connecting_time = 5s;  // after it, requests are answered `disconnected`
constexpr Duration connecting_pause = 250ms;

// What a reply says, as a handler does.
Result<Datum> result_of(const Datum& reply) {
  if (reply.is_form("fail")) return fail(failure_from_datum(reply));
  return Datum::list({reply.items().begin() + 1, reply.items().end()});
}

runtime::Contract contract_in(const std::string& context) {
  runtime::Contract contract = runtime::contract_from_text(robot_contract).value();
  contract.context = context;
  return contract;
}

}  // namespace

RobotAgent::State::State(runtime::AgentContext given, arm::ArmDriver& driver, arm::ArmModel described,
                         const RobotOptions& options)
    : context(std::move(given)),
      name(Datum::symbol(context.name)),
      model(std::move(described)),
      room(options.room),
      facts(context, service),
      connection(context.executor, driver, model, facts),
      control(context, connection, room, options.told_per_s, facts),
      reflex(context, control),
      holds(context, control),
      service(context, contract_in(options.context)) {}

RobotAgent::RobotAgent(runtime::AgentContext context, arm::ArmDriver& driver, arm::ArmModel model, RobotOptions options)
    : state_(std::make_unique<State>(std::move(context), driver, std::move(model), options)) {}

RobotAgent::~RobotAgent() = default;

Task<Result<void>> RobotAgent::run() { return state_->run(); }

Task<void> RobotAgent::stand_still() {
  constexpr Duration look_pause = 20ms;
  constexpr int looks = 5;  // an order on its way may yet begin
  if (!state_->control.running()) co_return;
  Failure why{"stopped", "the robot agent was ended during this motion, and stopped the arm", {}, {}};
  state_->control.stop_at_once(std::move(why));
  // A board that is away keeps the motion from ending, and not the arm from standing.
  int stood = 0;
  while (state_->control.running() && stood < looks) {
    co_await sleep(state_->context.executor, look_pause);
    const Result<arm::ArmReading> reading = co_await state_->connection.read();
    const bool stands = reading && !reading->moving && !reading->gripper_moving;
    stood = stands ? stood + 1 : 0;
  }
}

Task<Result<void>> RobotAgent::State::run() {
  // At once: what an earlier life of this agent began may go on, and its name is taken for as long as its lease. One
  // that is not there yet is waited for below.
  [[maybe_unused]] const Result<arm::ArmReading> found = co_await connection.find();
  const Result<void> started = co_await service.start();
  if (!started) co_return started;
  const Result<void> restored = co_await restore();
  if (!restored) co_return restored;
  co_await tell_properties();
  const Result<void> connected = co_await connect();
  if (!connected) co_return connected;
  watch = context.executor.spawn(control.keep_watch());
  reflex.begin();
  holds.begin();
  // The agent knows who stops it and who commands it before it obeys anybody.
  co_await reflex.known();
  runtime::RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  co_return co_await service.serve_requests(std::move(handler));
}

Task<Result<std::vector<Fact>>> RobotAgent::State::known(Datum pattern) {
  while (true) {
    const Result<std::vector<Fact>> found = co_await context.board.facts(pattern);
    if (found || !is_away(found.error())) co_return found;
    co_await sleep(context.executor, retry_pause);
  }
}

// Clients find it among others of its kind by these properties. Where the board refuses them, as when its disk is full,
// it serves all the same.
Task<void> RobotAgent::State::tell_properties() {
  Transaction properties;
  properties.tell(
      list("property"_sym, name, "reach"_sym, static_cast<std::int64_t>(std::lround(arm::longest_reach_mm(model)))));
  properties.tell(list("property"_sym, name, "axes"_sym, static_cast<std::int64_t>(model.axes.size())));
  properties.tell(list("property"_sym, name, "arm"_sym, Datum::symbol(model.type)));
  while (true) {
    const Result<Revision> told = co_await context.board.transact(properties);
    if (told || !is_away(told.error())) co_return;
    co_await sleep(context.executor, retry_pause);
  }
}

// What an earlier life of this agent knew. A fact that somebody else mangled is left alone.
Task<Result<void>> RobotAgent::State::restore() {
  const Datum any = "?"_sym;
  const Datum variable = list("robot-variable"_sym, name, any, any);
  const Result<std::vector<Fact>> learned = co_await known(variable);
  if (!learned) co_return fail(learned);
  for (const Fact& fact : *learned) {
    const std::optional<arm::Joints> joints = joints_from_datum(fact.datum[3]);
    const bool fits = joints && joints->size() == model.axes.size();
    if (fits) variables.insert_or_assign(std::string(fact.datum[2].text()), *joints);
  }
  const Datum speed_fact = list("robot-speed"_sym, name, any);
  const Result<std::vector<Fact>> speeds = co_await known(speed_fact);
  if (!speeds) co_return fail(speeds);
  for (const Fact& fact : *speeds) speed_percent = amount_in(fact.datum[2], 1, 100, "percent").value_or(100);
  const Datum released = released_fact(any);
  const Result<std::vector<Fact>> releases = co_await known(released);
  if (!releases) co_return fail(releases);
  for (const Fact& fact : *releases) connection.set_released(std::string(fact.datum[2].text()));
  const Datum any_motion = motion_fact(any, any);
  const Result<std::vector<Fact>> motions = co_await known(any_motion);
  if (!motions) co_return fail(motions);
  for (const Fact& fact : *motions) {
    const Datum& outcome = fact.datum[3];
    const bool ended = outcome.is_form("ok") || outcome.is_form("fail");
    earlier.emplace(fact.datum[2],
                    fail("stopped", "the robot agent was restarted during this motion, and stopped the arm"));
    if (ended) earlier->answer = result_of(outcome);
  }
  co_return {};
}

// Waits a while for a controller that starts together with this agent.
Task<Result<void>> RobotAgent::State::connect() {
  const Time deadline = context.executor.now() + connecting_time;
  Result<void> connected = co_await connection.connect();
  while (!connected) {
    if (connected.error().symbol == "unknown-arm") co_return connected;
    if (context.executor.now() >= deadline) break;
    co_await sleep(context.executor, connecting_pause);
    connected = co_await connection.connect();
  }
  if (!connected) connection.lose(connected.error());
  co_return co_await facts.tell_surely();
}

}  // namespace pizarra::robot
