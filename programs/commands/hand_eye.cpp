#include "programs/commands/hand_eye.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lisp/numbers.hpp"
#include "lisp/writer.hpp"

namespace pizarra::programs {

namespace {

using coordinator::MarkPair;

constexpr const char* mark_name = "end-effector";
constexpr Duration patience = 40s;
constexpr Duration look_patience = 5s;
constexpr Duration look_pause = 20ms;
// Those under way when the arm came to rest are older.
constexpr int looks_left_out = 2;
constexpr int looks_a_pose = 10;
constexpr std::size_t least_poses = 10;
constexpr double least_turning_deg = 20;
constexpr std::size_t hold_back_each = 4;
// What a result must reach.
constexpr double most_unsure_mm = 2;
constexpr double most_unsure_deg = 0.2;
constexpr double most_checked_mm = 4;
// The error that a fit expects in the mean of ten looks, and the least that it takes any camera to have.
constexpr double expected_error_px = 0.2;
constexpr double least_error_px = 0.05;
// Whatever the cell file says, it may be far off.
constexpr coordinator::Sureness hardly_sure{.at_mm = 300, .turned_deg = 15, .mark_mm = 10};

// Of the grip, above the row and before and behind it.
constexpr double around_row_mm = 120;
constexpr double lowest_mm = 150;
constexpr double highest_mm = 330;
constexpr double mark_half_mm = 35;
constexpr double camera_away_mm = 900;

constexpr const char* what_to_do =
    "see to it that the camera looks at the row, that nothing stands before the gripper, and that the light is even";

double turning_deg(const std::vector<MarkPair>& pairs) {
  double most = 0;
  for (const MarkPair& one : pairs) {
    for (const MarkPair& other : pairs) {
      const Eigen::Matrix3d between = one.tool.linear().transpose() * other.tool.linear();
      most = std::max(most, degrees(Eigen::AngleAxisd(between).angle()));
    }
  }
  return most;
}

// Where the mark is placed, from where the arm says it is.
double off_mm(const coordinator::MountFit& fit, const MarkPair& pair, const coordinator::CameraModel& model) {
  const coordinator::CameraView view(fit.camera.pose, model, pair.head);
  const double depth = model.focal_px * model.base_line_mm / pair.seen.z();
  const Eigen::Vector3d seen((pair.seen.x() - model.centre_x_px) * depth / model.focal_px - model.base_line_mm / 2,
                             (pair.seen.y() - model.centre_y_px) * depth / model.focal_px, depth);
  return (view.from_camera(seen) - pair.tool * fit.camera.mark_mm).norm();
}

double thousandths(double value) { return rounded(value, 1000); }

}  // namespace

Result<HandEyeResult> solve_hand_eye(const forms::BelievedCamera& guess, const std::vector<MarkPair>& pairs,
                                     std::size_t tried, const coordinator::CameraModel& model) {
  if (pairs.size() < least_poses) {
    return fail("mark-hidden", fmt::format("{} was seen at {} of {} poses, {} are needed: {}", mark_name, pairs.size(),
                                           tried, least_poses, what_to_do));
  }
  const double turning = turning_deg(pairs);
  if (turning < least_turning_deg) {
    return fail(
        "too-little-turning",
        fmt::format("the tool was turned by {:.0f} degrees in all, {:.0f} are needed to tell where the mark is on "
                    "it: make room for the wrist to turn, or take more poses (--poses)",
                    turning, least_turning_deg));
  }
  std::vector<MarkPair> solved_from;
  std::vector<MarkPair> held_back;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    (i % hold_back_each == hold_back_each - 1 ? held_back : solved_from).push_back(pairs[i]);
  }
  const coordinator::MountedCamera guessed{guess.pose, {guess.mark_mm[0], guess.mark_mm[1], guess.mark_mm[2]}};
  const coordinator::MountFit fit = coordinator::fit_mount(guessed, hardly_sure, solved_from, model);
  double squares = 0;
  for (const MarkPair& pair : held_back) squares += std::pow(off_mm(fit, pair, model), 2);
  HandEyeResult result{.camera = {.pose = fit.camera.pose},
                       .poses = solved_from.size(),
                       .error_px = fit.error_px,
                       .held_back = held_back.size(),
                       .checked_mm = std::sqrt(squares / static_cast<double>(held_back.size()))};
  // How well these pairs agree says how well this camera sees.
  const double noise = std::max(fit.error_px, least_error_px) / expected_error_px;
  const Eigen::Matrix<double, 9, 1> variances = fit.covariance.diagonal();
  result.camera.sure_mm = noise * std::sqrt(variances.segment<3>(0).maxCoeff());
  result.camera.sure_deg = noise * std::sqrt(variances.segment<3>(3).maxCoeff());
  for (std::size_t i = 0; i < 3; ++i) result.camera.mark_mm[i] = fit.camera.mark_mm[static_cast<Eigen::Index>(i)];
  if (result.camera.sure_mm <= most_unsure_mm && result.camera.sure_deg <= most_unsure_deg &&
      result.checked_mm <= most_checked_mm) {
    return result;
  }
  return fail(
      "uncertain",
      fmt::format("the camera's place is known to {:.1f} mm and {:.2f} degrees, and at the poses held back the mark "
                  "is {:.1f} mm off: take more poses (--poses), and {}",
                  result.camera.sure_mm, result.camera.sure_deg, result.checked_mm, what_to_do));
}

std::string write_believed_camera(const forms::BelievedCamera& camera) {
  const forms::CameraPose& pose = camera.pose;
  const Datum section = list(
      "camera-pose"_sym,
      list("at"_sym, thousandths(pose.at_mm[0]), thousandths(pose.at_mm[1]), thousandths(pose.at_mm[2])),
      list("pan"_sym, thousandths(pose.pan_deg)), list("tilt"_sym, thousandths(pose.tilt_deg)),
      list("roll"_sym, thousandths(pose.roll_deg)),
      list("sure"_sym, std::max(thousandths(camera.sure_mm), 0.01), std::max(thousandths(camera.sure_deg), 0.001)),
      list("mark"_sym, thousandths(camera.mark_mm[0]), thousandths(camera.mark_mm[1]), thousandths(camera.mark_mm[2])));
  return write(section) + "\n";
}

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
  const std::vector<Datum> wanted{list("connect"_sym), list("track"_sym, mark_name)};
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
  co_return Result<void>();
}

std::vector<CarriedPose> HandEye::poses() const {
  const forms::CubeRow& row = cell_.row;
  const CarryingRoom room{{row.x_mm - around_row_mm, row.y_low_mm, lowest_mm},
                          {row.x_mm + around_row_mm, row.y_high_mm, highest_mm}};
  const forms::BelievedCamera& guess = cell_.camera;
  const double unsure = guess.sure_mm + radians(guess.sure_deg) * camera_away_mm;
  const Eigen::Vector3d mark(guess.mark_mm[0], guess.mark_mm[1], guess.mark_mm[2]);
  return poses_to_carry_to(arm_, coordinator::CameraView(guess.pose, model_), mark, room, mark_half_mm + unsure,
                           wanted_);
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
  std::vector<MarkPair> pairs;
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
    const Result<std::optional<MarkPair>> pair = co_await look();
    if (!pair) co_return fail(pair);
    tell_(fmt::format("{}: {}", where, *pair ? "seen" : "the mark is not seen"));
    if (*pair) pairs.push_back(**pair);
  }
  co_return solve_hand_eye(cell_.camera, pairs, chosen.size(), model_);
}

// The tool points down again first: a tilted tool is not carried across.
Task<Result<void>> HandEye::carry_to(CarriedPose pose) {
  const std::string move =
      fmt::format("(move {:.2f} {:.2f} {:.2f})", pose.grip_mm.x(), pose.grip_mm.y(), pose.grip_mm.z());
  const Result<Eigen::Isometry3d> now = co_await tool();
  if (!now) co_return fail(now);
  const double tilted = degrees(std::asin(std::clamp(now->linear()(0, 2), -1.0, 1.0)));
  const double yaw = degrees(std::atan2(now->linear()(1, 0), now->linear()(0, 0)));
  const double turn = std::remainder(pose.yaw_deg - yaw, 360);
  const std::vector<Datum> operations{
      list("turn-ef"_sym, Datum::symbol(tilted > 0 ? "down" : "up"), std::abs(tilted)), list("do-action"_sym, move),
      list("turn-wrist"_sym, Datum::symbol(turn > 0 ? "right" : "left"), std::abs(turn)),
      list("turn-ef"_sym, "up"_sym, pose.tilt_deg)};
  for (const Datum& operation : operations) {
    const bool nothing = !operation.is_form("do-action") && operation[2].number() < 0.05;
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
      if (entry.size() > 2 && entry[0].is_string() && entry[0].text() == mark_name && entry[1].is_symbol("seen")) {
        co_return entry;
      }
    }
    co_return Datum();
  }
  co_return fail("absent", "the eyes look at nothing any more", Datum::symbol(eyes_));
}

Task<Result<std::optional<MarkPair>>> HandEye::look() {
  const Result<Eigen::Isometry3d> at = co_await tool();
  if (!at) co_return fail(at);
  MarkPair pair{.tool = *at, .head = {}, .seen = {0, 0, 0}, .looks = 0};
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

}  // namespace pizarra::programs
