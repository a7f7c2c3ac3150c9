#include "programs/commands/pose_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>

#include "lisp/numbers.hpp"

namespace pizarra::programs {
namespace {

using Numbers = std::span<const double>;

cv::Vec3d printed(const cv::Vec3d& values) {
  return {rounded(values[0], 100), rounded(values[1], 100), rounded(values[2], 100)};
}

cv::Vec3d printed_angles(const cv::Matx33d& turn) { return printed(vision::angles_deg(turn)); }

struct PoseNumbers {
  explicit PoseNumbers(const vision::MarkPose& pose)
      : place(printed(pose.place_mm)), angles(printed_angles(pose.turn)), spreads(vision::spreads_of(pose)) {}
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
