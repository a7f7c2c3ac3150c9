#include "agents/vision/agent/search_request.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pizarra::vision {

Result<cv::Rect> area_in(const Datum& operation, const std::optional<cv::Size>& image) {
  const double x = operation[1].number();
  const double y = operation[2].number();
  const double width = operation[3].number();
  const double height = operation[4].number();
  // A value that is not a number fails either check.
  if (!(width >= least_area_side_px && height >= least_area_side_px)) {
    return fail("too-small", fmt::format("the area is at least {0} px wide and {0} px high", least_area_side_px),
                operation);
  }
  const cv::Size size = image.value_or(cv::Size(most_area_px, most_area_px));
  const bool inside = x >= 0 && y >= 0 && x + width <= size.width && y + height <= size.height;
  if (!inside) {
    const std::string_view what = image ? "the left image" : "the largest image";
    return fail("outside",
                fmt::format("the area does not lie within {}, which has {} x {} px", what, size.width, size.height),
                operation);
  }
  const cv::Point first(static_cast<int>(std::ceil(x)), static_cast<int>(std::ceil(y)));
  const cv::Point end(static_cast<int>(std::floor(x + width)), static_cast<int>(std::floor(y + height)));
  return cv::Rect(first, end);
}

Result<double> rate_in(const Datum& operation) {
  const double rate = operation[1].number();
  if (rate >= least_looks_a_second && rate <= most_looks_a_second) return rate;
  return fail(
      "bad-rate",
      fmt::format("an object is looked at from {} to {} times a second", least_looks_a_second, most_looks_a_second),
      operation[1]);
}

}  // namespace pizarra::vision
