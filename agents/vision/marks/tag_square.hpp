#pragma once

// Dark squares that may be tags, their corners, and their pictures.
//
//   for (const TagSquare& square : tags_at_a_glance(grey, area, *dictionary)) square.number;
//   for (const TagCorners& corners : squares_at_levels(grey)) ...          // in any light, whatever they are

#include <opencv2/aruco.hpp>
#include <opencv2/core.hpp>
#include <vector>

namespace pizarra::vision {

struct TagSquare {
  int number;
  std::vector<cv::Point2f> corners;  // clockwise from the tag's own upper left one
};

// Where a tag is known to be about, an area within the image: by one threshold for all of it. In even light that is
// enough, in a fraction of the time of OpenCV's detector, which sees more.
std::vector<TagSquare> tags_at_a_glance(const cv::Mat1b& grey, const cv::Rect& area,
                                        const cv::aruco::Dictionary& dictionary);

// A square's corners to a fraction of a pixel, from within about one cell around each, of so many along a side with the
// border: corners farther away are those of other cells.
std::vector<cv::Point2f> refined(const cv::Mat1b& grey, std::vector<cv::Point2f> corners, int cells);

// Dark squares at any of many levels: where the edge of a shadow crosses a tag, there is a level between its paper in
// the shadow and its print beside it.
std::vector<std::vector<cv::Point2f>> squares_at_levels(const cv::Mat1b& grey);

// The image between the corners and around them, as a square so many pixels wide: the corners are `around_px` within
// it.
cv::Mat1b squared(const cv::Mat1b& grey, const std::vector<cv::Point2f>& corners, int side_px, int around_px = 0);

// Of so many cells along a side of such a square their levels, one pixel a cell. Blur mixes a cell's edges with its
// neighbours: they do not count.
cv::Mat1f cell_levels(const cv::Mat1b& square, int cells);

}  // namespace pizarra::vision
