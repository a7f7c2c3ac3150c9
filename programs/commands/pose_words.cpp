#include "programs/commands/pose_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>

namespace pizarra::programs {
namespace {

using Numbers = std::span<const double>;

struct PoseNumbers {
  explicit PoseNumbers(const vision::MarkPose& pose)
      : place(pose.place_mm), angles(vision::angles_deg(pose.turn)), spreads(vision::spreads_of(pose)) {}
  Numbers place_spread() const { return Numbers(spreads).first(3); }
  Numbers angle_spread() const { return Numbers(spreads).last(3); }
  cv::Vec3d place;
  cv::Vec3d angles;
  std::array<double, 6> spreads;
};

}  // namespace

std::string pose_words(const vision::MarkPose& pose) {
  const PoseNumbers of(pose);
  return fmt::format("place {:.2f} mm, off by {:.2f}; turned {:.2f} degrees, off by {:.2f}",
                     fmt::join(of.place.val, " "), fmt::join(of.place_spread(), " "), fmt::join(of.angles.val, " "),
                     fmt::join(of.angle_spread(), " "));
}

std::string pose_json(const vision::MarkPose& pose) {
  const PoseNumbers of(pose);
  return fmt::format("\"place\":[{:.2f}],\"place_spread\":[{:.2f}],\"turn\":[{:.2f}],\"turn_spread\":[{:.2f}]",
                     fmt::join(of.place.val, ","), fmt::join(of.place_spread(), ","), fmt::join(of.angles.val, ","),
                     fmt::join(of.angle_spread(), ","));
}

}  // namespace pizarra::programs
