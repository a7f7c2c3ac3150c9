#include "programs/hand_eye/hand_eye.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "agents/launcher/agent_factory.hpp"
#include "agents/launcher/readiness.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::hand_eye {

namespace {

using coordinator::MarkPair;

constexpr Duration patience = 40s;
constexpr Duration look_patience = 5s;
constexpr Duration look_pause = 20ms;
// Those under way when the arm came to rest are older.
constexpr int looks_left_out = 2;
constexpr int looks_a_pose = 10;
// At every so many poses the head turns, to so many angles.
constexpr std::size_t turned_each = 4;
constexpr std::size_t angles_a_pose = 6;
constexpr ptu::HeadTurn in_the_middle;

// Of the grip, above the row and before and behind it.
constexpr double around_row_mm = 120;
constexpr double lowest_mm = 150;
constexpr double highest_mm = 330;
constexpr double mark_half_mm = 35;
constexpr double camera_away_mm = 900;

}  // namespace

HandEye::HandEye(Executor& executor, Board& board, const forms::CellDescription& cell, const arm::ArmModel& arm,
                 std::size_t poses, Tell tell)
    : executor_(executor),
      cell_(cell),
      arm_(arm),
      wanted_(poses),
      tell_(std::move(tell)),
      context_{"hand-eye", "localhost", executor, board, Random(1)},
      service_(context_, runtime::contract_from_text("(contract hand-eye)").value()),
      caller_(context_, service_) {}

Task<Result<Datum>> HandEye::ask(std::string agent, Datum operation) {
  return caller_.call(std::move(agent), std::move(operation), patience);
}

Task<Result<std::string>> HandEye::player_of(runtime::Role role) {
  const Result<runtime::Holder> holder = co_await runtime::holder_of(context_.board, context_.name, role);
  if (!holder) co_return fail(holder);
  co_return holder->server;
}

// Nobody else is to move the arm meanwhile.
Task<Result<void>> HandEye::begin() {
  const Result<void> started = co_await service_.start();
  if (!started) co_return started;
  const Result<std::string> robot = co_await player_of(runtime::robot_role());
  const Result<std::string> eyes = co_await player_of(runtime::eyes_role());
  if (!robot || !eyes) co_return fail(robot ? eyes : robot);
  robot_ = *robot;
  eyes_ = *eyes;
  const Datum commands = list("commander"_sym, Datum::symbol(robot_), "hand-eye"_sym);
  Transaction telling;
  telling.tell(commands, {}, service_.presence());
  const Result<Revision> told = co_await context_.board.transact(std::move(telling));
  if (!told) co_return fail(told);
  const std::vector<Datum> wanted{list("connect"_sym), list("track"_sym, hand_mark)};
  for (const Datum& operation : wanted) {
    const Result<Datum> done = co_await ask(eyes_, operation);
    if (!done) co_return fail(done);
  }
  const Datum any = "?"_sym;
  const Datum pattern = list("camera-model"_sym, Datum::symbol(eyes_), any, any, any, any, any, any);
  const Result<std::vector<Fact>> models = co_await context_.board.facts(pattern);
  if (!models) co_return fail(models);
  if (models->empty()) co_return fail("no-camera", "the eyes do not say what their camera is");
  const Result<coordinator::CameraModel> model = coordinator::camera_model_from_fact(models->back().datum);
  if (!model) co_return fail(model);
  if (model->base_line_mm <= 0) {
    co_return fail("no-pair", "one camera alone does not measure how far the mark is: two are needed");
  }
  model_ = *model;
  if (!launcher::has_pan_tilt(cell_)) co_return Result<void>();
  co_return co_await begin_with_head();
}

Task<Result<void>> HandEye::begin_with_head() {
  head_.emplace(executor_, context_.board, caller_);
  const Result<ptu::PanTiltRange> range = co_await head_->range();
  if (!range) co_return fail(range);
  head_range_ = *range;
  const Result<ptu::HeadTurn> ahead = co_await head_->turn_to(in_the_middle);
  if (!ahead) co_return fail(ahead);
  co_return Result<void>();
}

double HandEye::margin_mm() const {
  return mark_half_mm + cell_.camera.sure_mm + radians(cell_.camera.sure_deg) * camera_away_mm;
}

std::vector<CarriedPose> HandEye::poses() const {
  const forms::CubeRow& row = cell_.row;
  const CarryingRoom room{{row.x_mm - around_row_mm, row.y_low_mm, lowest_mm},
                          {row.x_mm + around_row_mm, row.y_high_mm, highest_mm}};
  const forms::BelievedCamera& guess = cell_.camera;
  const Eigen::Vector3d mark(guess.mark_mm[0], guess.mark_mm[1], guess.mark_mm[2]);
  return poses_to_carry_to(arm_, coordinator::CameraView(guess.pose, model_), mark, room, margin_mm(), wanted_);
}

Task<Result<HandEyeResult>> HandEye::run() {
  const Result<void> begun = co_await begin();
  if (!begun) co_return fail(begun);
  const std::vector<CarriedPose> chosen = poses();
  if (chosen.empty()) {
    co_return fail("no-pose",
                   "no pose above the row is within the arm's reach and the camera's view: see where the cell "
                   "file says that the row and the camera are");
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const CarriedPose& pose = chosen[i];
    const Result<void> carried = co_await carry_to(pose);
    const std::string where =
        fmt::format("pose {} of {}, ({:.0f} {:.0f} {:.0f}) turned {:.0f}, tilted {:.0f}", i + 1, chosen.size(),
                    pose.grip_mm.x(), pose.grip_mm.y(), pose.grip_mm.z(), pose.yaw_deg, pose.tilt_deg);
    if (!carried) {
      const std::string& why = carried.error().symbol;
      const bool another = why == "unreachable" || why == "joint-limit" || why == "singular" || why == "out-of-room";
      if (!another) co_return fail(carried);
      tell_(fmt::format("{}: left out, {}", where, carried.error().sentence));
      continue;
    }
    const bool turning = head_ && i % turned_each == 0;
    const Result<void> looked = co_await look_there(where, turning);
    if (!looked) co_return fail(looked);
  }
  unturned_.tried = chosen.size();
  const Result<HandEyeResult> found = solve_hand_eye(cell_.camera, unturned_, model_);
  if (!found || !head_) co_return found;
  co_return solve_head(*found, unturned_, turned_, model_);
}

Task<Result<void>> HandEye::look_there(std::string where, bool turning) {
  const Result<void> looked = co_await look_with(in_the_middle, unturned_, where);
  if (!looked || !turning) co_return looked;
  const Result<Eigen::Isometry3d> at = co_await tool();
  if (!at) co_return fail(at);
  const Result<void> turned = co_await look_turned(*at, where);
  if (!turned) co_return turned;
  const Result<ptu::HeadTurn> ahead = co_await head_->turn_to(in_the_middle);
  if (!ahead) co_return fail(ahead);
  co_return Result<void>();
}

Task<Result<void>> HandEye::look_turned(Eigen::Isometry3d tool, std::string where) {
  const Eigen::Vector3d mark = tool * Eigen::Vector3d(cell_.camera.mark_mm.data());
  const std::vector<ptu::HeadTurn> angles =
      angles_to_turn_to(cell_.camera.pose, model_, mark, head_range_, margin_mm(), angles_a_pose);
  for (const ptu::HeadTurn& angle : angles) {
    ++turned_.tried;
    const Result<ptu::HeadTurn> turned = co_await head_->turn_to(angle);
    if (!turned) co_return fail(turned);
    const std::string there = fmt::format("{}, head {:.2f} {:.2f}", where, turned->pan_deg, turned->tilt_deg);
    const Result<void> looked = co_await look_with(*turned, turned_, there);
    if (!looked) co_return looked;
  }
  co_return Result<void>();
}

Task<Result<void>> HandEye::look_with(ptu::HeadTurn head, SeenPairs& seen, std::string where) {
  const Result<std::optional<MarkPair>> pair = co_await look(head);
  if (!pair) co_return fail(pair);
  tell_(fmt::format("{}: {}", where, *pair ? "seen" : "the mark is not seen"));
  if (*pair) seen.pairs.push_back(**pair);
  co_return Result<void>();
}

// The tool points down again first: a tilted tool is not carried across.
Task<Result<void>> HandEye::carry_to(CarriedPose pose) {
  const Eigen::Vector3d& to = pose.grip_mm;
  const Result<Eigen::Isometry3d> now = co_await tool();
  if (!now) co_return fail(now);
  const double tilted = degrees(std::asin(std::clamp(now->linear()(0, 2), -1.0, 1.0)));
  const double yaw = degrees(std::atan2(now->linear()(1, 0), now->linear()(0, 0)));
  const double turn = std::remainder(pose.yaw_deg - yaw, 360);
  const std::vector<Datum> operations{
      list("turn-ef"_sym, Datum::symbol(tilted > 0 ? "down" : "up"), std::abs(tilted)),
      list("move-to"_sym, rounded(to.x(), 100), rounded(to.y(), 100), rounded(to.z(), 100)),
      list("turn-wrist"_sym, Datum::symbol(turn > 0 ? "right" : "left"), std::abs(turn)),
      list("turn-ef"_sym, "up"_sym, pose.tilt_deg)};
  for (const Datum& operation : operations) {
    const bool nothing = !operation.is_form("move-to") && operation[2].number() < 0.05;
    if (nothing) continue;
    const Result<Datum> done = co_await ask(robot_, operation);
    if (!done) co_return fail(done);
  }
  co_return Result<void>();
}

Task<Result<Eigen::Isometry3d>> HandEye::tool() {
  const Datum monitor = list("monitor"_sym);
  const Result<Datum> at = co_await ask(robot_, monitor);
  if (!at) co_return fail(at);
  if (at->size() < 6) co_return fail("bad-reply", "the robot's monitor gives no pose", *at);
  const Eigen::Vector3d place((*at)[0].number(), (*at)[1].number(), (*at)[2].number());
  co_return coordinator::tool_pose(place, (*at)[3].number(), (*at)[4].number(), (*at)[5].number());
}

// The entry of the mark in the next look, () where it is not seen.
Task<Result<Datum>> HandEye::next_look() {
  const Datum any = "?"_sym;
  const Datum pattern = list("look"_sym, Datum::symbol(eyes_), any, any, any);
  const Time deadline = executor_.now() + look_patience;
  while (executor_.now() < deadline) {
    const Result<std::vector<Fact>> looks = co_await context_.board.facts(pattern);
    if (!looks) co_return fail(looks);
    const bool is_new = !looks->empty() && looks->back().datum[2].integer() != frame_;
    if (!is_new) {
      co_await sleep(executor_, look_pause);
      continue;
    }
    const Datum& look = looks->back().datum;
    frame_ = look[2].integer();
    for (const Datum& entry : look[4].items()) {
      if (entry.size() > 2 && entry[0].is_string() && entry[0].text() == hand_mark && entry[1].is_symbol("seen")) {
        co_return entry;
      }
    }
    co_return Datum();
  }
  co_return fail("absent", "the eyes look at nothing any more", Datum::symbol(eyes_));
}

Task<Result<std::optional<MarkPair>>> HandEye::look(ptu::HeadTurn head) {
  const Result<Eigen::Isometry3d> at = co_await tool();
  if (!at) co_return fail(at);
  MarkPair pair{.tool = *at, .head = head, .seen = {0, 0, 0}, .looks = 0};
  for (int i = 0; i < looks_left_out + looks_a_pose; ++i) {
    const Result<Datum> entry = co_await next_look();
    if (!entry) co_return fail(entry);
    if (i < looks_left_out) continue;
    std::optional<double> x, y, right_x;
    for (const Datum& part : entry->items()) {
      if (part.is_form("left") && part.size() == 3) x = part[1].number(), y = part[2].number();
      if (part.is_form("right") && part.size() == 3) right_x = part[1].number();
    }
    if (!x || !right_x) continue;
    ++pair.looks;
    pair.seen += (coordinator::SeenMark(*x, *y, *x - *right_x) - pair.seen) / pair.looks;
  }
  // A mark that comes and goes is not seen well.
  if (pair.looks < looks_a_pose / 2) co_return std::nullopt;
  co_return pair;
}

Task<Result<HandEyeResult>> find_in_local_cell(launcher::LocalCell& cell, Board& board, HandEye& hand_eye) {
  std::vector<std::string> players{"robot", "vision", "person"};
  if (launcher::has_pan_tilt(cell.description())) players.emplace_back("pan-tilt");
  for (const std::string& kind : players) {
    const Result<void> started = cell.start(kind);
    if (!started) co_return fail(started);
  }
  const Result<void> there = co_await launcher::await_agents(cell, board, players);
  if (!there) co_return fail(there);
  const Result<void> ready = co_await launcher::await_devices(cell, board, players);
  if (!ready) co_return fail(ready);
  const Result<void> taught = co_await launcher::await_teaching(board, cell.executor());
  if (!taught) co_return fail(taught);
  co_return co_await hand_eye.run();
}

}  // namespace pizarra::hand_eye
