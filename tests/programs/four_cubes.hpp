#pragma once

// A cell of four cubes, from which random stories are drawn.
//
//   const story::RandomStory story = story::random_story(four_cubes(), Random(seed));

#include <gtest/gtest.h>

#include "lisp/forms/cell_file.hpp"

namespace pizarra::programs {

inline forms::CellDescription four_cubes() {
  forms::CellDescription cell;
  EXPECT_TRUE(forms::put_arm(cell, "crs-f3"));
  for (const char* name : {"circle", "triangle", "square", "cross"}) cell.cubes.push_back({name, name, 450, 0, 0, ""});
  // As of a cell file that says nothing of it.
  cell.camera.sure_mm = 20;
  cell.camera.sure_deg = 2;
  return cell;
}

}  // namespace pizarra::programs
