#pragma once

// Tells a person who holds a chessboard which views are still missing: which part of an image no board came to, and
// whether the boards are tilted to one another.
//
//   for (const Lack& lack : lacks_of(views, image, board)) print(lack.sentence);
//
// The fit alone decides whether a calibration is good; it takes seconds, and this takes none.

#include <optional>
#include <string>
#include <vector>

#include "drivers/camera/chessboard.hpp"

namespace pizarra::camera {

struct Lack {
  // A ninth of an image.
  struct Part {
    bool right_image;
    int column;
    int row;
  };
  std::string sentence;
  std::optional<Part> part = std::nullopt;  // nothing: all of it
};

// Each says what to do. Of one camera alone the views have no right corners, and no part is of the right image.
std::vector<Lack> lacks_of(const std::vector<BoardView>& views, cv::Size image, const CalibrationBoard& board);

}  // namespace pizarra::camera
