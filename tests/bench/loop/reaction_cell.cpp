#include "tests/bench/loop/reaction_cell.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <stdexcept>

#include "agents/launcher/agent_factory.hpp"
#include "agents/runtime/declared.hpp"
#include "drivers/arm/kinematics.hpp"
#include "drivers/simulation/frame_clock.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/loop/measured_camera.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {

namespace {

constexpr double furthest_y_mm = 120;
constexpr double shove_mm = 30;
// From just after a frame on, so that the next ones show 10, 20 and 30 mm at 60 frames a second, and more at fewer.
constexpr double shove_mm_s = 600;
// So far off a motion under way no longer leads to its target; decided anew, it would be another one sooner.
constexpr double astray_mm = 14;
// More than what the arm leaves uncorrected, and what the eyes are off.
constexpr double noticed_mm = 3;
constexpr double least_motion_mm = 1;
constexpr double rise_mm = 10;
constexpr double any_instant_s = 0.5;
constexpr Duration given_up = 5s;
constexpr Duration between_looks = 20ms;
constexpr Duration telling_pause = 10s;
constexpr std::chrono::minutes life_patience{3};

Duration seconds(double s) { return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s)); }

std::string write_cell(const std::string& folder, int frames_per_s) {
  std::string path = folder + "/cell.scm";
  const forms::BelievedCamera& camera = measured_camera;
  std::ofstream(path) << fmt::format(
      "(cell reaction\n"
      "  (world (camera (at 1315 -9 191) (pan 0.5) (tilt -0.7) (roll 1.8) (rate {}))\n"
      "         (cube circle (at 450 0))\n"
      "         (noise (sensor 3) (blur 0.7) (gradient 0.12)))\n"
      "  (camera-pose (at {}) (pan {}) (tilt {}) (roll {}) (sure {} {}) (mark {}))\n"
      "  (arm crs-f3)\n"
      "  (domain \"{}/domains/blocks.scm\")\n"
      "  (host \"localhost\" (agents robot vision planner coordinator person)))\n",
      frames_per_s, fmt::join(camera.pose.at_mm, " "), camera.pose.pan_deg, camera.pose.tilt_deg, camera.pose.roll_deg,
      camera.sure_mm, camera.sure_deg, fmt::join(camera.mark_mm, " "), source_dir());
  return path;
}

simulation::WorldConfig world_of(const std::string& cell_file, std::uint64_t seed) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(cell_file);
  if (!cell) throw std::runtime_error(describe(cell.error()));
  return launcher::world_config(*cell, seed).value();
}

}  // namespace

ReactionCell::ReactionCell(int frames_per_s, std::uint64_t seed)
    : frames_per_s_(frames_per_s), random_(Random(seed).split("reaction")) {
  const std::string cell = write_cell(folder_.path(), frames_per_s);
  const std::string world_at = "ipc://" + folder_.path() + "/world";
  for (const char* kind : {"robot", "vision", "planner", "coordinator", "person"}) {
    agents_.push_back(Child::program({program_beside("pizarra-agent"), "agent", kind, cell, "--board",
                                      board_process_.address(), "--world", world_at, "--seed", std::to_string(seed)}));
  }
  config_ = world_of(cell, seed);
  world_.emplace(executor_, config_);
  simulation::Devices devices = [this](Datum request) { return hear(std::move(request)); };
  server_ = simulation::LinkServer::listen(executor_, context_, world_at, std::move(devices)).value();
  board_ = client::RemoteBoard::connect(executor_, board_process_.address(), "bench").value();
  await_learned();
  jobs_.push_back(
      executor_.spawn(follow("(servo ?state circle ?x ?y ?d)", [this](const Datum& servo) { take_servo(servo); })));
  jobs_.push_back(executor_.spawn(follow("(goal-state ?n ?state ?why)", [this](const Datum& state) {
    const bool is_over =
        state[1].integer() == goals_ && (state[2].is_symbol("reached") || state[2].is_symbol("refused"));
    if (is_over) wanting_ = executor_.spawn(want(goals_ % 2 == 0 ? "(holding circle)" : "(on-table circle)"));
  })));
  wanting_ = executor_.spawn(want("(holding circle)"));
}

// What there is has been taught.
void ReactionCell::await_learned() {
  bool is_learned = false;
  const Time deadline = executor_.now() + life_patience;
  const Job teaching =
      executor_.spawn(follow("(person done ?names)", [&is_learned](const Datum&) { is_learned = true; }));
  const Executor::TimerId late = executor_.call_at(deadline, [] {});
  executor_.run_until([&] { return is_learned || executor_.now() > deadline; });
  executor_.cancel(late);
  if (!is_learned) throw std::runtime_error("the cell of the reaction rows does not come to life");
}

Task<void> ReactionCell::follow(std::string pattern, std::function<void(const Datum&)> take) {
  const Query query = query_for(read_one(pattern).value());
  const Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(*board_, query);
  while (watch) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    for (const Answer& answer : change->added) take(answer.facts.front().datum);
  }
}

Task<void> ReactionCell::want(std::string goal) {
  ++goals_;
  const Datum form = list("goal"_sym, read_one(goal).value());
  const Datum request = list("request"_sym, Datum::symbol(fmt::format("bench-{}", goals_)), "coordinator"_sym, form);
  co_await board_->tell(request);
}

// States 1 to 3: the fingers are above the cube still.
void ReactionCell::take_servo(const Datum& servo) {
  state_ = servo[1].integer();
  if (is_shoving_ || state_ < 1 || state_ > 3) return;
  is_shoving_ = true;
  shoving_ = executor_.spawn(shove());
}

Task<void> ReactionCell::shove() {
  const Duration instant = seconds(random_.uniform(0, any_instant_s));
  co_await sleep(executor_, instant);
  const bool is_above = state_ >= 1 && state_ <= 3;
  if (is_above) co_await shove_now();
  is_shoving_ = false;
}

Task<void> ReactionCell::shove_now() {
  const Datum truth = list("truth"_sym);
  const Result<simulation::Message> known = co_await world_->handle(truth);
  const double y_mm = known->head[0][3].number();
  const bool is_left = y_mm > furthest_y_mm || (y_mm > -furthest_y_mm && random_.below(2) == 0);
  const double way_mm = is_left ? -shove_mm : shove_mm;
  const Time frame = frame_after(executor_.now());
  const Duration until_frame = frame - executor_.now();
  co_await sleep(executor_, until_frame);
  const Time begun = executor_.now();
  unanswered_ = Shove{y_mm, y_mm + way_mm, frame_after(begun), frame_after(begun + seconds(astray_mm / shove_mm_s))};
  const Datum slide = list("hand"_sym, "slide"_sym, "circle"_sym, 0.0, way_mm, shove_mm_s);
  const Result<simulation::Message> slid = co_await world_->handle(slide);
  if (!slid) unanswered_.reset();
  const auto is_awaited = [&] { return unanswered_ && executor_.now() < begun + given_up; };
  while (is_awaited()) co_await sleep(executor_, between_looks);
  if (unanswered_) reactions_s_.push_back(std::chrono::duration<double>(given_up).count());
  unanswered_.reset();
}

// The first frame that is taken later.
Time ReactionCell::frame_after(Time time) const {
  const simulation::FrameClock clock(time, frames_per_s_);
  return clock.frame_time(clock.next_frame(time, time));
}

Task<Result<simulation::Message>> ReactionCell::hear(Datum request) {
  const Time now = executor_.now();
  const bool commands = request.is_form("arm") && request.size() > 1;
  if (commands && unanswered_ && now >= unanswered_->begins && is_changed(request, *unanswered_)) {
    const Time shown = now < unanswered_->shown ? unanswered_->begins : unanswered_->shown;
    reactions_s_.push_back(std::chrono::duration<double>(now - shown).count());
    unanswered_.reset();
  }
  const bool moves = commands && request[1].is_symbol("move");
  if (moves) grip_mm_ = end_of(request);
  return world_->handle(std::move(request));
}

bool ReactionCell::is_changed(const Datum& command, const Shove& shove) const {
  if (command[1].is_symbol("stop")) return true;
  if (!command[1].is_symbol("move")) return false;
  const Eigen::Vector3d end_mm = end_of(command);
  if (end_mm.z() - grip_mm_.z() > rise_mm) return true;
  const double side = shove.to_mm > shove.from_mm ? 1 : -1;
  return side * (end_mm.y() - shove.from_mm) > noticed_mm && (end_mm - grip_mm_).norm() > least_motion_mm;
}

// (arm move SPEED (J1 ... JN) ...)
Eigen::Vector3d ReactionCell::end_of(const Datum& move) const {
  const Datum& last = move[move.size() - 1];
  arm::Joints joints(last.size());
  for (std::size_t axis = 0; axis < last.size(); ++axis) joints[axis] = last[axis].number();
  return arm::forward(config_.arm, joints).translation();
}

std::vector<double> ReactionCell::measure(int shoves, Duration longest, const std::function<void(std::size_t)>& tell) {
  const Time deadline = executor_.now() + longest;
  const auto wanted = static_cast<std::size_t>(shoves);
  const auto is_over = [&] { return reactions_s_.size() >= wanted || executor_.now() > deadline; };
  while (!is_over()) {
    const Time tells = executor_.now() + telling_pause;
    executor_.run_until([&] { return is_over() || executor_.now() > tells; });
    tell(reactions_s_.size());
  }
  return reactions_s_;
}

}  // namespace pizarra::bench
