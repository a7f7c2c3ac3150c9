#include "agents/vision/stereo_sight.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra {
namespace {

// A triangle on its side is 3 % higher.
constexpr double height_tolerance = 0.1;
constexpr double width_tolerance = 0.05;
// Nearer than this to the image's edge a mark cannot be measured.
constexpr double edge_px = 24;

// Whether the right image ends before the place where it would show the mark, going by its learned size.
bool cut_off_right(const StereoModel& model, const LearnedObject& object, const SeenMark& left) {
  return std::any_of(object.samples.begin(), object.samples.end(), [&](const LearnedSample& sample) {
    if (sample.size_mm <= 0) return true;
    const double disparity = model.base_line_mm * left.height_px / sample.size_mm;
    return left.centre.x - disparity < edge_px;
  });
}

}  // namespace

StereoSight::StereoSight(cv::Mat left, cv::Mat right, const StereoModel& model)
    : left_(std::move(left)), right_(std::move(right)), model_(model) {}

ImageSegmentation& StereoSight::left_segmentation() {
  if (!left_segmentation_) left_segmentation_.emplace(left_);
  return *left_segmentation_;
}

ImageSegmentation& StereoSight::right_segmentation() {
  if (!right_segmentation_) right_segmentation_.emplace(right_);
  return *right_segmentation_;
}

std::optional<SeenPair> StereoSight::find(const LearnedObjects& objects, const LearnedObject& object,
                                          std::optional<cv::Point2d> near, double reach_px) {
  std::vector<SeenMark> candidates;
  for (const SeenMark& mark : left_segmentation().marks()) {
    const bool within = !near || cv::norm(mark.centre - *near) <= reach_px;
    if (within && is_recognised(mark, objects, object)) candidates.push_back(mark);
  }
  while (!candidates.empty()) {
    const SeenMark* best = find_object(candidates, objects, object);
    if (best == nullptr) return std::nullopt;
    const SeenMark* partner = find_partner(*best, right_segmentation().marks(), std::nullopt);
    if (partner == nullptr && cut_off_right(model_, object, *best)) return SeenPair{*best, std::nullopt};
    if (partner != nullptr && is_whole(model_, object, *best, *partner)) return SeenPair{*best, *partner};
    candidates.erase(candidates.begin() + (best - candidates.data()));
  }
  return std::nullopt;
}

double size_mm(const StereoModel& model, const SeenMark& left, const SeenMark& right) {
  return left.height_px * depth_mm(model, left.centre.x - right.centre.x) / model.focal_px;
}

bool is_whole(const StereoModel& model, const LearnedObject& object, const SeenMark& left, const SeenMark& right) {
  const double depth = depth_mm(model, left.centre.x - right.centre.x);
  const double height = left.height_px * depth / model.focal_px;
  const double left_width = left.width_px * depth / model.focal_px;
  const double right_width = right.width_px * depth / model.focal_px;
  return std::any_of(object.samples.begin(), object.samples.end(), [&](const LearnedSample& sample) {
    if (sample.size_mm <= 0) return true;
    if (std::abs(height / sample.size_mm - 1) > height_tolerance) return false;
    const double cosine = std::clamp(std::max(left_width, right_width) / sample.size_mm, 0.6, 1.0);
    const double tangent = std::sqrt(1 / (cosine * cosine) - 1);
    const double by_yaw = 1.3 * tangent * model.base_line_mm / depth;
    return std::abs(left_width / right_width - 1) < width_tolerance + by_yaw;
  });
}

}  // namespace pizarra
