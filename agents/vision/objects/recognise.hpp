#pragma once

// Which learned object a seen mark is, and where in an image an object is: the second and third stage of the thesis'
// find (the first, candidates over the image, is ImageSegmentation). A parameter counts the less the more the samples
// of an object differ in it. What is like an object is it where its outline differs by no more than noise makes, and
// it is solid.
//
//   double error = recognition_error(mark, *objects.find("circle"));     // infinite where it cannot be
//   const SeenMark* found = find_object(segmentation.marks(), objects, "circle");

#include "agents/vision/objects/learned.hpp"

namespace pizarra {

// Above this error a mark is not the object.
inline constexpr double recognition_threshold = 0.085;

// How many times as high as it was learned, in px, an object is looked for.
inline constexpr double least_scale = 0.5;
inline constexpr double most_scale = 1.8;

// The weighted difference of the parameters to the nearest sample. Infinite where tone, size or slimness (a face yawed
// by more than 45 degrees) cannot be the object's.
double recognition_error(const SeenMark& mark, const LearnedObject& object);

// Of a mark that would be the object but for its size: how many times as high it is as the sample it is most like.
std::optional<double> scale_of_another_size(const SeenMark& mark, const LearnedObject& object);

// How much two learned objects differ: the least over pairs of their samples, as a mark of one would differ from the
// other. Below `alike_below` noise, blur or a turned face may make one pass for the other.
double likeness_error(const LearnedObject& a, const LearnedObject& b);
inline constexpr double alike_below = 0.075;

// How much a mark is like an object, and the learned object that it is most like otherwise.
struct Likeness {
  double error = 0;
  // By how much the mark's outline, and the grey of its middle, differ from those of the likest sample, as a part of
  // what the image's noise, blur and a turned face may make of them. Above 1 it is something that nobody learned.
  double doubt = 0;
  // The same as a part of what it may be without being as much as other shapes differ by: no less than the doubt, and
  // more in noise that would hide these.
  double unlearned = 0;
  int turn = 0;                                 // of that sample, of TurnedSignatures::turns
  const LearnedObject* second = nullptr;        // null: the mark could be no other
  double second_error = recognition_threshold;  // of that one
  double twins = 0;                             // others in view that might as well be the object: twins_of()
  // By how much the object is ahead, of the second or of what is none.
  double margin() const { return second_error - error; }
  // Whether it is neither for certain.
  bool is_ambiguous() const;
  // From 0 to 1: the object's share against the second, against what is unlike everything learned, against what is
  // like it but unlearned, and against its twins. The first two count e times less for every hundredth of error that they are farther away,
  // the third for every sixth that `unlearned` is below 1. One half: it might as well be another thing.
  double confidence() const;
};
inline constexpr double least_margin = 0.005;

Likeness likeness(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object);

// The likeness of a mark that is this object rather than nothing or any other learned one.
// Sooner where `last_turn` tells about how it is turned.
std::optional<Likeness> recognise(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object,
                                  std::optional<int> last_turn = {});
bool is_recognised(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object);

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

// How many of these there are, each counted e times less for every hundredth of error that it is less like the object;
// what may be another face of the same cube is none.
double twins_of(const std::vector<SeenMark>& marks, const LearnedObjects& objects, const LearnedObject& object,
                const SeenMark& found);

// The partner of a left mark in the right image: same tone, line, size and shape, to the left of it and nearest to the
// expected disparity where one is given. Null: none.
const SeenMark* find_partner(const SeenMark& left, const std::vector<SeenMark>& right,
                             std::optional<double> disparity_px);

// Whether the two can be views of one mark.
bool are_partners(const SeenMark& left, const SeenMark& right);

}  // namespace pizarra
