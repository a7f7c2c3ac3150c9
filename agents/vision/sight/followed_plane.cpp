#include "agents/vision/sight/followed_plane.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/vision/objects/mark_match.hpp"
#include "agents/vision/sight/follow_mark.hpp"
#include "agents/vision/sight/whole_outline.hpp"

namespace pizarra::vision {
namespace {

// Around the mark, for its outline's normals and what smooths the image.
constexpr int margin_px = 16;
// Frames of a face at rest err alike, so their evidence is averaged, each with this weight. A face that has turned by
// so much since the frame before counts as new evidence. The sum is bounded.
constexpr double turned_anew_rad = 0.15;
constexpr double of_average = 0.2;
constexpr double most_certain = 20;

cv::Matx33d shift_by(cv::Point2d way) { return {1, 0, way.x, 0, 1, way.y, 0, 0, 1}; }

// A symmetric outline is turned alike in both.
cv::Matx33d moved(const cv::Matx33d& to_image, cv::Point2d from, cv::Point2d to) {
  return shift_by(to - from) * to_image;
}

void move_by(PlaneFit& fit, cv::Point2d way) {
  fit.to_image = shift_by(way) * fit.to_image;
  for (PlaneEdge& edge : fit.edges) edge.at += way;
}

cv::Vec3d away_of(const cv::Matx33d& turn) { return {turn(0, 2), turn(1, 2), turn(2, 2)}; }

// Registers a sample's outline in one image, around a mark.
class OutlineInImage {
 public:
  OutlineInImage(const cv::Mat& grey, double noise, const SeenMark& mark)
      : mark_(mark), cut_(look_at(grey, around(mark) & cv::Rect({}, grey.size()), noise)) {}

  std::optional<PlaneFit> fit_from(const LearnedSample& sample, const cv::Matx33d& start,
                                   const PlaneSearch& search) const {
    return checked(fit_plane(cut_.pixels, sample.plane, shift_by(-origin()) * start, sample.tone, search));
  }
  std::optional<PlaneFit> fit_anew(const LearnedSample& sample) const {
    std::vector<cv::Point2d> contour;
    for (const cv::Point& p : mark_.contour) contour.emplace_back(p - cut_.origin);
    const std::optional<Reach> reach = reach_of(contour);
    return reach ? checked(fit_region(cut_, sample, *reach)) : std::nullopt;
  }
  OutlineGround ground(const LearnedSample& sample, PlaneFit fit) const {
    move_by(fit, -origin());
    return look_at_ground(cut_, sample.plane, fit);
  }

 private:
  static cv::Rect around(const SeenMark& mark) {
    return {mark.box.x - margin_px, mark.box.y - margin_px, mark.box.width + 2 * margin_px,
            mark.box.height + 2 * margin_px};
  }
  cv::Point2d origin() const { return cut_.origin; }
  std::optional<PlaneFit> checked(std::optional<PlaneFit> fit) const {
    if (!fit || !is_outline_of(*fit)) return std::nullopt;
    move_by(*fit, origin());
    return fit;
  }

  const SeenMark& mark_;
  const ImageCut cut_;
};

const PlaneSearch& to_follow_in_left(const StereoSight& sight) {
  return sight.model().is_single() ? to_follow_alone : to_follow;
}

const LearnedSample* sample_numbered(const LearnedObject& object, int number) {
  const auto found = std::ranges::find(object.samples, number, &LearnedSample::number);
  return found == object.samples.end() ? nullptr : &*found;
}

}  // namespace

std::optional<PlaneFit> fit_in_right(const StereoSight& sight, const LearnedSample& sample, const SeenPair& pair,
                                     const PlaneFit& left, const PlaneSearch& search) {
  if (!pair.right) return std::nullopt;
  const cv::Matx33d start = moved(left.to_image, pair.left.centre, pair.right->centre);
  return OutlineInImage(sight.right(), sight.noise(), *pair.right).fit_from(sample, start, search);
}

// How much all frames speak for the likelier tilt, which is made the pose: before one camera by how usual it is, too.
// The tilts of two frames are matched by the face's direction.
double FollowedPlane::weigh_tilts(const std::optional<Seen>& before, PlanePose& pose) {
  double for_best = pose.other.misfit - pose.misfit;
  if (before) {
    const double best_off = cv::norm(away_of(pose.turn) - away_of(before->turn));
    const double other_off = cv::norm(away_of(pose.other.turn) - away_of(before->turn));
    const double anew = std::min(1.0, std::min(best_off, other_off) / turned_anew_rad);
    const double until_now = other_off < best_off ? -before->for_told : before->for_told;
    for_best = std::lerp(1 - of_average, 1, anew) * until_now + std::lerp(of_average, 1, anew) * for_best;
  }
  double for_told = std::clamp(for_best, -most_certain, most_certain);
  const double more_usual = pose.by_both ? 0 : unusual(pose.other) - unusual(pose);
  if (for_told + more_usual < 0) {
    std::swap(static_cast<PlaneTilt&>(pose), pose.other);
    for_told = -for_told;
  }
  pose.other.misfit = pose.misfit + for_told;
  return for_told;
}

cv::Matx33d FollowedPlane::start_at(const SeenMark& left) const {
  return moved(before_->to_image, before_->centre, left.centre);
}

bool FollowedPlane::recognises(const StereoSight& sight, const LearnedObject& object, const SeenMark& left) const {
  const LearnedSample* sample = before_ ? sample_numbered(object, before_->sample) : nullptr;
  if (sample == nullptr) return false;
  const OutlineInImage image(sight.left(), sight.noise(), left);
  const std::optional<PlaneFit> fit = image.fit_from(*sample, start_at(left), to_follow_in_left(sight));
  const std::optional<PlanePose> pose = fit ? pose_in_plane(sight.model(), *sample, *fit) : std::nullopt;
  if (!pose) return false;
  const double most_off_px = px_in(sight.left(), 1);
  const std::optional<double> off_px = off_by_outline_px({*sample, *fit, nullptr, *pose, false}, most_off_px);
  // Whether something hides a part is asked of both images of a pair later.
  return off_px && (before_->to_right || *off_px < most_off_px);
}

std::optional<SeenMark> FollowedPlane::follow_in_right(const StereoSight& sight, const LearnedObject& object,
                                                       const SeenMark& right, cv::Point2d expected) const {
  const LearnedSample* sample = before_ && before_->to_right ? sample_numbered(object, before_->sample) : nullptr;
  if (sample == nullptr) return std::nullopt;
  SeenMark last = right;
  move_by(last, expected - right.centre);
  if ((last.box & cv::Rect({}, sight.right().size())) != last.box) return std::nullopt;
  const cv::Matx33d start = moved(*before_->to_right, right.centre, expected);
  const std::optional<PlaneFit> fit =
      OutlineInImage(sight.right(), sight.noise(), last).fit_from(*sample, start, to_follow);
  if (!fit || !is_registered(sample->plane, *fit, px_in(sight.right(), 1))) return std::nullopt;
  set_outline(last, *fit, *sample);
  return last;
}

std::optional<FollowedLook> FollowedPlane::look(const StereoSight& sight, const LearnedObject& object,
                                                const SeenPair& now) {
  const bool has_outline = !now.left.tag && !now.left.contour.empty();
  if (!has_outline) before_.reset();
  if (!has_outline) return std::nullopt;
  const OutlineInImage image(sight.left(), sight.noise(), now.left);
  const LearnedSample* sample = before_ ? sample_numbered(object, before_->sample) : nullptr;
  std::optional<PlaneFit> left;
  if (sample != nullptr) left = image.fit_from(*sample, start_at(now.left), to_follow_in_left(sight));
  const bool goes_on = left.has_value();
  const std::optional<Seen> before = std::exchange(before_, std::nullopt);
  if (!left) {
    sample = match_of(now.left, object, now.likeness.turn).sample;
    if (sample == nullptr || sample->tag) return std::nullopt;
    left = image.fit_anew(*sample);
  }
  if (!left) return std::nullopt;
  const std::optional<PlaneFit> right = fit_in_right(sight, *sample, now, *left, to_follow_in_right);
  std::optional<PlanePose> pose = pose_in_plane(sight.model(), *sample, *left, right ? &*right : nullptr,
                                                before && goes_on ? std::optional(before->turn) : std::nullopt);
  if (!pose) return std::nullopt;
  const double for_told = weigh_tilts(before, *pose);
  const std::optional<cv::Matx33d> to_right = right ? std::optional(right->to_image) : std::nullopt;
  before_ = Seen{sample->number, now.left.centre, left->to_image, to_right, pose->turn, for_told};
  const RegisteredOutline seen{*sample, *left, right ? &*right : nullptr, *pose, now.right.has_value()};
  const std::optional<double> off_px = off_by_outline_px(seen, px_in(sight.left(), 1));
  const OutlineGround ground = now.right ? OutlineGround() : image.ground(*sample, *left);
  return FollowedLook{{sample, std::move(*left), true, std::move(pose), false, ground, off_px}, goes_on};
}

}  // namespace pizarra::vision
