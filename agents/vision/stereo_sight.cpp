#include "agents/vision/stereo_sight.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra {

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
    if (partner == nullptr) return SeenPair{*best, std::nullopt};
    if (has_learned_size(object, size_mm(model_, *best, *partner))) return SeenPair{*best, *partner};
    candidates.erase(candidates.begin() + (best - candidates.data()));
  }
  return std::nullopt;
}

double size_mm(const StereoModel& model, const SeenMark& left, const SeenMark& right) {
  return left.height_px * depth_mm(model, left.centre.x - right.centre.x) / model.focal_px;
}

bool has_learned_size(const LearnedObject& object, double size_mm) {
  // A triangle on its side is 5 % higher or lower; a tilted or badly learned mark a little more.
  constexpr double tolerance = 0.2;
  return std::any_of(object.samples.begin(), object.samples.end(), [&](const LearnedSample& sample) {
    return sample.size_mm <= 0 || std::abs(size_mm / sample.size_mm - 1) < tolerance;
  });
}

}  // namespace pizarra
