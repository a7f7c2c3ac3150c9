#include "agents/vision/agent/body_form.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/core/eigen.hpp>

#include "lisp/numbers.hpp"

namespace pizarra::vision {
namespace {

constexpr double most_turn_deg = 360;

// Three numbers, none larger than that.
std::optional<cv::Vec3d> three(const Datum& written, double most) {
  if (!written.is_list() || written.size() != 3) return std::nullopt;
  cv::Vec3d out;
  for (int i = 0; i < 3; ++i) {
    const Datum& number = written[static_cast<std::size_t>(i)];
    if (!number.is_number() || !(std::abs(number.number()) <= most)) return std::nullopt;
    out[i] = number.number();
  }
  return out;
}

// As angles_deg() says it.
cv::Matx33d turned_by(const cv::Vec3d& deg) {
  const auto about = [&](int axis) {
    return Eigen::AngleAxisd(radians(deg[axis]), Eigen::Vector3d::Unit(axis)).toRotationMatrix();
  };
  const Eigen::Matrix3d turn = about(2) * about(1) * about(0);
  cv::Matx33d out;
  cv::eigen2cv(turn, out);
  return out;
}

std::optional<MarkOnBody> mark_from(const Datum& written) {
  if (!written.is_list() || written.size() != 3 || !written[0].is_string()) return std::nullopt;
  const std::optional<cv::Vec3d> place = three(written[1], farthest_on_a_body_mm);
  const std::optional<cv::Vec3d> turn = three(written[2], most_turn_deg);
  if (!place || !turn) return std::nullopt;
  return MarkOnBody{std::string(written[0].text()), *place, turned_by(*turn)};
}

}  // namespace

Result<Body> body_from(const Datum& marks, const std::string& name) {
  Body out{name, {}};
  const bool counts = marks.is_list() && marks.size() >= 1 && marks.size() <= most_marks_of_a_body;
  if (!counts) {
    return fail("malformed",
                fmt::format("a body has from 1 to {} marks, as ((MARK (X Y Z) (RX RY RZ)) ...)", most_marks_of_a_body),
                marks);
  }
  for (const Datum& written : marks.items()) {
    std::optional<MarkOnBody> mark = mark_from(written);
    if (!mark) {
      return fail("malformed",
                  fmt::format("a mark of a body is (MARK (X Y Z) (RX RY RZ)): at most {} mm from the body's zero, "
                              "turned by at most {} degrees",
                              farthest_on_a_body_mm, most_turn_deg),
                  written);
    }
    if (out.mark(mark->name) != nullptr) return fail("twice", "a body has each mark once", written);
    out.marks.push_back(std::move(*mark));
  }
  return out;
}

}  // namespace pizarra::vision
