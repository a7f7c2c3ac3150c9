#pragma once

// Room on the table: where a cube can be put down, and how wide the gripper may open between neighbours.
//
//   const std::optional<Eigen::Vector2d> spot = free_spot(TableArea::of(row, 60), occupied, from_y_mm);

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "lisp/forms/cell_file.hpp"

namespace pizarra::coordinator {

// The part of the table that the arm reaches and the camera sees, and what a cube put down there needs. Cube centres.
struct TableArea {
  // As cubes of that size need it.
  static TableArea of(const forms::CubeRow& row, double cube_mm) {
    return {.x_mm = row.x_mm,
            .y_low_mm = row.y_low_mm,
            .y_high_mm = row.y_high_mm,
            .comfortable_mm = cube_mm + 40,
            .least_mm = cube_mm + 26,
            .depth_mm = cube_mm + 30,
            .unhidden_mm = cube_mm + 6};
  }

  double x_mm = 450;
  double y_low_mm = -200;
  double y_high_mm = 200;
  double grid_mm = 10;
  // Sideways from centre to centre: what leaves the open fingers comfortable room, and what they need at least.
  double comfortable_mm = 100;
  double least_mm = 86;
  // Cubes that stand further away than this along x are not in the fingers' way, but might hide behind each other.
  double depth_mm = 90;
  // Sideways between cubes of which one stands before the other, so that the camera sees both.
  double unhidden_mm = 66;
  // How far from the row a spot may be, along x, and how far from the arm's axis.
  double aside_mm = 120;
  double reach_low_mm = 310;
  double reach_high_mm = 570;
};

// Whether a cube that stands there has its mark in both images.
using Shown = std::function<bool(const Eigen::Vector2d& spot)>;

// Those of the cubes with these centres that stand somewhere. An object that hangs in the gripper at `grip`, whatever
// it is taken for, stands nowhere.
std::vector<Eigen::Vector3d> standing(std::vector<Eigen::Vector3d> centres, const std::optional<Eigen::Vector3d>& grip,
                                      double cube_mm);

// The free spot nearest `from_y_mm` that is comfortably away from `occupied`; without one the roomiest of those that
// leave the least room. Where the row is full, one as near the row as there is, rather behind it, as seen from the
// camera, than before it.
std::optional<Eigen::Vector2d> free_spot(const TableArea& area, const std::vector<Eigen::Vector2d>& occupied,
                                         double from_y_mm, const Shown& shown = {});

// How far the gripper may open around a cube at `centre`, between narrow_mm and wide_mm, so that fingers `finger_mm`
// thick do not touch neighbours of `cube_mm`; only those that stand beside it at its own height count.
double opening_between(const Eigen::Vector3d& centre, const std::vector<Eigen::Vector3d>& neighbours, double cube_mm,
                       double finger_mm, double narrow_mm, double wide_mm);

}  // namespace pizarra::coordinator
