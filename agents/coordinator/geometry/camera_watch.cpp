#include "agents/coordinator/geometry/camera_watch.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

constexpr std::size_t most_pairs = 24;
// Of looks that do not agree the newest count: somebody may knock against the camera again.
constexpr std::size_t most_strange_pairs = 3;
constexpr int most_looks_of_a_place = 10;
constexpr double same_place_mm = 2;
constexpr double same_turn = 0.01;  // rad
constexpr double same_head_deg = 0.01;
// Corrections smaller than this would only make everything jump.
constexpr double least_shift_mm = 1.5;
constexpr double sure_deviations = 2;
constexpr int strange_looks = 5;
constexpr int strange_looks_of_a_place = 3;
constexpr double elsewhere_mm = 40;
// Looks that tell of one pose agree with it so well.
constexpr double one_pose_px = 1;
// Of three places one may be wrong, and bend the pose so that it agrees with all of them.
constexpr std::size_t least_places = 4;
constexpr double mark_sure_mm = 0.5;
constexpr Sureness after_a_move{.at_mm = 30, .turned_deg = 3, .mark_mm = mark_sure_mm};
constexpr Sureness as_measured{.at_mm = 1.5, .turned_deg = 0.15, .mark_mm = mark_sure_mm};

bool same_place(const MarkPair& one, const MarkPair& other) {
  return (one.tool.translation() - other.tool.translation()).norm() < same_place_mm &&
         Eigen::AngleAxisd(one.tool.linear().transpose() * other.tool.linear()).angle() < same_turn &&
         std::abs(one.head.pan_deg - other.head.pan_deg) < same_head_deg &&
         std::abs(one.head.tilt_deg - other.head.tilt_deg) < same_head_deg;
}

// False where that place has been looked at often enough.
bool add(std::vector<MarkPair>& pairs, const MarkPair& pair, std::size_t most) {
  const auto known = std::ranges::find_if(pairs, [&](const MarkPair& other) { return same_place(pair, other); });
  if (known == pairs.end()) {
    if (pairs.size() == most) pairs.erase(pairs.begin());
    pairs.push_back(pair);
    return true;
  }
  if (known->looks >= most_looks_of_a_place) return false;
  ++known->looks;
  known->seen += (pair.seen - known->seen) / known->looks;
  return true;
}

// That lie apart from each other.
std::size_t places_in(const std::vector<MarkPair>& pairs) {
  std::vector<Eigen::Vector3d> places;
  for (const MarkPair& pair : pairs) {
    const Eigen::Vector3d at = pair.tool.translation();
    const bool is_new =
        std::ranges::all_of(places, [&](const Eigen::Vector3d& place) { return (at - place).norm() >= elsewhere_mm; });
    if (is_new) places.push_back(at);
  }
  return places.size();
}

int looks_in(const std::vector<MarkPair>& pairs) {
  int looks = 0;
  for (const MarkPair& pair : pairs) looks += pair.looks;
  return looks;
}

}  // namespace

CameraWatch::CameraWatch(const forms::BelievedCamera& guess, const forms::CubeRow& row)
    : guess_{guess.pose, {guess.mark_mm[0], guess.mark_mm[1], guess.mark_mm[2]}}, pose_(guess.pose) {
  constexpr double low_mm = 30;
  constexpr double high_mm = 200;
  for (const double y : {row.y_low_mm, row.y_high_mm}) {
    for (const double z : {low_mm, high_mm}) row_.emplace_back(row.x_mm, y, z);
  }
  begin_anew({guess.sure_mm, guess.sure_deg, mark_sure_mm}, {}, {});
  unknown_ = guess.unknown;
}

void CameraWatch::go_on_from(const CameraMeasured& measured) {
  pose_ = measured.pose;
  pose_.axes = guess_.pose.axes;
  unknown_ = false;
  begin_anew(as_measured, {}, {});
  doubtful_ = measured.is_doubtful;
}

void CameraWatch::begin_anew(const Sureness& sure, std::vector<MarkPair> pairs, const CameraModel& model) {
  guess_.pose = pose_;
  sure_ = sure;
  pairs_ = std::move(pairs);
  strange_.clear();
  agreeing_.clear();
  doubtful_ = false;
  fit(model);
  // A guess that is so sure was measured by others.
  confirmed_ = pairs_.empty() && spread_mm_ <= most_spread_mm;
}

void CameraWatch::place_by(const forms::CameraPose& pose) {
  shift_mm_ = 0;
  for (const Eigen::Vector3d& point : row_) shift_mm_ = std::max(shift_mm_, apart_mm(pose_, pose, point));
  pose_ = pose;
}

CameraWatch::News CameraWatch::take(const MarkPair& pair, const CameraModel& model) {
  if (unknown_) return take_first(pair, model);
  return surprise(fit_, pair, model).is_one() ? take_strange(pair, model) : take_agreeing(pair, model);
}

CameraWatch::News CameraWatch::take_first(const MarkPair& pair, const CameraModel& model) {
  if (!add(pairs_, pair, most_pairs)) return News::nothing;
  const std::optional<forms::CameraPose> found = pose_from_pairs(guess_.mark_mm, pairs_, model);
  if (!found) return News::nothing;
  unknown_ = false;
  pose_ = *found;
  begin_anew(after_a_move, pairs_, model);
  place_by(fit_.camera.pose);
  return News::found;
}

CameraWatch::News CameraWatch::take_agreeing(const MarkPair& pair, const CameraModel& model) {
  const bool is_new = add(pairs_, pair, most_pairs);
  if (is_new) fit(model);
  std::erase_if(strange_, [&](const MarkPair& other) { return same_place(pair, other); });
  outvote_strange(pair);
  confirmed_ = confirmed_ || is_confirmed();
  if (!is_new) return News::nothing;
  double off_mm = 0;
  for (const Eigen::Vector3d& point : row_) off_mm = std::max(off_mm, apart_mm(pose_, fit_.camera.pose, point));
  if (off_mm < least_shift_mm || off_mm < sure_deviations * spread_mm_) return News::nothing;
  place_by(fit_.camera.pose);
  return News::corrected;
}

// A camera that was turned about the line of sight to a place shows the mark there as before.
void CameraWatch::outvote_strange(const MarkPair& agreeing) {
  add(agreeing_, agreeing, most_pairs);
  if (places_in(agreeing_) < places_in(strange_)) return;
  doubtful_ = false;
  if (confirmed_) strange_.clear();
  agreeing_.clear();
}

CameraWatch::News CameraWatch::take_strange(const MarkPair& pair, const CameraModel& model) {
  add(strange_, pair, most_strange_pairs);
  const MountedCamera before{pose_, guess_.mark_mm};
  const MountFit moved = fit_mount(before, after_a_move, strange_, model);
  if (tell_of_one_pose(moved)) {
    begin_anew(after_a_move, strange_, model);
    place_by(fit_.camera.pose);
    return News::moved;
  }
  if (doubtful_ || looks_in(strange_) < strange_looks) return News::nothing;
  doubtful_ = true;
  return News::doubtful;
}

std::vector<MarkPair> CameraWatch::strange_well_seen() const {
  std::vector<MarkPair> well_seen;
  std::ranges::copy_if(strange_, std::back_inserter(well_seen),
                       [](const MarkPair& pair) { return pair.looks >= strange_looks_of_a_place; });
  return well_seen;
}

// Places that do not agree with it are outvoted.
bool CameraWatch::is_confirmed() const {
  return places_in(pairs_) >= least_places + places_in(strange_well_seen()) && fit_.error_px <= one_pose_px;
}

bool CameraWatch::tell_of_one_pose(const MountFit& moved) const {
  const std::vector<MarkPair> well_seen = strange_well_seen();
  const bool elsewhere = std::ranges::any_of(well_seen, [&](const MarkPair& pair) {
    return (pair.tool.translation() - well_seen.front().tool.translation()).norm() >= elsewhere_mm;
  });
  return elsewhere && moved.error_px <= one_pose_px;
}

void CameraWatch::fit(const CameraModel& model) {
  fit_ = fit_mount(guess_, sure_, pairs_, model);
  spread_mm_ = 0;
  for (const Eigen::Vector3d& point : row_) spread_mm_ = std::max(spread_mm_, fit_.spread_mm(point));
}

}  // namespace pizarra::coordinator
