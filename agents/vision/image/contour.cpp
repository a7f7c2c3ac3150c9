#include "agents/vision/image/contour.hpp"

namespace pizarra {

long signed_area(const MarkContour& contour) {
  long sum = 0;
  cv::Point before = contour.empty() ? cv::Point() : contour.back();
  for (const cv::Point& at : contour) {
    sum += static_cast<long>(before.x) * at.y - static_cast<long>(at.x) * before.y;
    before = at;
  }
  return sum;
}

}  // namespace pizarra
