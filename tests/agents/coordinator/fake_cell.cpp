#include "tests/agents/coordinator/fake_cell.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>

#include "agents/coordinator/geometry/camera_pose.hpp"
#include "agents/planner/agent/planner_agent.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::coordinator {

namespace {

constexpr std::string_view robot_text = R"(
(contract robot
  (offers (retract (mm number)) (extend (keep symbol) (mm number)) (turn (d symbol) (deg number))
          (move-h (d symbol) (mm number)) (move-v (d symbol) (mm number)) (turn-wrist (d symbol) (deg number))
          (ready) (speed (percent number)) (gripper (mm number)) (monitor) (move-to (x number) (y number) (z number)) (finish (option symbol)) (finish (option symbol) (request symbol)))
  (posts (relation gripper ((robot symbol) (opening number)) (key robot))
         (relation arm-pose ((robot symbol) (x number) (y number) (z number) (rx number) (ry number) (rz number))
                   (key robot))
         (relation robot-speed ((robot symbol) (percent number)) (key robot) (durable))
         (relation arm ((robot symbol) (state symbol) (action string)) (key robot))))
)";
constexpr std::string_view vision_text = R"(
(contract vision
  (offers (find (name string)) (track (name string)) (get-objects) (connect))
  (posts (relation look ((eyes symbol) (frame integer) (text string) (of list)) (key eyes))
         (relation camera-model ((eyes symbol) (w integer) (h integer) (f number) (x number) (y number) (b number))
                   (key eyes))))
)";
// Of the fine approach: what is in the way stops the arm no higher above it.
constexpr double longest_step_mm = 40;

Datum form(std::string_view text) { return read_one(text).value(); }

Task<void> serve(runtime::AgentContext& context, std::string_view contract, runtime::Handler handler) {
  runtime::Service service(context, runtime::contract_from_text(contract).value());
  const Result<void> started = co_await service.start();
  if (started) co_await service.serve(std::move(handler));
}

Task<void> live(runtime::Agent& agent) { co_await agent.run(); }

bool is_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double across, double up) {
  return std::abs(a.x() - b.x()) < across && std::abs(a.y() - b.y()) < across && std::abs(a.z() - b.z()) < up;
}

}  // namespace

struct FakeCell::Agents {
  explicit Agents(FakeCell& cell)
      : robot_view(cell.board_.view("robot")),
        vision_view(cell.board_.view("vision")),
        planner_view(cell.board_.view("planner")),
        coordinator_view(std::make_unique<TroubledDisk>(cell.board_, "coordinator", cell.disk)),
        robot{"robot", "localhost", cell.executor_, *robot_view, Random(1)},
        vision{"vision", "localhost", cell.executor_, *vision_view, Random(2)},
        planner{"planner", "localhost", cell.executor_, *planner_view, Random(3)},
        coordinator{"coordinator", "localhost", cell.executor_, *coordinator_view, Random(4)} {}

  std::unique_ptr<Board> robot_view, vision_view, planner_view, coordinator_view;
  runtime::AgentContext robot, vision, planner, coordinator;
  std::unique_ptr<CoordinatorAgent> agent;
  std::unique_ptr<planner::PlannerAgent> planning;
  Job robot_job, vision_job, looking, planner_job, coordinator_job;
};

FakeCell::FakeCell(const std::string& domain_file, Cubes start)
    : cubes(std::move(start)),
      domain_(TaskDomain::read(source_dir() + "/domains/" + domain_file).value()),
      person_(board_.view("person")),
      agents_(std::make_unique<Agents>(*this)) {
  board_.set_journal([this](std::string_view line) { journal_.emplace_back(line); });
  start_robot();
  start_vision();
  start_planner();
  executor_.run_for(300ms);
}

FakeCell::~FakeCell() = default;

void FakeCell::start_robot() {
  runtime::Handler handler = [this](Datum operation) { return handle_robot(std::move(operation)); };
  agents_->robot_job = executor_.spawn(serve(agents_->robot, robot_text, std::move(handler)));
}

void FakeCell::start_vision() {
  runtime::Handler handler = [this](Datum operation) { return handle_vision(std::move(operation)); };
  agents_->vision_job = executor_.spawn(serve(agents_->vision, vision_text, std::move(handler)));
  agents_->looking = executor_.spawn(look());
}

void FakeCell::start_planner() {
  agents_->planning = std::make_unique<planner::PlannerAgent>(agents_->planner);
  agents_->planner_job = executor_.spawn(live(*agents_->planning));
}

void FakeCell::stop_planner() {
  agents_->planner_job = Job();
  agents_->planning.reset();
}

void FakeCell::start_coordinator() {
  CoordinatorOptions options;
  options.domain_file = source_dir() + "/domains/" + domain_.domain().name + ".scm";
  options.camera = believed;
  options.travel_height_mm = travel_mm;
  agents_->agent = std::make_unique<CoordinatorAgent>(agents_->coordinator, options);
  agents_->coordinator_job = executor_.spawn(live(*agents_->agent));
  executor_.run_for(3s);
}

void FakeCell::stop_coordinator() {
  agents_->coordinator_job = Job();
  agents_->agent.reset();
}

void FakeCell::stop_robot() { agents_->robot_job = Job(); }

void FakeCell::stop_vision() {
  agents_->vision_job = Job();
  agents_->looking = Job();
  tracked_.clear();
}

void FakeCell::restart_board() {
  board_.resume();
  executor_.run_for(3s);
}

void FakeCell::tell(std::string_view fact) {
  Transaction telling;
  telling.tell(form(fact));
  EXPECT_TRUE(board_.transact("test", telling));
}

void FakeCell::forget(std::string_view pattern) {
  Transaction retraction;
  retraction.retract(form(pattern));
  EXPECT_TRUE(board_.transact("test", retraction));
}

Datum FakeCell::request(const std::string& agent, std::string_view operation) {
  const Datum id = Datum::symbol(fmt::format("test-{}", ++requests_));
  Transaction ask;
  ask.tell(list("request"_sym, id, Datum::symbol(agent), form(operation)));
  if (!board_.transact("person", ask)) return {};
  const Query query = query_from_datum(list("reply"_sym, id, "?result"_sym)).value();
  const Time deadline = executor_.now() + 60s;
  executor_.run_until([&] { return executor_.now() > deadline || !board_.ask(query)->answers.empty(); });
  const Answers answers = board_.ask(query).value();
  return answers.answers.empty() ? Datum() : answers.answers.front().facts.front().datum[2];
}

bool FakeCell::run_until(std::string_view text, Duration patience) {
  const Query query = query_from_datum(form(text)).value();
  const Time deadline = executor_.now() + patience;
  const auto holds = [&] {
    const Result<Answers> answers = board_.ask(query);
    return answers && !answers->answers.empty();
  };
  executor_.run_until([&] { return executor_.now() > deadline || holds(); });
  return holds();
}

std::vector<Datum> FakeCell::facts(std::string_view pattern) {
  std::vector<Datum> found;
  const Result<Answers> answers = board_.ask(query_from_datum(form(pattern)).value());
  if (!answers) return found;
  for (const Answer& answer : answers->answers) found.push_back(answer.facts.front().datum);
  return found;
}

int FakeCell::times_told(std::string_view pattern) const {
  const Datum wanted = form(pattern);
  int times = 0;
  for (const std::string& line : journal_) {
    const Result<Datum> entry = read_one(line);
    if (!entry) continue;
    for (const Datum& step : entry->items()) {
      Bindings bindings;
      if (step.is_form("tell") && step.size() > 2 && match(wanted, step[2], bindings)) ++times;
    }
  }
  return times;
}

// Low fingers take with them what they meet on a way along y.
void FakeCell::push_along_y(const Eigen::Vector3d& place) {
  const double way = place.y() - grip.y();
  const bool low = std::max(place.z(), grip.z()) < 60 && std::abs(way) > 1;
  if (!low || std::abs(place.x() - grip.x()) > 1) return;
  const double touches = std::copysign(42, way);
  for (auto& [name, cube] : cubes) {
    const double ahead = (cube.y() - grip.y()) / way;
    if (name != held && std::abs(cube.x() - grip.x()) < 45 && cube.z() < 60 && ahead > 0 && ahead < 1)
      cube.y() = place.y() + touches;
  }
}

void FakeCell::move_to(const Eigen::Vector3d& place) {
  ++motions;
  push_along_y(place);
  if (!held.empty()) cubes[held] += place - grip;
  grip = place;
}

void FakeCell::turn_tool(double deg) {
  yaw_deg_ += deg;
  if (faces_deg.contains(held)) faces_deg[held] += deg;
}

void FakeCell::let_go() {
  if (held.empty()) return;
  const std::string cube = std::exchange(held, "");
  double support = 0;
  for (const auto& [name, place] : cubes) {
    const bool below = name != cube && place.z() < cubes[cube].z() && is_near(place, cubes[cube], 30, 1000);
    if (below) support = std::max(support, place.z() + 30);
  }
  cubes[cube].z() = support + 30;
}

void FakeCell::slip(double closes_to_mm) {
  let_go();
  opening_mm = closes_to_mm;
  tell(write(list("gripper"_sym, "robot"_sym, closes_to_mm)));
}

double FakeCell::close_gripper(double wanted_mm) {
  ++motions;
  if (wanted_mm > 60) let_go();
  const bool is_there = lowest_mm == 0 || grip.z() < lowest_mm + longest_step_mm;
  opening_mm = is_there ? std::max(wanted_mm, jam_mm) : wanted_mm;
  if (wanted_mm > 60) return opening_mm;
  for (const auto& [name, place] : cubes) {
    if (!is_near(place, grip, 12, 15)) continue;
    held = name;
    opening_mm = 60;
  }
  return opening_mm;
}

Task<Result<Datum>> FakeCell::handle_robot(Datum operation) {
  const std::string_view name = operation.head();
  const Eigen::Vector3d said = grip + pose_error_mm;
  if (name == "monitor") co_return list(said.x(), said.y(), said.z(), 180.0, 0.0, yaw_deg_);
  if (name == "finish") {
    stopped_by_ = also_stopped_by.value_or(operation);
    stopped_.wake_all();
    co_return list("true"_sym);
  }
  const Time ends = executor_.now() + motion_takes;
  const bool stopped = co_await stopped_.wait(ends);
  if (stopped) co_return fail("stopped", "the arm was stopped", stopped_by_);
  if (!refusal.empty()) {
    const Datum subject = refused_about.value_or(operation);
    co_return fail(refusal, "the test has the robot refuse", subject);
  }
  const bool positive = operation.size() > 1 && (operation[1].is_symbol("right") || operation[1].is_symbol("up"));
  const double amount = (positive ? 1 : -1) * operation[operation.size() - 1].number();
  const Eigen::Vector3d out = Eigen::Vector3d(grip.x(), grip.y(), 0).normalized();
  Eigen::Vector3d to = grip;
  if (name == "gripper") {
    const double opening = stuck_mm.value_or(close_gripper(operation[1].number()));
    const Datum fact = list("gripper"_sym, "robot"_sym, opening);
    co_await agents_->robot_view->tell(fact);
  }
  if (name == "ready") to = {370, 0, 410};
  if (name == "move-v") to.z() += amount;
  if (to.z() < std::min(lowest_mm, grip.z())) co_return fail("stopped", "the arm feels a collision", operation);
  const bool is_near = std::hypot(grip.x(), grip.y()) < nearest_mm;
  if (is_near && to.z() > grip.z() && name == "move-v") co_return fail("unreachable", "beside its foot", operation);
  if (name == "move-h") to.y() += amount;
  if (name == "extend" && !(is_near && operation[2].number() < 0)) to += operation[2].number() * out;
  if (name == "retract" && !is_near) to -= operation[1].number() * out;
  if (name == "turn-wrist") turn_tool(amount);
  if (name == "turn") {
    const double radius = std::hypot(grip.x(), grip.y());
    const double bearing = std::atan2(grip.y(), grip.x()) + amount * std::numbers::pi / 180;
    to = {radius * std::cos(bearing), radius * std::sin(bearing), grip.z()};
    turn_tool(amount);
  }
  if (name == "move-to") to = {operation[1].number(), operation[2].number(), operation[3].number()};
  const Datum moving = "moving"_sym;
  co_await tell_arm(moving);
  move_to(to);
  co_await sleep(executor_, word_late);
  if (tells_pose) co_await tell_pose();
  const Datum idle = "idle"_sym;
  co_await tell_arm(idle);
  co_return list("true"_sym);
}

Task<void> FakeCell::tell_arm(Datum state) {
  const Datum arm = list("arm"_sym, "robot"_sym, state, "");
  co_await agents_->robot_view->tell(arm);
}

Task<void> FakeCell::tell_pose() {
  const Eigen::Vector3d said = grip + pose_error_mm;
  const Datum pose = list("arm-pose"_sym, "robot"_sym, said.x(), said.y(), said.z(), 180.0, 0.0, yaw_deg_);
  co_await agents_->robot_view->tell(pose);
}

Eigen::Vector3d FakeCell::mark_of(const std::string& cube) const {
  const auto turned = faces_deg.find(cube);
  const double yaw = turned == faces_deg.end() ? 0 : turned->second * std::numbers::pi / 180;
  return cubes.at(cube) + 30 * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0);
}

Eigen::Vector3d FakeCell::gripper_mark() const {
  return tool_pose(grip, 180, 0, yaw_deg_) * Eigen::Vector3d(30, 0, -66);
}

Task<Result<Datum>> FakeCell::handle_vision(Datum operation) {
  if (operation.is_form("track")) {
    const std::string name(operation[1].text());
    if (name == eyes_restart_at) {
      tracked_.clear();
      eyes_restart_at.clear();
    }
    tracked_.insert(name);
  }
  std::string text;
  if (operation.is_form("get-objects")) {
    text = fmt::format("(GET {} (\"end-effector\"", cubes.size() + 1);
    for (const auto& [name, place] : cubes) text += fmt::format(", \"{}\"", name);
    text += "))";
  }
  if (operation.is_form("find")) {
    const std::string name(operation[1].text());
    const bool seen = cubes.contains(name) && shows(name);
    text = fmt::format("(FIND \"{}\" {})", name, seen ? "OK (100, 100)" : "FAIL");
  }
  co_return list(text);
}

bool FakeCell::shows(const std::string& name) const { return !hidden.contains(name) && !covered(name); }

// Ten frames a second, told a moment after they were taken.
Task<void> FakeCell::look() {
  const Datum model = list("camera-model"_sym, "vision"_sym, 320, 240, 431.0, 159.5, 119.5, 90.0);
  while (true) {
    co_await sleep(executor_, 60ms);
    const Time captured = executor_.now();
    std::vector<std::pair<std::string, Eigen::Vector3d>> marks{{"end-effector", gripper_mark()}};
    const CameraView view(camera, {});
    for (const auto& [name, place] : cubes) marks.emplace_back(name, mark_of(name));
    std::erase_if(marks, [this](const auto& mark) { return !tracked_.contains(mark.first); });
    std::string text = fmt::format("(TRACK {}", marks.size());
    std::vector<Datum> told;
    for (const auto& [name, place] : marks) {
      const Sight sight = view.sight(place);
      const bool shown = name == "end-effector" ? !mark_hidden() : shows(name);
      const bool seen = shown && sight.y_px > 0;
      text += seen ? fmt::format(" (\"{}\" OK ({:.2f}, {:.2f}, {:.2f}))", name, sight.x_px, sight.y_px, sight.range_mm)
                   : fmt::format(" (\"{}\" FAIL)", name);
      std::vector<Datum> object{to_datum(name), seen ? "seen"_sym : "lost"_sym};
      if (seen && tells_capture) object.push_back(list("captured"_sym, captured.time_since_epoch().count()));
      const auto turned = faces_deg.find(name);
      if (seen && turned != faces_deg.end()) object.push_back(list("face"_sym, turned->second));
      told.push_back(Datum::list(std::move(object)));
    }
    co_await sleep(executor_, 40ms + std::exchange(look_late, 0ms));
    const Datum look = list("look"_sym, "vision"_sym, ++frame_, text + ")", Datum::list(told));
    co_await agents_->vision_view->tell(model);
    if (!tracked_.empty()) co_await agents_->vision_view->tell(look);
  }
}

}  // namespace pizarra::coordinator
