#pragma once

// Reads and checks where, and how often, a client wants an object looked for.
//
//   const Result<cv::Rect> area = area_in(operation, camera_size);      // (search-in X Y WIDTH HEIGHT "name")
//   const Result<double> rate = rate_in(operation);                     // (look-at-most TIMES "name")

#include <opencv2/core.hpp>
#include <optional>

#include "lisp/datum.hpp"
#include "lisp/result.hpp"

namespace pizarra::vision {

inline constexpr int least_area_side_px = 16;
inline constexpr int most_area_px = 65536;  // before a camera has said how large its images are
inline constexpr double least_looks_a_second = 0.1;
inline constexpr double most_looks_a_second = 1000;

// The whole pixels within it. `image`: of the camera opened last, where one was. Failures: `too-small` and `outside`.
Result<cv::Rect> area_in(const Datum& operation, const std::optional<cv::Size>& image);
// Failure: `bad-rate`.
Result<double> rate_in(const Datum& operation);

}  // namespace pizarra::vision
