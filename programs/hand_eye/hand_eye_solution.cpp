#include "programs/hand_eye/hand_eye_solution.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lisp/numbers.hpp"
#include "lisp/writer.hpp"
#include "programs/hand_eye/head_fit.hpp"

namespace pizarra::hand_eye {

namespace {

using coordinator::MarkPair;

constexpr std::size_t least_pairs = 10;
constexpr double least_turning_deg = 20;
constexpr double least_head_turning_deg = 8;  // from the one side to the other, each axis
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

constexpr const char* what_to_do =
    "see to it that the camera looks at the row, that nothing stands before the gripper, and that the light is even";
constexpr const char* what_to_do_with_head =
    "see to it that the camera sits tight on the unit, and that the cell file says which of its axes count the other "
    "way "
    "round (reversed)";

// A fit's deviations are of a camera that sees as well as expected; how well these pairs agree says how well this one
// does.
double noise_of(double error_px) { return std::max(error_px, least_error_px) / expected_error_px; }

Result<void> check_seen(const SeenPairs& seen, std::string_view what) {
  if (seen.pairs.size() >= least_pairs) return {};
  return fail("mark-hidden", fmt::format("{} was seen at {} of {} {}, {} are needed: {}", hand_mark, seen.pairs.size(),
                                         seen.tried, what, least_pairs, what_to_do));
}

Result<void> check_turning(const std::vector<MarkPair>& pairs) {
  double most_deg = 0;
  for (const MarkPair& one : pairs) {
    for (const MarkPair& other : pairs) {
      const Eigen::Matrix3d between = one.tool.linear().transpose() * other.tool.linear();
      most_deg = std::max(most_deg, degrees(Eigen::AngleAxisd(between).angle()));
    }
  }
  if (most_deg >= least_turning_deg) return {};
  return fail("too-little-turning",
              fmt::format("the tool was turned by {:.0f} degrees in all, {:.0f} are needed to tell where the mark is "
                          "on it: make room for the wrist to turn, or take more poses (--poses)",
                          most_deg, least_turning_deg));
}

Result<void> check_head_turning(const std::vector<MarkPair>& pairs) {
  const auto width_deg = [&](double ptu::HeadTurn::*axis) {
    const auto angle = [axis](const MarkPair& pair) { return pair.head.*axis; };
    const auto [low, high] = std::ranges::minmax(pairs, {}, angle);
    return angle(high) - angle(low);
  };
  const double pan_deg = width_deg(&ptu::HeadTurn::pan_deg);
  const double tilt_deg = width_deg(&ptu::HeadTurn::tilt_deg);
  if (std::min(pan_deg, tilt_deg) >= least_head_turning_deg) return {};
  return fail("too-little-turning",
              fmt::format("the head panned by {:.0f} degrees and tilted by {:.0f} with the mark in view, {:.0f} are "
                          "needed of each: see to it that nothing keeps it from turning, and that the camera looks at "
                          "the row while it is in its middle",
                          pan_deg, tilt_deg, least_head_turning_deg));
}

struct Parts {
  std::vector<MarkPair> solved_from;
  std::vector<MarkPair> held_back;
};

Parts parts_of(const std::vector<MarkPair>& pairs) {
  Parts parts;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    (i % hold_back_each == hold_back_each - 1 ? parts.held_back : parts.solved_from).push_back(pairs[i]);
  }
  return parts;
}

// Where the mark is placed, from where the arm says it is: root mean square.
double off_mm(const coordinator::MountedCamera& camera, const std::vector<MarkPair>& pairs,
              const coordinator::CameraModel& model) {
  double squares = 0;
  for (const MarkPair& pair : pairs) {
    const coordinator::CameraView view(camera.pose, model, pair.head);
    const double depth = model.focal_px * model.base_line_mm / pair.seen.z();
    const Eigen::Vector3d seen((pair.seen.x() - model.centre_x_px) * depth / model.focal_px - model.base_line_mm / 2,
                               (pair.seen.y() - model.centre_y_px) * depth / model.focal_px, depth);
    squares += (view.from_camera(seen) - pair.tool * camera.mark_mm).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(pairs.size()));
}

coordinator::MountedCamera mounted(const forms::BelievedCamera& camera) {
  return {camera.pose, Eigen::Vector3d(camera.mark_mm.data())};
}

forms::BelievedCamera believed(const coordinator::MountedCamera& camera, double sure_mm, double sure_deg) {
  return {.pose = camera.pose,
          .sure_mm = sure_mm,
          .sure_deg = sure_deg,
          .mark_mm = {camera.mark_mm.x(), camera.mark_mm.y(), camera.mark_mm.z()}};
}

struct Certainty {
  double sure_mm;
  double sure_deg;
  double checked_mm;
};

Result<void> check_sure(std::string_view what, const Certainty& found, std::string_view advice) {
  if (found.sure_mm <= most_unsure_mm && found.sure_deg <= most_unsure_deg && found.checked_mm <= most_checked_mm) {
    return {};
  }
  return fail("uncertain",
              fmt::format("{} is known to {:.1f} mm and {:.2f} degrees, and in the looks held back the mark is {:.1f} "
                          "mm off: take more poses (--poses), and {}",
                          what, found.sure_mm, found.sure_deg, found.checked_mm, advice));
}

Datum axis_section(std::string_view name, const forms::HeadAxis& axis) {
  const auto rounded_to = [](double parts, const std::array<double, 3>& three, Datum first) {
    return list(std::move(first), rounded(three[0], parts), rounded(three[1], parts), rounded(three[2], parts));
  };
  return list(Datum::symbol(name), rounded_to(1e3, axis.at_mm, "at"_sym), rounded_to(1e5, axis.along, "along"_sym));
}

double thousandths(double value) { return rounded(value, 1000); }

}  // namespace

Result<HandEyeResult> solve_hand_eye(const forms::BelievedCamera& guess, const SeenPairs& seen,
                                     const coordinator::CameraModel& model) {
  const Result<void> enough = check_seen(seen, "poses");
  if (!enough) return fail(enough);
  const Result<void> turned = check_turning(seen.pairs);
  if (!turned) return fail(turned);
  const Parts parts = parts_of(seen.pairs);
  const coordinator::MountFit fit = coordinator::fit_mount(mounted(guess), hardly_sure, parts.solved_from, model);
  const Eigen::Matrix<double, 9, 1> variances = fit.covariance.diagonal();
  const double noise = noise_of(fit.error_px);
  const double sure_mm = noise * std::sqrt(variances.segment<3>(0).maxCoeff());
  const double sure_deg = noise * std::sqrt(variances.segment<3>(3).maxCoeff());
  const HandEyeResult result{.camera = believed(fit.camera, sure_mm, sure_deg),
                             .poses = parts.solved_from.size(),
                             .error_px = fit.error_px,
                             .held_back = parts.held_back.size(),
                             .checked_mm = off_mm(fit.camera, parts.held_back, model),
                             .head = {}};
  const Result<void> sure = check_sure("the camera's place", {sure_mm, sure_deg, result.checked_mm}, what_to_do);
  if (!sure) return fail(sure);
  return result;
}

Result<HandEyeResult> solve_head(const HandEyeResult& unturned, const SeenPairs& seen, const SeenPairs& turned,
                                 const coordinator::CameraModel& model) {
  const Result<void> enough = check_seen(turned, "angles of the head");
  if (!enough) return fail(enough);
  const Result<void> wide = check_head_turning(turned.pairs);
  if (!wide) return fail(wide);
  const Parts still = parts_of(seen.pairs);
  const Parts parts = parts_of(turned.pairs);
  std::vector<MarkPair> solved_from = still.solved_from;
  solved_from.insert(solved_from.end(), parts.solved_from.begin(), parts.solved_from.end());
  const HeadFit fit = fit_head(mounted(unturned.camera), solved_from, model);
  const double noise = noise_of(fit.error_px);
  const HandEyeResult::Head head{.angles = parts.solved_from.size(),
                                 .held_back = parts.held_back.size(),
                                 .checked_mm = off_mm(fit.camera, parts.held_back, model),
                                 .sure_mm = noise * fit.axes_mm,
                                 .sure_deg = noise * fit.axes_deg};
  const HandEyeResult result{.camera = believed(fit.camera, noise * fit.camera_mm, noise * fit.camera_deg),
                             .poses = still.solved_from.size(),
                             .error_px = fit.error_px,
                             .held_back = still.held_back.size(),
                             .checked_mm = off_mm(fit.camera, still.held_back, model),
                             .head = head};
  const Result<void> sure =
      check_sure("an axis of the head", {head.sure_mm, head.sure_deg, head.checked_mm}, what_to_do_with_head);
  if (!sure) return fail(sure);
  return result;
}

std::string write_believed_camera(const forms::BelievedCamera& camera) {
  const forms::CameraPose& pose = camera.pose;
  std::vector<Datum> section{
      "camera-pose"_sym,
      list("at"_sym, thousandths(pose.at_mm[0]), thousandths(pose.at_mm[1]), thousandths(pose.at_mm[2])),
      list("pan"_sym, thousandths(pose.pan_deg)),
      list("tilt"_sym, thousandths(pose.tilt_deg)),
      list("roll"_sym, thousandths(pose.roll_deg)),
      list("sure"_sym, std::max(thousandths(camera.sure_mm), 0.01), std::max(thousandths(camera.sure_deg), 0.001)),
      list("mark"_sym, thousandths(camera.mark_mm[0]), thousandths(camera.mark_mm[1]), thousandths(camera.mark_mm[2]))};
  if (pose.axes) {
    section.push_back(
        list("head"_sym, axis_section("pan-axis", pose.axes->pan), axis_section("tilt-axis", pose.axes->tilt)));
  }
  return write(Datum::list(std::move(section))) + "\n";
}

}  // namespace pizarra::hand_eye
