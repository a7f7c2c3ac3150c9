#include "programs/commands/pose_words.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>

namespace pizarra::programs {
namespace {

using Numbers = std::span<const double>;

// As it is printed: no zero is negative.
cv::Vec3d rounded(const cv::Vec3d& values) {
  cv::Vec3d out;
  for (int i = 0; i < 3; ++i) out[i] = std::round(100 * values[i]) / 100 + 0.0;
  return out;
}

cv::Vec3d printed_angles(const cv::Matx33d& turn) { return rounded(vision::angles_deg(turn)); }

struct PoseNumbers {
  explicit PoseNumbers(const vision::MarkPose& pose)
      : place(rounded(pose.place_mm)), angles(printed_angles(pose.turn)), spreads(vision::spreads_of(pose)) {}
  Numbers place_spread() const { return Numbers(spreads).first(3); }
  Numbers angle_spread() const { return Numbers(spreads).last(3); }
  cv::Vec3d place;
  cv::Vec3d angles;
  std::array<double, 6> spreads;
};

}  // namespace

std::string pose_words(const vision::MarkPose& pose) {
  const PoseNumbers of(pose);
  std::string out =
      fmt::format("place {:.2f} mm, off by {:.2f}; turned {:.2f} degrees, off by {:.2f}", fmt::join(of.place.val, " "),
                  fmt::join(of.place_spread(), " "), fmt::join(of.angles.val, " "), fmt::join(of.angle_spread(), " "));
  if (!pose.flipped) return out;
  return fmt::format("{}; or, by {:.0f} %, turned {:.2f} degrees", out, 100 * pose.flipped->share,
                     fmt::join(printed_angles(pose.flipped->turn).val, " "));
}

std::string pose_json(const vision::MarkPose& pose) {
  const PoseNumbers of(pose);
  std::string out =
      fmt::format("\"place\":[{:.2f}],\"place_spread\":[{:.2f}],\"turn\":[{:.2f}],\"turn_spread\":[{:.2f}]",
                  fmt::join(of.place.val, ","), fmt::join(of.place_spread(), ","), fmt::join(of.angles.val, ","),
                  fmt::join(of.angle_spread(), ","));
  if (!pose.flipped) return out;
  return fmt::format("{},\"flipped\":{{\"turn\":[{:.2f}],\"share\":{:.3f}}}", out,
                     fmt::join(printed_angles(pose.flipped->turn).val, ","), pose.flipped->share);
}

}  // namespace pizarra::programs
