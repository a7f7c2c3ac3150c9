#include "programs/chaos/device_line.hpp"

#include <utility>

#include "programs/chaos/disturbed_frames.hpp"

namespace pizarra::chaos {

namespace {

using simulation::Message;
using simulation::OpenCalls;

constexpr Duration way = 100us;

std::unexpected<Failure> disconnected() { return fail("disconnected", "the device's line is silent"); }

bool is_frame(const Datum& request) { return request.is_form("camera") && request[1].is_symbol("next"); }
bool is_arm(const Datum& request) { return request.is_form("arm"); }
bool is_motion(const Datum& request) {
  return is_arm(request) && (request[1].is_symbol("move") || request[1].is_symbol("gripper"));
}

Message with_opening(const Message& reading, double opening_mm) {
  std::vector<Datum> items(reading.head.items().begin(), reading.head.items().end());
  items[3] = Datum::real(opening_mm);
  return {Datum::list(std::move(items)), reading.images};
}

Message at_rest(const Message& reading) {
  std::vector<Datum> items(reading.head.items().begin(), reading.head.items().end());
  items[1] = "no"_sym;
  return {Datum::list(std::move(items)), reading.images};
}

constexpr std::int64_t alarm_code = 4107;

// A person asks for control, which resets an alarm. Before that the arm moves for nobody, and says why.
Result<void> heeds_alarm(DeviceFaults& faults, const Datum& request) {
  if (request[1].is_symbol("take-control")) faults.alarm = false;
  if (!faults.alarm || !is_motion(request)) return {};
  return fail("not-in-control", "the controller has an alarm", to_datum(alarm_code));
}

Message with_alarm(const Message& reading) {
  std::vector<Datum> items(reading.head.items().begin(), reading.head.items().end());
  items.push_back(list("alarm"_sym, alarm_code));
  return {Datum::list(std::move(items)), reading.images};
}

bool swallows(const WorldProcess& world, const Datum& request) {
  if (!is_arm(request) || !request[1].is_symbol("stop")) return false;
  if (world.plant == "stop-swallowed") return true;
  return world.plant == "stop-swallowed-in-state-3" && world.servo_state() == 3;
}

// The order that follows a stop has the fingers stand.
bool ignores_hold(WorldProcess& world, const Datum& request) {
  constexpr Duration follows = 100ms;
  if (world.plant != "fingers-not-held") return false;
  const Time now = world.process.now();
  if (request[1].is_symbol("stop")) world.stopped_at = now;
  return request[1].is_symbol("gripper") && now - world.stopped_at < follows;
}

Task<void> stop_arm(WorldProcess& world) {
  const Datum stop = list("arm"_sym, "stop"_sym);
  [[maybe_unused]] const Result<Message> stopped = co_await world.world->handle(stop);
}

void hear_client(WorldProcess& world) {
  world.process.cancel(world.silence);
  if (!world.silence_limit || world.plant == "silence-ignored") return;
  world.silence = world.process.call_at(world.process.now() + *world.silence_limit,
                                        [&world] { world.jobs.push_back(world.process.spawn(stop_arm(world))); });
}

// When the motion has ended.
Task<void> repeat_motion(WorldProcess& world) {
  const Datum again = *std::exchange(world.to_repeat, std::nullopt);
  const Result<Message> begun = co_await world.world->handle(again);
  if (begun && world.on_motion) world.on_motion(again);
}

void note_motion(WorldProcess& world, const Datum& request) {
  if (world.plant == "motion-repeated" && request[1].is_symbol("move")) world.to_repeat = request;
  if (world.on_motion) world.on_motion(request);
}

Task<Result<Message>> ask_arm(WorldProcess& world, Datum request) {
  const Time now = world.process.now();
  if (is_motion(request) && now < world.faults.pendant_until) {
    co_return fail("not-in-control", "the pendant has control", list("pendant"_sym));
  }
  const Result<void> heeded = heeds_alarm(world.faults, request);
  if (!heeded) co_return fail(heeded);
  if (swallows(world, request) || ignores_hold(world, request)) co_return Message{};
  const bool heeds_late = world.plant == "stop-heeded-late" && request[1].is_symbol("stop");
  if (heeds_late) co_await sleep(world.process, 100ms);
  Result<Message> answer = co_await world.world->handle(request);
  if (answer && is_motion(request)) note_motion(world, request);
  const bool reads = answer && request[1].is_symbol("read") && answer->head.size() == 6;
  if (!reads) co_return answer;
  const bool rests = answer->head[1].is_symbol("no");
  const bool repeats = world.to_repeat && rests;
  if (repeats) co_await repeat_motion(world);
  if (now >= world.faults.sensor_stuck_until) world.faults.stuck_at_mm.reset();
  if (now < world.faults.sensor_stuck_until && !world.faults.stuck_at_mm) {
    world.faults.stuck_at_mm = answer->head[3].number();
  }
  if (world.plant == "arrives-at-once") answer = at_rest(*answer);
  if (world.faults.stuck_at_mm) answer = with_opening(*answer, *world.faults.stuck_at_mm);
  if (world.faults.alarm) answer = with_alarm(*answer);
  co_return answer;
}

Task<Result<Message>> ask(WorldProcess& world, Datum request) {
  if (is_frame(request)) return ask_frame(world, std::move(request));
  if (is_arm(request)) return ask_arm(world, std::move(request));
  return world.world->handle(std::move(request));
}

// An answer of the world on its way back, by the number of its call.
struct AnswerTo {
  std::weak_ptr<OpenCalls> calls;
  std::uint64_t number = 0;
  bool of_arm = false;
};

Task<void> deliver(WorldProcess& world, AnswerTo answer, Result<Message> message, Duration way_back) {
  co_await sleep(world.process, way_back);
  const bool lost = answer.of_arm && world.process.now() < world.faults.arm_away_until;
  const std::shared_ptr<OpenCalls> calls = answer.calls.lock();
  if (lost) world.arm_lost_at = world.process.now();
  if (!calls || lost) co_return;
  if (answer.of_arm) world.arm_answered_at = world.process.now();
  calls->take(answer.number, std::move(message));
}

// In the world's process.
Task<void> serve(WorldProcess& world, std::string from, Datum request, AnswerTo answer) {
  co_await sleep(world.process, way);
  const bool lost = answer.of_arm && world.process.now() < world.faults.arm_away_until;
  if (lost) world.arm_lost_at = world.process.now();
  if (lost) co_return;
  if (answer.of_arm) hear_client(world);
  if (world.on_request) world.on_request(from, request);
  const bool acknowledges = answer.of_arm && !request[1].is_symbol("read");
  const Result<Message> message = co_await ask(world, std::move(request));
  const Time now = world.process.now();
  const bool late = acknowledges && now < world.faults.acks_late_until;
  const bool twice = acknowledges && now < world.faults.acks_twice_until;
  const Duration back = way + (late ? world.faults.ack_delay : Duration::zero());
  co_await deliver(world, answer, message, back);
  if (twice) co_await deliver(world, answer, message, world.faults.second_ack_after);
}

}  // namespace

Task<Result<Message>> DeviceLine::call(Datum request, Duration timeout) {
  OpenCalls::Call call(*calls_);
  std::erase_if(world_.jobs, [](const Job& job) { return job.done(); });
  const AnswerTo answer{calls_, call.number(), is_arm(request)};
  world_.jobs.push_back(world_.process.spawn(serve(world_, name_, std::move(request), answer)));
  const Time deadline = process_.now() + timeout;
  std::optional<Result<Message>> come = co_await call.answer(deadline);
  if (!come) co_return disconnected();
  co_return std::move(*come);
}

}  // namespace pizarra::chaos
