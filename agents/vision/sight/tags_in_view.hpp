#pragma once

// Every tag of some families that a pair of images shows, each with its place, range and pose. Nothing of them was
// learned: a family says how large its tags are.
//
//   const TagsInView look({{"apriltag-36h11", 40}});                   // the side of its square, mm
//   for (const FoundMark& tag : look.at(sight)) tag.name, tag.confidence, tag.pose ...
//
// Of a pair both images are read, and a tag's partner is the one of its number in the same row; where there are several
// of these, or none, its size alone tells how far away it is.

#include <span>
#include <string>
#include <vector>

#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/sight/mark_finder.hpp"

namespace pizarra::vision {

struct SizedFamily {
  std::string name;    // as TagFamily has it
  double side_mm = 0;  // of its tags
};

// A tag of that size as if it had been learned, under its own name.
LearnedObject object_of(const Tag& tag, double side_mm);

class TagsInView {
 public:
  // Names that no family has are left out.
  explicit TagsInView(std::span<const SizedFamily> families);

  bool empty() const { return families_.empty(); }
  // The largest first, no more than most_tags_at_once.
  std::vector<FoundMark> at(const StereoSight& sight) const;

 private:
  std::vector<const TagFamily*> families_;
  std::vector<LearnedObject> sizes_;  // one of each family, for the size
};

}  // namespace pizarra::vision
