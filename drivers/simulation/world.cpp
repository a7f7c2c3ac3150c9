#include "drivers/simulation/world.hpp"

#include <algorithm>
#include <map>

#include "drivers/camera/stereo_geometry.hpp"
#include "drivers/simulation/arm_requests.hpp"
#include "drivers/simulation/camera_lens.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "drivers/simulation/frame_clock.hpp"
#include "drivers/simulation/hand_request.hpp"
#include "drivers/simulation/head_line.hpp"
#include "drivers/simulation/render/stereo_renderer.hpp"
#include "drivers/simulation/truth.hpp"

namespace pizarra::simulation {

namespace {

// A hand that is busy longer than this has a bug.
constexpr Duration longest_hand_job = 15s;
constexpr Duration hand_poll = 50ms;
// Frames waited for at once.
constexpr std::size_t most_waiting = 64;

}  // namespace

struct World::Inside {
  // A frame that somebody waits for.
  struct Wanted {
    int waiting = 0;
    bool colour = false;
    bool grey = false;
    std::optional<StereoPair> grey_pair;
    std::optional<StereoPair> colour_pair;
  };
  class Wait {
   public:
    Wait(Inside& inside, std::uint64_t frame, bool colour) : inside_(inside), frame_(frame) {
      Wanted& entry = inside.wanted[frame];
      ++entry.waiting;
      (colour ? entry.colour : entry.grey) = true;
    }
    Wait(const Wait&) = delete;
    Wait& operator=(const Wait&) = delete;
    ~Wait() {
      const auto found = inside_.wanted.find(frame_);
      if (--found->second.waiting == 0) inside_.wanted.erase(found);
    }

   private:
    Inside& inside_;
    std::uint64_t frame_;
  };

  Inside(Executor& the_executor, const WorldConfig& the_config)
      : executor(the_executor),
        config(the_config),
        camera_pose(config.camera.pose),
        seen_as(config.camera.bends() ? camera::StereoGeometry(calibration_of(config.camera)).model()
                                      : config.camera.model),
        clock(the_executor.now(), config.camera.frames_per_s),
        cell(config),
        arm(cell, config.arm.type),
        renderer(config, Random(config.seed).split("camera")) {
    steps = clock.steps_until(executor.now());
    const PtuModel* head_model = find_ptu_model(config.camera.head);
    if (head_model != nullptr) head.emplace(executor, *head_model);
    if (config.second_arm) second_arm.emplace(executor, *config.second_arm);
  }

  void advance();
  void take_frame();

  Task<Result<Message>> handle(Datum request);
  Result<Message> tell_truth(const Datum& request);
  // How the cameras look now.
  CameraConfig camera_now();
  Result<Message> bump(const Datum& request);
  Result<Message> nudge(const Datum& request);
  Task<Result<Message>> camera(Datum request);
  Message camera_model() const;
  Message frame_message(std::uint64_t frame, bool colour) const;
  Task<Result<Message>> hand(Datum request);

  Executor& executor;
  const WorldConfig config;
  forms::CameraPose camera_pose;      // where it was bumped to
  ptu::HeadTurn nudged;               // beyond what the unit counts
  const camera::StereoModel seen_as;  // of the images when their users have straightened them
  const FrameClock clock;
  Cell cell;
  PhysicalArm arm;
  std::optional<MovingArm> second_arm;
  StereoRenderer renderer;
  std::optional<HeadLine> head;
  std::int64_t steps = 0;
  std::map<std::uint64_t, Wanted> wanted;
};

void World::Inside::take_frame() {
  if (steps % clock.steps_per_frame() != 0) return;
  const auto found = wanted.find(static_cast<std::uint64_t>(steps / clock.steps_per_frame()));
  if (found == wanted.end()) return;
  Wanted& frame = found->second;
  if (frame.grey && !frame.grey_pair)
    frame.grey_pair = renderer.render(cell.snapshot(), camera_now(), found->first, false);
  if (frame.colour && !frame.colour_pair)
    frame.colour_pair = renderer.render(cell.snapshot(), camera_now(), found->first, true);
}

void World::Inside::advance() {
  const std::int64_t target = clock.steps_until(executor.now());
  take_frame();
  while (steps < target) {
    if (cell.at_rest()) {
      // Nothing changes until somebody looks or acts.
      const std::int64_t look = wanted.empty() ? target : clock.frame_step(wanted.begin()->first);
      steps = look > steps ? std::min(look, target) : steps + 1;
    } else {
      cell.step();
      ++steps;
    }
    take_frame();
  }
}

Task<Result<Message>> World::Inside::handle(Datum request) {
  advance();
  const std::string_view device = request.head();
  if (device == "arm") {
    co_return co_await answer_arm(arm, std::move(request), executor.now());
  }
  if (device == "second-arm") {
    if (!second_arm) co_return fail("bad-request", "there is no second arm in this world", request);
    co_return co_await answer_arm(*second_arm, std::move(request), executor.now());
  }
  if (device == "camera") {
    co_return co_await camera(std::move(request));
  }
  if (device == "head") {
    if (!head) co_return fail("bad-request", "the cameras of this world stand on no pan-tilt unit", request);
    if (word(request, 1) == "nudge") co_return nudge(request);
    co_return co_await head->handle(std::move(request));
  }
  if (device == "hand") {
    co_return co_await hand(std::move(request));
  }
  if (device == "fingers") {
    const Result<void> clumsy = make_clumsy(cell, request);
    if (!clumsy) co_return fail(clumsy);
    co_return Message();
  }
  co_return tell_truth(request);
}

CameraConfig World::Inside::camera_now() {
  CameraConfig camera = config.camera;
  camera.pose = camera_pose;
  if (head) {
    camera.turn = {head->unit().pan_deg() + nudged.pan_deg, head->unit().tilt_deg() + nudged.tilt_deg};
  }
  return camera;
}

Result<Message> World::Inside::tell_truth(const Datum& request) {
  CameraConfig eyes = camera_now();
  eyes.model = seen_as;
  const Eye left = make_eye(eyes, Side::left);
  if (request.is_form("truth")) {
    return Message{truth_of(cell, left, make_eye(eyes, Side::right))};
  }
  if (request.is_form("scene")) return Message{describe_scene(cell, config, camera_pose)};
  if (!request.is_form("where-seen") || request.size() != 2) return bad_request(request);
  const Result<Datum> seen = where_seen(cell, left, word(request, 1));
  if (!seen) return fail(seen);
  return Message{*seen};
}

Result<Message> World::Inside::bump(const Datum& request) {
  const auto parts = request.items().subspan(2);
  if (parts.size() != 6 || !std::ranges::all_of(parts, &Datum::is_number)) return bad_request(request);
  for (std::size_t axis = 0; axis < 3; ++axis) camera_pose.at_mm[axis] += parts[axis].number();
  camera_pose.pan_deg += parts[3].number();
  camera_pose.tilt_deg += parts[4].number();
  camera_pose.roll_deg += parts[5].number();
  return Message();
}

Result<Message> World::Inside::nudge(const Datum& request) {
  const auto parts = request.items().subspan(2);
  if (parts.size() != 2 || !std::ranges::all_of(parts, &Datum::is_number)) return bad_request(request);
  nudged.pan_deg += parts[0].number();
  nudged.tilt_deg += parts[1].number();
  return Message();
}

Task<Result<Message>> World::Inside::camera(Datum request) {
  if (word(request, 1) == "bump") co_return bump(request);
  if (word(request, 1) == "open") co_return camera_model();
  const bool colour = word(request, 3) == "colour";
  const bool sound = word(request, 1) == "next" && request.size() == 4 && request[2].is_integer() &&
                     request[2].integer() >= 0 && (colour || word(request, 3) == "grey");
  if (!sound) co_return bad_request(request);
  if (wanted.size() >= most_waiting) co_return fail("busy", "too many wait for frames");
  const std::uint64_t frame = clock.next_frame(executor.now(), Time(Duration(request[2].integer())));
  const Wait wait(*this, frame, colour);
  const Duration left_over = std::max(Duration::zero(), clock.frame_time(frame) - executor.now());
  co_await sleep(executor, left_over);
  advance();
  co_return frame_message(frame, colour);
}

Message World::Inside::camera_model() const {
  const camera::StereoModel& model = config.camera.model;
  const auto& [k1, k2, p1, p2, k3] = config.camera.lens;
  const auto numbers = [&](auto... of_lens) {
    return Message{list(model.width, model.height, model.focal_px, model.centre_x_px, model.centre_y_px,
                        model.base_line_mm, of_lens...)};
  };
  return config.camera.bends() ? numbers(k1, k2, p1, p2, k3) : numbers();
}

Message World::Inside::frame_message(std::uint64_t frame, bool colour) const {
  const Wanted& taken = wanted.at(frame);
  const StereoPair& pair = colour ? *taken.colour_pair : *taken.grey_pair;
  return {list(frame, clock.frame_time(frame).time_since_epoch().count()), {pair.left, pair.right}};
}

Task<Result<Message>> World::Inside::hand(Datum request) {
  const Result<void> begun = begin_hand(cell, request);
  if (!begun) co_return fail(begun);
  const Time deadline = executor.now() + longest_hand_job;
  while (cell.hand().busy()) {
    if (executor.now() > deadline) co_return fail("timeout", "the hand did not come to an end", request);
    co_await sleep(executor, hand_poll);
    advance();
  }
  co_return Message();
}

World::World(Executor& executor, const WorldConfig& config) : inside_(std::make_unique<Inside>(executor, config)) {}

World::~World() = default;

Task<Result<Message>> World::handle(Datum request) { return inside_->handle(std::move(request)); }

}  // namespace pizarra::simulation
