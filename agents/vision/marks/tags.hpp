#pragma once

// Tags: dark squares whose cells spell a number, of ArUco's and AprilTag's families. A lab that has them needs no other
// marks: what bears one is learned, found and tracked by it. The families are named in tag_detection.cpp.
//
//   Result<std::optional<SeenMark>> clicked = tag_at(grey, {160, 120});   // of whatever family
//   std::vector<SeenMark> seen = find_tags(grey, *(*clicked)->tag);       // and nothing else

#include <optional>

#include "agents/vision/marks/mark_measure.hpp"
#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::vision {

// Of a seen tag the mark is the outer square, and the centre where its diagonals meet. One of which something hides so
// much that the centre would be more than a pixel off, or 1.5 % of its side, is not seen.

// The tag around the point, wherever in it that is; nothing where none is. Failure `unclear-tag`: one is, but such a
// one as find_tags() does not see.
Result<std::optional<SeenMark>> tag_at(const cv::Mat& grey, cv::Point2d point);

// This tag, within `area` where that is given, as often as it is there: a lab may have printed it twice.
std::vector<SeenMark> find_tags(const cv::Mat& grey, const Tag& tag, cv::Rect area = {});

// The squares of a family within `area`, or in all of the image, with their places in the image.
TagDetection squares_in(const cv::Mat& grey, const TagFamily& family, cv::Rect area = {});

// This tag among the squares of its family that the image was found to show: to look for several tags in one image.
std::vector<SeenMark> tags_among(const cv::Mat& grey, const TagDetection& squares, const Tag& tag);

// As find_tags(), sooner, within a small area where the tag was seen in the frame before. Of several there not all may
// be told.
std::vector<SeenMark> follow_tag(const cv::Mat& grey, const Tag& tag, cv::Rect area);

// How much of an image must be looked at for a tag to be found that is about where `box` is: half its side to each
// side, for the light around it and for its motion.
cv::Rect area_around_tag(cv::Rect box);

// Whether the two can be views of one tag: in the same row, the right one further left.
bool are_tag_partners(const SeenMark& left, const SeenMark& right);

}  // namespace pizarra::vision
