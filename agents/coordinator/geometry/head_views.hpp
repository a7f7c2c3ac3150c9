#pragma once

// Where a pan-tilt unit turns its cameras so that they show what they do not show as they stand: the rest of the table
// within the arm's reach, or a set of objects together.
//
//   const Result<HeadRange> range = head_range_from_fact(fact);
//   const std::vector<Eigen::Vector3d> table = table_within(room, foot_mm, camera);
//   for (const HeadTurn& turn : views_of(camera, *range, now, table, cube_mm / 2)) ...
//   const std::optional<HeadTurn> all = turn_that_shows(camera, *range, marks, 40);
//
// Points are marks in the base frame, mm.

#include <optional>
#include <vector>

#include "agents/coordinator/geometry/camera_view.hpp"
#include "agents/coordinator/geometry/elbow_room.hpp"

namespace pizarra::coordinator {

// Degrees from the unit's middle.
struct HeadRange {
  double pan_low_deg, pan_high_deg;
  double tilt_low_deg, tilt_high_deg;
};

// As in (pan-tilt-unit (LOW HIGH RESOLUTION TOP-SPEED) (LOW HIGH RESOLUTION TOP-SPEED)): pan and tilt.
Result<HeadRange> head_range_from_fact(const Datum& fact);

// The cameras on the head: how they stand while it is in its middle, and how they project.
struct HeadCamera {
  forms::CameraPose pose;
  CameraModel model;
};

// Marks of cubes that stand on the table where the arm can grasp them, on its side towards the camera: a grid.
std::vector<Eigen::Vector3d> table_within(const ElbowRoom& room, const Eigen::Vector3d& foot_mm,
                                          const HeadCamera& camera);

// The fewest turns, at most six, that show nearly all of the points which `now` does not show, each with all within
// `around_mm` of it. The one that shows most comes first.
std::vector<HeadTurn> views_of(const HeadCamera& camera, const HeadRange& range, const HeadTurn& now,
                               std::vector<Eigen::Vector3d> points, double around_mm);

// The turn nearest the middle in which all within `around_mm` of every point shows; none where no turn shows them all.
std::optional<HeadTurn> turn_that_shows(const HeadCamera& camera, const HeadRange& range,
                                        const std::vector<Eigen::Vector3d>& points, double around_mm);

}  // namespace pizarra::coordinator
