#include "agents/robot/robot_agent.hpp"

#include <cmath>

#include "agents/robot/moving_operations.hpp"
#include "agents/robot/resting_operations.hpp"
#include "agents/robot/robot_contract.hpp"
#include "blackboard/away.hpp"
#include "drivers/arm/placement.hpp"

namespace pizarra::robot {

namespace {

constexpr Duration connecting_time = 5s;  // after it, requests are answered `disconnected`
constexpr Duration connecting_pause = 250ms;

runtime::Contract contract_in(const std::string& context) {
  runtime::Contract contract = runtime::contract_from_text(robot_contract).value();
  contract.context = context;
  return contract;
}

}  // namespace

struct RobotAgent::State {
  State(runtime::AgentContext given, arm::ArmDriver& driver, arm::ArmModel described, const RobotOptions& options)
      : parts(std::move(given), driver, std::move(described), options, service),
        service(parts.context, contract_in(options.context)) {}

  RobotParts parts;
  MovingOperations moving{parts};
  RestingOperations resting{parts};
  Job watch;
  runtime::Service service;  // last, because its jobs use all the others

  Task<Result<void>> run();
  Task<void> tell_properties();
  Task<Result<void>> connect();
  Task<Result<Datum>> handle(Fact request);
};

RobotAgent::RobotAgent(runtime::AgentContext context, arm::ArmDriver& driver, arm::ArmModel model, RobotOptions options)
    : state_(std::make_unique<State>(std::move(context), driver, std::move(model), options)) {}

RobotAgent::~RobotAgent() = default;

Task<Result<void>> RobotAgent::run() { return state_->run(); }

Task<void> RobotAgent::stand_still() {
  constexpr Duration look_pause = 20ms;
  constexpr int looks = 5;  // an order on its way may yet begin
  if (!state_->parts.control.running()) co_return;
  Failure why{"stopped", "the robot agent was ended during this motion, and stopped the arm", {}, {}};
  state_->parts.control.stop_at_once(std::move(why));
  // A board that is away keeps the motion from ending, and not the arm from standing.
  int stood = 0;
  while (state_->parts.control.running() && stood < looks) {
    co_await sleep(state_->parts.context.executor, look_pause);
    const Result<arm::ArmReading> reading = co_await state_->parts.connection.read();
    const bool stands = reading && !reading->moving && !reading->gripper_moving;
    stood = stands ? stood + 1 : 0;
  }
}

Task<Result<void>> RobotAgent::State::run() {
  // At once: what an earlier life of this agent began may go on, and its name is taken for as long as its lease. One
  // that is not there yet is waited for below.
  [[maybe_unused]] const Result<arm::ArmReading> found = co_await parts.connection.find();
  const Result<void> started = co_await service.start();
  if (!started) co_return started;
  const Result<void> recalled = co_await parts.memory.recall();
  if (!recalled) co_return recalled;
  if (parts.memory.released_by()) parts.connection.set_released(*parts.memory.released_by());
  co_await tell_properties();
  const Result<void> connected = co_await connect();
  if (!connected) co_return connected;
  watch = parts.context.executor.spawn(parts.rest.keep());
  parts.reflex.begin();
  parts.holds.begin();
  // The agent knows who stops it and who commands it before it obeys anybody.
  co_await parts.reflex.known();
  runtime::RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  co_return co_await service.serve_requests(std::move(handler));
}

// Clients find it among others of its kind by these properties. Where the board refuses them, as when its disk is full,
// it serves all the same.
Task<void> RobotAgent::State::tell_properties() {
  const Datum name = Datum::symbol(parts.context.name);
  Transaction properties;
  properties.tell(list("property"_sym, name, "reach"_sym,
                       static_cast<std::int64_t>(std::lround(arm::longest_reach_mm(parts.model)))));
  properties.tell(list("property"_sym, name, "axes"_sym, static_cast<std::int64_t>(parts.model.axes.size())));
  properties.tell(list("property"_sym, name, "arm"_sym, Datum::symbol(parts.model.type)));
  while (true) {
    const Result<Revision> told = co_await parts.context.board.transact(properties);
    if (told || !is_away(told.error())) co_return;
    co_await sleep(parts.context.executor, retry_pause);
  }
}

// Waits a while for a controller that starts together with this agent.
Task<Result<void>> RobotAgent::State::connect() {
  const Time deadline = parts.context.executor.now() + connecting_time;
  Result<void> connected = co_await parts.connection.connect();
  while (!connected) {
    if (connected.error().symbol == "unknown-arm") co_return connected;
    if (parts.context.executor.now() >= deadline) break;
    co_await sleep(parts.context.executor, connecting_pause);
    connected = co_await parts.connection.connect();
  }
  if (!connected) parts.connection.lose(connected.error());
  co_return co_await parts.facts.tell_surely();
}

Task<Result<Datum>> RobotAgent::State::handle(Fact request) {
  if (RestingOperations::is_open_to_all(request.datum[3])) co_return co_await resting.run(std::move(request));
  const Result<Datum>* known = parts.memory.answer_to(request.datum[1]);
  if (known != nullptr) co_return *known;
  const Result<void> allowed = parts.reflex.allows(request.teller);
  if (!allowed) co_return fail(allowed);
  if (MovingOperations::has(request.datum[3])) co_return co_await moving.run(std::move(request));
  co_return co_await resting.run(std::move(request));
}

}  // namespace pizarra::robot
