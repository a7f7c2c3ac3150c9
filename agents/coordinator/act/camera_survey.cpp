#include "agents/coordinator/act/camera_survey.hpp"

#include <algorithm>
#include <fmt/format.h>

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

// Another place may do as well.
bool is_of_the_place(const Failure& why) {
  constexpr std::string_view symbols[] = {"unreachable", "joint-limit", "singular", "out-of-room", "stopped"};
  return std::ranges::find(symbols, why.symbol) != std::end(symbols);
}

}  // namespace

// Above all that is seen, and what may hang in the gripper hangs there too.
double CameraSurvey::lowest_mm() const {
  double highest_mm = 0;
  for (const auto& [name, sighting] : surroundings_.scene().sightings().all()) {
    if (name != options_.gripper.mark) highest_mm = std::max(highest_mm, sighting.place_mm.z());
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
    if (vigil_.interrupted()) co_return fail("interrupted", "another goal, or none, is wanted now");
    const std::string action = fmt::format("(move {:.2f} {:.2f} {:.2f})", place.x(), place.y(), place.z());
    const Datum move = list("do-action"_sym, action);
    const Result<Datum> moved = co_await arm_.ask(move);
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
