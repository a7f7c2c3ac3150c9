#pragma once

// A coordinator and three cubes in a row.

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "lisp/writer.hpp"
#include "tests/agents/coordinator/fake_cell.hpp"

namespace pizarra::coordinator {

class Coordinator : public testing::Test {
 protected:
  Coordinator() { cell.start_coordinator(); }
  void expect_on(const std::string& upper, const std::string& lower) {
    const Eigen::Vector3d apart = cell.cubes[upper] - cell.cubes[lower];
    EXPECT_LT(std::hypot(apart.x(), apart.y()), 4) << upper;
    EXPECT_NEAR(apart.z(), 60, 1) << upper;
  }
  std::string want(std::string_view goal) { return write(cell.request("coordinator", goal)); }

  FakeCell cell{"blocks.scm", {{"circle", {450, -150, 30}}, {"triangle", {455, -50, 30}}, {"square", {445, 50, 30}}}};
};

}  // namespace pizarra::coordinator
