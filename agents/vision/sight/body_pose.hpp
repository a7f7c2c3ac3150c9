#pragma once

// How a body lies of which one or more faces bear marks, by those of them that are seen: all of them in one fit, each
// weighted by how well it is known.
//
//   const Body box{"box", {{"front", {0, 0, -20}, cv::Matx33d::eye()}, {"left", {-20, 0, 0}, turned}}};
//   const MarkInSight seen[] = {{&box.marks[0], pose}};
//   if (const auto lies = body_pose(seen)) lies->pose.place_mm, lies->by
//
// A mark that contradicts the others does not count: another thing bears it, or its own tilt was misjudged.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "agents/vision/sight/mark_pose.hpp"

namespace pizarra::vision {

struct MarkOnBody {
  std::string name;    // of the learned object
  cv::Vec3d place_mm;  // of its middle, on the body's own axes
  cv::Matx33d turn;    // of its axes there: right, down, and into the face
};

struct Body {
  std::string name;
  std::vector<MarkOnBody> marks;
  // Null: it has none of this name.
  const MarkOnBody* mark(std::string_view called) const;
};

struct MarkInSight {
  const MarkOnBody* mark;
  MarkPose pose;
};

struct BodyPose {
  MarkPose pose;                // of the body's own axes, and of their zero
  std::vector<std::string> by;  // the marks that say so
};

// Nothing where none is in sight.
std::optional<BodyPose> body_pose(std::span<const MarkInSight> seen);

}  // namespace pizarra::vision
