#pragma once

// Fits lenses, and how two cameras stand to each other, to boards as they saw them. Where nothing fits, it says which
// view is farthest off: without it the others may.
//
//   Fit<CalibratedPair> fit = fit_pair(views, size, board, tell);
//   if (!fit && fit.error().worst) ...                       // leave that one out

#include <expected>
#include <optional>

#include "drivers/camera/chessboard.hpp"

namespace pizarra::camera {

struct OddView {
  std::size_t index = 0;  // among the views
  ViewError error;
};

struct Misfit {
  Failure why;
  std::optional<OddView> worst;  // none where leaving a view out would not help
};

template <class T>
using Fit = std::expected<T, Misfit>;

// Views with both images, and with the left one alone.
Fit<CalibratedPair> fit_pair(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board,
                             const TellStep& tell);
Fit<CalibratedPair> fit_single(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board,
                               const TellStep& tell);

}  // namespace pizarra::camera
