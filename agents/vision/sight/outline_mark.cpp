#include "agents/vision/sight/outline_mark.hpp"

#include <opencv2/imgproc.hpp>

#include "agents/vision/objects/plane_look.hpp"

namespace pizarra::vision {
namespace {

// Every pixel on the way around it.
MarkContour contour_of(const PlaneOutline& outline, const PlaneFit& fit) {
  MarkContour out;
  for (std::size_t i = 0; i < outline.outermost; ++i) {
    const cv::Point from = fit.in_image(outline.points[i].at);
    const cv::Point to = fit.in_image(outline.points[(i + 1) % outline.outermost].at);
    cv::LineIterator pixel(cv::Rect(from, to) | cv::Rect(from, cv::Size(1, 1)) | cv::Rect(to, cv::Size(1, 1)), from,
                           to);
    // The last one is the first of the next line.
    for (int k = 0; k + 1 < pixel.count; ++k, ++pixel) out.push_back(pixel.pos());
  }
  return out;
}

}  // namespace

SeenMark mark_by_outline(const SeenMark& last, const PlaneOutline& outline, const PlaneFit& fit) {
  SeenMark out = last;
  const double size_before = last.width_px * last.height_px;
  set_place(out, fit, outline.middle);
  out.area_px *= out.width_px * out.height_px / size_before;
  out.contour = contour_of(outline, fit);
  out.box = cv::boundingRect(out.contour);
  out.perimeter_px = static_cast<int>(out.contour.size());
  return out;
}

}  // namespace pizarra::vision
