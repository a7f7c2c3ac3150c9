#include <gtest/gtest.h>

#include "lisp/forms/cell_file.hpp"

namespace pizarra {
namespace {

TEST(Cell, AGripperOpensAsItsSetupSaysWhereTheFileSaysNothing) {
  const Result<forms::CellDescription> cell =
      forms::read_cell("(cell c (arm crs-f3 (gripper (driver modbus \"g\"))))", "c");
  ASSERT_TRUE(cell) << describe(cell.error());
  const forms::GripperSetup& given = cell->arm_line.gripper;
  const forms::GripperSetup setup;
  EXPECT_EQ(given.closed_mm, setup.closed_mm);
  EXPECT_EQ(given.open_mm, setup.open_mm);
}

TEST(Cell, AGripperIsLaidOutAsItsSetupIsUnlessTheFileSaysOtherwise) {
  const Result<forms::CellDescription> cell = forms::read_cell(
      "(cell c (arm crs-f3 (gripper (driver modbus \"g\") (opening 0 85) (force 30) (registers (go 1000 9 1)))))", "c");
  ASSERT_TRUE(cell) << describe(cell.error());
  const forms::GripperSetup& given = cell->arm_line.gripper;
  const forms::GripperSetup otherwise;
  EXPECT_EQ(given.protocol, "modbus");
  EXPECT_EQ(given.place, "g");
  EXPECT_EQ(given.port, otherwise.port);
  EXPECT_EQ(given.unit, otherwise.unit);
  EXPECT_EQ(given.open_mm, 85);
  EXPECT_EQ(given.closed_count, otherwise.closed_count);
  EXPECT_EQ(given.open_count, otherwise.open_count);
  EXPECT_EQ(given.speed, otherwise.speed);
  EXPECT_EQ(given.force, 0.3);
  EXPECT_EQ(given.go, (forms::RegisterField{1000, 9, 1}));
  for (const auto field :
       {&forms::GripperSetup::activate, &forms::GripperSetup::target, &forms::GripperSetup::speed_field,
        &forms::GripperSetup::force_field, &forms::GripperSetup::active, &forms::GripperSetup::object,
        &forms::GripperSetup::fault, &forms::GripperSetup::opening}) {
    EXPECT_EQ(given.*field, otherwise.*field);
  }
}

}  // namespace
}  // namespace pizarra
