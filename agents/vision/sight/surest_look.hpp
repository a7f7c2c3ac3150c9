#pragma once

// The look at an object that one image shows most surely, among all marks that are like it. A window of a house is a
// square as well, but for its perspective.
//
//   SurestLook look(sight, objects, object, std::move(likest), {});
//   look.look_for_whole();              // where the likest is not clearly sure
//   look.look_for_parts();              // where the best until now is not sure
//   std::optional<SeenPair> best = std::move(look).best();

#include <optional>
#include <span>
#include <string_view>

#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra::vision {

// Registers the outline of a shape with a mark that was found: how it lies, and how sure that makes it.
void look_at_plane(StereoSight& sight, const LearnedObject& object, SeenPair& pair);

// Why what is seen with this confidence is none of the object; nothing where it may be it.
std::optional<std::string_view> why_none(const LearnedObject& object, const SeenPair& seen, double confidence);

class SurestLook {
 public:
  // `likest`: what a look at the regions found, with its plane. No mark at one of `others` is taken.
  SurestLook(StereoSight& sight, const LearnedObjects& objects, const LearnedObject& object,
             std::optional<SeenPair> likest, std::span<const cv::Point2d> others);

  void look_for_whole();
  void look_for_parts();
  bool is_clear() const;
  double confidence() const { return confidence_; }  // 0: nothing was found
  std::optional<SeenPair> best() && { return std::move(best_); }

 private:
  bool may_be_it(const SeenPair& seen) const;
  void take_surer(SeenPair&& other);

  StereoSight& sight_;
  const LearnedObjects& objects_;
  const LearnedObject& object_;
  std::span<const cv::Point2d> others_;
  std::optional<SeenPair> best_;
  double confidence_ = 0;
};

}  // namespace pizarra::vision
