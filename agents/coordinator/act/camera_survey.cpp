#include "agents/coordinator/act/camera_survey.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "agents/coordinator/geometry/pixel_map.hpp"

namespace pizarra::coordinator {

namespace {

// Before the row and behind it, and inwards from its ends.
constexpr double before_row_mm = 50;
constexpr double behind_row_mm = 90;
constexpr double inwards_mm = 40;
// Between what stands highest and what may hang in the gripper.
constexpr double clear_mm = 40;
// Each waits for the look under way too.
constexpr int looks_of_a_place = 3;
constexpr int times_around = 2;

// While nothing is known of the camera: small ways that show how the mark goes over the image, and further ones for the
// depth. The mark comes to these parts of the image's width and height.
const Eigen::Vector3d first_ways_mm[] = {{0, 0, 0}, {0, 50, 0}, {0, -50, 0}, {0, 0, 50}, {40, 0, 0}};
const Eigen::Vector3d ways_in_depth_mm[] = {{0, 0, 0}, {60, 0, 0}, {-60, 0, 0}};
const Eigen::Vector2d wanted_parts[] = {{0.25, 0.35}, {0.75, 0.35}, {0.5, 0.2}};
constexpr double high_room_mm = 100;  // above the travel height
constexpr double longest_way_mm = 80;
constexpr double shortest_way_mm = 5;
constexpr double aligned_px = 10;
constexpr int most_alignments = 6;

// Another place may do as well.
bool is_of_the_place(const Failure& why) {
  constexpr std::string_view symbols[] = {"unreachable", "joint-limit", "singular", "out-of-room", "stopped"};
  return std::ranges::find(symbols, why.symbol) != std::end(symbols);
}

}  // namespace

// A camera that was moved places it elsewhere than at the grip, and all else still further off.
std::string CameraSurvey::held() const {
  const Scene& scene = surroundings_.scene();
  const std::optional<Eigen::Vector3d> grip = scene.grip_mm();
  if (!grip || !domain_.edge_like(scene.opening_mm().value_or(0))) return {};
  std::string nearest;
  double least_mm = std::numeric_limits<double>::infinity();
  for (const auto& [name, sighting] : scene.sightings().all()) {
    const double apart_mm = (sighting.place_mm - *grip).norm();
    if (name == options_.gripper.mark || apart_mm >= least_mm) continue;
    least_mm = apart_mm;
    nearest = name;
  }
  return nearest;
}

// Above all that is seen, and what hangs in the gripper hangs there too.
double CameraSurvey::lowest_mm() const {
  if (surroundings_.scene().camera().unknown()) return options_.travel_height_mm;
  const std::string in_gripper = held();
  double highest_mm = 0;
  for (const auto& [name, sighting] : surroundings_.scene().sightings().all()) {
    if (name != options_.gripper.mark && name != in_gripper) highest_mm = std::max(highest_mm, sighting.place_mm.z());
  }
  return std::min(highest_mm + 1.5 * domain_.cube_mm() + clear_mm, options_.travel_height_mm);
}

std::vector<Eigen::Vector3d> CameraSurvey::places() const {
  const double near = options_.row.x_mm + before_row_mm;
  const double far = options_.row.x_mm - behind_row_mm;
  const double left = options_.row.y_low_mm + inwards_mm;
  const double right = options_.row.y_high_mm - inwards_mm;
  const double high = options_.travel_height_mm;
  const double low = lowest_mm();
  return {{far, left, high}, {near, right, low}, {far, right, high}, {near, left, low},
          {far, 0, low},     {near, 0, high},    {far, left, low},   {near, right, high}};
}

Task<Result<void>> CameraSurvey::run() {
  const CameraWatch& camera = surroundings_.scene().camera();
  const std::string begins = "finding out where the camera stands: the arm carries its mark before it";
  const Datum nothing;
  co_await story_.tell("servo", begins, nothing);
  const Result<void> raised = co_await runner_.raise();
  const bool unseen = !raised && raised.error().symbol == "lost-sight";
  if (!raised && !unseen) co_return raised;
  const Result<void> squared = co_await arm_.face(0);
  if (!squared) co_return squared;
  if (camera.unknown()) {
    const Result<void> found = co_await find_by_pixels();
    if (!found) co_return found;
  }
  std::size_t seen_at = 0;
  std::size_t tried = 0;
  for (int round = 0; round < times_around; ++round) {
    for (const Eigen::Vector3d& place : places()) {
      const Result<bool> seen = co_await look_from(place);
      if (!seen) co_return fail(seen);
      ++tried;
      seen_at += *seen ? 1 : 0;
      if (camera.known()) co_return Result<void>();
    }
  }
  co_return fail(
      "camera-moved",
      fmt::format("where the camera stands is not known well enough: {} was seen at {} of {} places; see to it "
                  "that the camera looks at the row, or calibrate it (calibrate hand-eye)",
                  options_.gripper.mark, seen_at, tried));
}

Task<Result<void>> CameraSurvey::find_by_pixels() {
  const std::vector<Eigen::Vector3d> first(std::begin(first_ways_mm), std::end(first_ways_mm));
  const Result<void> probed = co_await look_around(first);
  if (!probed) co_return probed;
  const CameraModel& model = surroundings_.scene().view()->model();
  const Eigen::Vector2d image_px(model.width_px, model.height_px);
  const std::vector<Eigen::Vector3d> in_depth(std::begin(ways_in_depth_mm), std::end(ways_in_depth_mm));
  for (const Eigen::Vector2d& part : wanted_parts) {
    const Result<void> aligned = co_await align_pixels(part.cwiseProduct(image_px));
    if (!aligned) co_return aligned;
    const Result<void> looked = co_await look_around(in_depth);
    if (!looked) co_return looked;
  }
  co_return Result<void>();
}

Task<Result<void>> CameraSurvey::align_pixels(Eigen::Vector2d wanted_px) {
  const CameraWatch& camera = surroundings_.scene().camera();
  const Datum mark = Datum::symbol(options_.gripper.mark);
  for (int i = 0; i < most_alignments; ++i) {
    const std::optional<PixelMap> map = PixelMap::from(camera.pairs());
    if (!map || !camera.unknown()) co_return Result<void>();
    const MarkPair& newest = camera.pairs().back();
    const Eigen::Vector2d error = wanted_px - newest.seen.head<2>();
    const ServoPixels errors{error.x(), error.y(), 0};
    const int state = std::abs(error.x()) > aligned_px ? 1 : 3;
    co_await servo_.tell(state, mark, errors);
    const Eigen::Vector3d way = map->way_for(error);
    const double part = std::min(1.0, longest_way_mm / way.norm());
    const Eigen::Vector3d to = within_room(newest.tool.translation() + part * way);
    const bool as_near_as_may_be =
        error.norm() < aligned_px || (to - newest.tool.translation()).norm() < shortest_way_mm;
    if (as_near_as_may_be) co_return Result<void>();
    const Result<bool> seen = co_await look_from(to);
    if (!seen) co_return fail(seen);
  }
  co_return Result<void>();
}

Task<Result<void>> CameraSurvey::look_around(std::vector<Eigen::Vector3d> ways_mm) {
  const Result<Eigen::Vector3d> grip = co_await arm_.grip_centre();
  if (!grip) co_return fail(grip);
  const Eigen::Vector3d& middle = *grip;
  for (const Eigen::Vector3d& way : ways_mm) {
    if (!surroundings_.scene().camera().unknown()) co_return Result<void>();
    const Eigen::Vector3d place = within_room(middle + way);
    const Result<bool> seen = co_await look_from(place);
    if (!seen) co_return fail(seen);
  }
  co_return Result<void>();
}

// Above all that may stand in the row, in which the arm may be anywhere.
Eigen::Vector3d CameraSurvey::within_room(const Eigen::Vector3d& grip_mm) const {
  const forms::CubeRow& row = options_.row;
  return {std::clamp(grip_mm.x(), row.x_mm - behind_row_mm, row.x_mm + before_row_mm),
          std::clamp(grip_mm.y(), row.y_low_mm + inwards_mm, row.y_high_mm - inwards_mm),
          std::clamp(grip_mm.z(), options_.travel_height_mm, options_.travel_height_mm + high_room_mm)};
}

// Straight up, across and down, so that nothing is met on the way.
Task<Result<bool>> CameraSurvey::look_from(Eigen::Vector3d grip_mm) {
  const Result<Eigen::Vector3d> grip = co_await arm_.grip_centre();
  if (!grip) co_return fail(grip);
  const double high = std::max(options_.travel_height_mm, grip_mm.z());
  const Eigen::Vector3d over(grip_mm.x(), grip_mm.y(), high);
  std::vector<Eigen::Vector3d> way;
  if (grip->z() < high) way.emplace_back(grip->x(), grip->y(), high);
  way.push_back(over);
  way.push_back(grip_mm);
  for (const Eigen::Vector3d& place : way) {
    if (interruption_.raised()) co_return interruption_.failure();
    const Result<void> moved = co_await arm_.move_to(place);
    const bool elsewhere = !moved && is_of_the_place(moved.error());
    if (elsewhere) co_return false;
    if (!moved) co_return fail(moved);
  }
  bool seen = false;
  for (int look = 0; look < looks_of_a_place; ++look) {
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return fail(looked);
    seen = seen || surroundings_.scene().sightings().recent(options_.gripper.mark, 1);
  }
  co_return seen;
}

}  // namespace pizarra::coordinator
