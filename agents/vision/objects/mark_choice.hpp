#pragma once

// Which of the marks in an image an object is: the choice among those that are recognised as it (recognise.hpp), and
// which mark of the right image is the same. The second and third stage of the thesis' find; the first, candidates over
// the image, is ImageSegmentation.
//
//   const SeenMark* found = find_object(segmentation.marks(), objects, *objects.find("circle"));
//   const SeenMark* partner = find_partner(*found, right_segmentation.marks(), {});

#include "agents/vision/objects/recognise.hpp"

namespace pizarra::vision {

// Two faces of one yawed cube are seen about this many mark heights (standard deviations) apart at most.
inline constexpr double neighbour_heights = 8;

// Whether the two may be on two faces of one cube, which are near each other and both seen aslant: by the cosines of
// the angles from which they are seen, whose squares no cube's two faces bring above 1. Where the slimness that
// they have from the front hides from where they are seen, nearness alone counts.
bool may_be_one_cube(const SeenMark& a, const SeenMark& b, double front_slimness);
// The least of its samples; 1 of a tag.
double front_slimness(const LearnedObject& object);

// The mark that is the object: of those that are as like it as the likest the one nearest to where it was seen last.
// Where that is not given, the likest; but of those within one cube's width, which may be two faces of the cube, the
// largest. Null: none.
const SeenMark* find_object(const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                            const LearnedObject& object, std::optional<cv::Point2d> seen_last = {});

// Where else marks are recognised as the object: another one, another face of its cube, or something like it.
std::vector<cv::Point2d> others_like(const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                                     const LearnedObject& object, const SeenMark& found);

// How many of these there are. Each counts e times less for every hundredth of error that it is less like the object.
// It counts less where its print is fainter than that of the one that was found. Another face of the same cube does
// not count.
double twins_of(const std::vector<SeenMark>& marks, const LearnedObjects& objects, const LearnedObject& object,
                const SeenMark& found);

// The possible partners of a left mark in the right image, the likest first: same tone, line, size and shape, to the
// left of it. Of marks that look alike, as on two faces of a cube, each may be the partner of another.
std::vector<const SeenMark*> find_partners(const SeenMark& left, const std::vector<SeenMark>& right);
// The likest of them, or the one nearest to the expected disparity where one is given. Null: none.
const SeenMark* find_partner(const SeenMark& left, const std::vector<SeenMark>& right,
                             std::optional<double> disparity_px);

// Whether the two can be views of one mark.
bool are_partners(const SeenMark& left, const SeenMark& right);

}  // namespace pizarra::vision
