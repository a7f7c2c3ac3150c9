#include "agents/vision/marks/tag_light.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "agents/vision/marks/robust.hpp"
#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/marks/tag_square.hpp"

namespace pizarra::vision {
namespace {

constexpr double paper_level = 200;  // afterwards
// So that black cells without any light divide nothing by nothing.
constexpr double least_level = 1;

// How light dark cells are, as a part of light ones beside them.
double dark_share(const cv::Mat1f& levels, const cv::Mat1b& print) {
  std::vector<double> shares;
  const auto compare = [&](cv::Point a, cv::Point b) {
    if (print(a) == unprinted || print(b) == unprinted || print(a) == print(b)) return;
    const bool first_is_dark = print(a) == 0;
    shares.push_back(first_is_dark ? levels(a) / levels(b) : levels(b) / levels(a));
  };
  for (int y = 0; y < print.rows; ++y) {
    for (int x = 0; x < print.cols; ++x) {
      if (x > 0) compare({x - 1, y}, {x, y});
      if (y > 0) compare({x, y - 1}, {x, y});
    }
  }
  return shares.empty() ? 1 : std::min(1.0, median(std::move(shares)));
}

// On each cell: the median of those around it, which keeps a shadow's edge where it is.
cv::Mat1d light_on(const cv::Mat1f& levels, const cv::Mat1b& print) {
  const double dark = dark_share(levels, print);
  const cv::Rect all({0, 0}, print.size());
  cv::Mat1d out(print.size());
  for (int y = 0; y < print.rows; ++y) {
    for (int x = 0; x < print.cols; ++x) {
      const cv::Rect around = cv::Rect(x - 1, y - 1, 3, 3) & all;
      std::vector<double> lights;
      for (int v = around.y; v < around.br().y; ++v) {
        for (int u = around.x; u < around.br().x; ++u) {
          if (print(v, u) != unprinted) lights.push_back(levels(v, u) / (print(v, u) == 0 ? dark : 1));
        }
      }
      out(y, x) = lights.empty() ? paper_level : median(std::move(lights));
    }
  }
  return out;
}

}  // namespace

cv::Mat1b evenly_lit(const cv::Mat1b& seen, const cv::Mat1b& print) {
  cv::Mat light;
  cv::resize(light_on(cell_levels(seen, print.cols) + least_level, print), light, seen.size(), 0, 0, cv::INTER_LINEAR);
  cv::Mat out;
  cv::divide(seen, light, out, paper_level, CV_64F);
  out.convertTo(out, CV_8U);
  return out;
}

}  // namespace pizarra::vision
