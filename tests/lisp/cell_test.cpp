#include <gtest/gtest.h>

#include "lisp/forms/cell_file.hpp"
#include "lisp/forms/named_parts.hpp"
#include "lisp/reader.hpp"

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

TEST(Cell, ModulesOfAnotherVersionAreToldByThePartThatTheyDoNotTell) {
  constexpr std::string_view names[] = {"arm", "hosts"};
  const Datum told = read_one("((hosts (a b)) (arm crs-f3))").value();
  const Result<forms::NamedParts> parts = forms::NamedParts::of(told, "cell", names);
  ASSERT_TRUE(parts) << describe(parts.error());
  EXPECT_EQ(parts->at("arm"), Datum::symbol("crs-f3"));
  for (const char* other : {"((arm crs-f3))", "((arm crs-f3) (hosts))", "(crs-f3 (a b))", "()"}) {
    const Result<forms::NamedParts> wrong = forms::NamedParts::of(read_one(other).value(), "cell", names);
    ASSERT_FALSE(wrong) << other;
    EXPECT_TRUE(wrong.error().sentence.starts_with("the module (pizarra cell) is of another version: it tells no "));
  }
}

}  // namespace
}  // namespace pizarra
