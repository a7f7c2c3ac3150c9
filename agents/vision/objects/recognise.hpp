#pragma once

// Finds the learned object that a seen mark is: it matches with no more doubt than noise makes, and clearly better than
// every other.
//
//   const Likeness likely = likeness(mark, objects, *objects.find("circle"));
//   if (recognise(mark, objects, circle)) likely.confidence();

#include "agents/vision/objects/mark_match.hpp"

namespace pizarra::vision {

double recognition_error(const SeenMark& mark, const LearnedObject& object);

// Of a mark that would be the object but for its size: how many times as high it is as the sample it is most like.
std::optional<double> scale_of_another_size(const SeenMark& mark, const LearnedObject& object);

// How much a mark is like an object, and the learned object that it is most like otherwise.
struct Likeness {
  double error = 0;
  // How much the mark's picture, outline and the grey of its middle differ from those of the likest sample. 1 is what
  // noise, blur and a turned face may make of them; a mark above that is something unlearned.
  double doubt = 0;
  // The same as a part of what it may be without being as much as other shapes differ by: no less than the doubt, and
  // more in noise that would hide these.
  double unlearned = 0;
  // How many times likelier another outline, or another plane, is than this one, once it was registered.
  double other_form = 0;
  int turn = 0;                                 // of that sample, of TurnedSignatures::turns
  const LearnedObject* second = nullptr;        // null: the mark could be no other
  double second_error = recognition_threshold;  // of that one
  double twins = 0;                             // others in view that might as well be the object: twins_of()
  // By how much the object is ahead, of the second or of what is none.
  double margin() const { return second_error - error; }
  // Whether it is neither for certain.
  bool is_ambiguous() const;
  // From 0 to 1: the object's share against the second, against what is unlike everything learned, against what is
  // like it but unlearned, against another outline or plane, and against its twins. The first two count e times less
  // for every hundredth of error that they are farther away, the third for every sixth that `unlearned` is below 1. One
  // half: it might as well be another thing.
  double confidence() const;
  // The same whether or not something hides a part: what does makes another outline of it.
  double confidence_if_covered() const;
};
inline constexpr double least_margin = 0.005;
// So much error makes something e times less likely.
inline constexpr double error_scale = 0.01;
// And so much doubt, 1 being as much as may be.
inline constexpr double doubt_scale = 1.0 / 6;

Likeness likeness(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object);

// The likeness of a mark that is this object rather than nothing or any other learned one.
// Sooner where `last_turn` tells about how it is turned.
std::optional<Likeness> recognise(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object,
                                  std::optional<int> last_turn = {});
bool is_recognised(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object);

}  // namespace pizarra::vision
