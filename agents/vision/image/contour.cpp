#include "agents/vision/image/contour.hpp"

#include <cstdint>

namespace pizarra {

// Between two columns and what is left of them, side by side. Unsigned, as what overflows on the way comes back: the
// whole is no larger than the image.
long signed_area(const MarkContour& contour) {
  std::uint32_t sum = 0;
  const auto add = [&sum](const cv::Point& from, const cv::Point& to) {
    sum += static_cast<std::uint32_t>((from.x + to.x) * (to.y - from.y));
  };
  for (std::size_t i = 1; i < contour.size(); ++i) add(contour[i - 1], contour[i]);
  if (!contour.empty()) add(contour.back(), contour.front());
  return static_cast<std::int32_t>(sum);
}

}  // namespace pizarra
