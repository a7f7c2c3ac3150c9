#pragma once

// Finds a ChArUco board: a chessboard with a tag in each light square. The tags say which corners are which, so that a
// part of the board is enough: its rest may lie beyond the image, or something may hide it.
//
//   CalibrationBoard board;
//   board.tags.emplace();
//   Result<BoardView> view = find_charuco(left, right, board);       // view->which
//
// Failure no-board: no tag of the board's family is seen, or too few of its corners; it says in which image.

#include "drivers/camera/chessboard.hpp"

namespace pizarra::camera {

// Fewer corners say little about the lens. They must be of two rows at least, with two or more in each.
inline constexpr std::size_t least_charuco_corners = 8;

// As find_board() takes them. Of a pair the corners that both images show.
Result<BoardView> find_charuco(const cv::Mat& left, const cv::Mat& right, const CalibrationBoard& board);

// A tag on the board, as it is printed.
struct PlacedTag {
  int number;
  cv::Point2f corner_mm;  // its upper left one, from the upper left corner of the squares, x right and y down
};
std::vector<PlacedTag> tags_on(const CalibrationBoard& board);

}  // namespace pizarra::camera
