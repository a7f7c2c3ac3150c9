#include "agents/vision/sight/plane_view.hpp"

#include <numbers>

#include "agents/vision/objects/mark_match.hpp"

namespace pizarra::vision {
namespace {

// LEARN measures the stretch by the outline, to this standard deviation.
constexpr double spread_of_learned_stretch = 0.004;

// Else the slimness says how much a nearly round mark is stretched, but not along which of two axes.
double stretch_spread_of(const LearnedSample& sample) {
  if (sample.axis_deg > 0) return spread_of_learned_stretch;
  return (1 - sample.slimness) / (1 + sample.slimness) / std::numbers::sqrt2;
}

}  // namespace

std::optional<PlanePose> pose_in_plane(const camera::StereoModel& model, const LearnedSample& sample,
                                       const PlaneFit& left, const PlaneFit* right,
                                       const std::optional<cv::Matx33d>& turned_before) {
  const double unit_mm = sample.face_mm();
  if (unit_mm <= 0 || !sample.has_form()) return std::nullopt;
  return plane_pose(model, sample.plane, left, {unit_mm, sample.stretch(), stretch_spread_of(sample), turned_before},
                    right);
}

std::optional<PlaneView> view_plane(const ImageCut& cut, const LearnedObject& object, const SeenMark& mark) {
  const LearnedSample* sample = match_of(mark, object).sample;
  if (sample == nullptr || mark.contour.empty()) return std::nullopt;
  const std::optional<Reach> reach = reach_of(std::vector<cv::Point2d>(mark.contour.begin(), mark.contour.end()));
  if (!reach) return std::nullopt;
  std::optional<PlaneFit> fit = fit_region(cut, *sample, *reach);
  if (!fit) return std::nullopt;
  const bool agrees = is_outline_of(*fit);
  PlaneView out{sample, std::move(*fit), agrees, std::nullopt};
  if (agrees) out.ground = look_at_ground(cut, sample->plane, out.fit);
  return out;
}

}  // namespace pizarra::vision
