#pragma once

// How far off a centre may be because something covers a part of the mark, and how sure one can be of it then. Cameras
// measure what is missing of a mark; a straight edge that hid it moved the centre by half of what it hid.
//
//   const double off = off_if_missing_px(now, 1 - now_area / whole_area);
//   const double confidence = confidence_if_off(0.99, off, 1);

#include "agents/vision/marks/mark_measure.hpp"

namespace pizarra::vision {

// How far the centre moves for every px that the standard deviation shrinks, where a strip of a square is covered. For
// a disc and a cross it is less.
extern const double motion_by_strip;
// From the centre of a triangle to its corners, in standard deviations. A cover along one side leaves the corner
// opposite where it was.
extern const double triangle_reach;

// The product of the mark's principal standard deviations, as large as its image whichever way that is turned.
double spread_product_px2(const SeenMark& mark);

// Where so much of the mark, 0 to 1, may be covered from one side.
double off_if_missing_px(const SeenMark& now, double missing);

// By this look alone, for a mark that was learned `front_slimness` slim: a turned face may as well be a covered one.
double may_be_off_by_shape_px(const SeenMark& now, double front_slimness);

// The confidence where the centre may be `off_px` off: `of_whole` is that in a whole mark, and one half is left at
// `most_off_px`.
double confidence_if_off(double of_whole, double off_px, double most_off_px);
// How surely nothing covers the mark, where that much confidence is left of `of_object`, whether covered or not.
double confidence_in_whole(double confidence, double of_object);

}  // namespace pizarra::vision
