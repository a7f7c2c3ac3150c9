#include "programs/chaos/device_line.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "blackboard/time/latch.hpp"

namespace pizarra::chaos {

namespace {

using simulation::Message;

constexpr Duration way = 100us;
// A client that asks so long after a frame was taken is given the next one.
constexpr Duration behind_a_frame = 1ms;

struct Answer {
  explicit Answer(Executor& asking) : executor(asking), come(asking) {}
  Executor& executor;
  Event come;
  std::optional<Result<Message>> message;
};

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

void brighten(std::span<std::uint8_t> pixels, double light) {
  for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(std::min(255.0, pixel * light));
}

// As far as they are told of the world, both images of a pair.
std::shared_ptr<const Image> disturbed(const Image& image, const DeviceFaults& faults, Time now) {
  auto out = std::make_shared<Image>(image);
  if (now < faults.light_until) brighten(out->pixels, faults.light);
  const auto row_bytes = static_cast<std::ptrdiff_t>(image.width) * image.channels;
  for (int y = 0; y < image.height; ++y) {
    const auto row = out->pixels.begin() + y * row_bytes;
    if (now < faults.jumps_until) {
      std::rotate(row, row + static_cast<std::ptrdiff_t>(faults.jump_px) * image.channels, row + row_bytes);
    }
    if (now < faults.hidden_until) {
      const auto from = static_cast<std::ptrdiff_t>(faults.hidden_at * image.width) * image.channels;
      const std::ptrdiff_t to = std::min(from + row_bytes / 5, row_bytes);
      std::fill(row + from, row + to, std::uint8_t{120});
    }
  }
  return out;
}

void plant_into(Message& frame, WorldProcess& world) {
  constexpr std::size_t two_seconds = 20;
  if (world.plant == "eyes-crossed") std::swap(frame.images[0], frame.images[1]);
  if (world.plant != "images-old") return;
  world.old_images.push_back(frame.images);
  if (world.old_images.size() > two_seconds) world.old_images.pop_front();
  const bool alike = world.old_images.front()[0]->channels == frame.images[0]->channels;
  if (alike) frame.images = world.old_images.front();
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

void disturb(Message& frame, WorldProcess& world, Time now) {
  if (frame.images.size() != 2) return;
  plant_into(frame, world);
  if (now < world.faults.frames_frozen_until) {
    const bool fits = world.frozen_left != nullptr && world.frozen_left->channels == frame.images[0]->channels;
    if (!fits) {
      world.frozen_left = frame.images[0];
      world.frozen_right = frame.images[1];
    }
    frame.images = {world.frozen_left, world.frozen_right};
    return;
  }
  world.frozen_left.reset();
  world.frozen_right.reset();
  const Time changed = std::max({world.faults.jumps_until, world.faults.hidden_until, world.faults.light_until});
  if (now >= changed) return;
  for (auto& image : frame.images) image = disturbed(*image, world.faults, now);
}

Task<Result<Message>> ask_frame(WorldProcess& world, Datum request) {
  while (true) {
    Result<Message> frame = co_await world.world->handle(request);
    const Time now = world.process.now();
    if (now < world.faults.frames_dropped_until) {
      co_await sleep(world.process, behind_a_frame);
      continue;
    }
    const Duration late = now < world.faults.frames_late_until ? world.faults.frame_delay : Duration::zero();
    if (late > Duration::zero()) co_await sleep(world.process, late);
    if (frame) disturb(*frame, world, now);
    co_return frame;
  }
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
  const bool reads = answer && request[1].is_symbol("read") && answer->head.size() == 5;
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

// In the world's process.
Task<void> serve(WorldProcess& world, std::string from, Datum request, std::shared_ptr<Answer> answer) {
  co_await sleep(world.process, way);
  const bool of_arm = is_arm(request);
  if (of_arm && world.process.now() < world.faults.arm_away_until) co_return;
  if (of_arm) hear_client(world);
  if (world.on_request) world.on_request(from, request);
  if (is_frame(request)) {
    answer->message = co_await ask_frame(world, request);
  } else if (of_arm) {
    answer->message = co_await ask_arm(world, request);
  } else {
    answer->message = co_await world.world->handle(request);
  }
  const bool acknowledges = of_arm && !request[1].is_symbol("read");
  const bool late = acknowledges && world.process.now() < world.faults.acks_late_until;
  const Duration back = way + (late ? world.faults.ack_delay : Duration::zero());
  co_await sleep(world.process, back);
  if (of_arm && world.process.now() < world.faults.arm_away_until) co_return;
  answer->come.set();
}

}  // namespace

Task<Result<Message>> DeviceLine::call(Datum request, Duration timeout) {
  const auto answer = std::make_shared<Answer>(process_);
  std::erase_if(world_.jobs, [](const Job& job) { return job.done(); });
  world_.jobs.push_back(world_.process.spawn(serve(world_, name_, std::move(request), answer)));
  const Time deadline = process_.now() + timeout;
  const bool come = co_await answer->come.wait(deadline);
  if (!come) co_return disconnected();
  co_return std::move(*answer->message);
}

}  // namespace pizarra::chaos
