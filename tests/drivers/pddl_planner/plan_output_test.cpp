#include "drivers/pddl_planner/plan_output.hpp"

#include <gtest/gtest.h>

namespace pizarra::pddl_planner {
namespace {

const PlanOperators three_operators{{"pick-up", 1}, {"stack", 2}, {"rest", 0}};
const PlanActions three_actions{{"pick-up", "b1"}, {"stack", "b1", "b2"}, {"rest"}};

TEST(PlanOutput, IsReadAsFastDownwardWritesItToAFile) {
  EXPECT_EQ(read_actions("(pick-up b1)\n(stack b1 b2)\n(rest)\n; cost = 3 (unit cost)\n", three_operators).value(),
            three_actions);
}

TEST(PlanOutput, IsReadAsTemporalPlannersWriteIt) {
  EXPECT_EQ(read_actions("0.000: (PICK-UP B1) [1.000]\n1.001: (STACK B1 B2) [1]\n2: (REST)", three_operators).value(),
            three_actions);
}

TEST(PlanOutput, IsFoundInFfsWords) {
  EXPECT_EQ(find_actions("ff: parsing domain file\nff: found legal plan as follows\n\nstep    0: PICK-UP B1\n"
                         "        1: STACK B1 B2\r\n        2: REST\n\ntime spent:    0.00 seconds\n",
                         three_operators),
            three_actions);
}

TEST(PlanOutput, IsFoundInMadagascarsParallelSteps) {
  EXPECT_EQ(find_actions("Horizon 2: 12 variables\nSTEP 0: pick-up(b1)\nSTEP 1: stack(b1,b2) rest()\n1 seconds\n",
                         three_operators),
            three_actions);
}

TEST(PlanOutput, IsFoundInFastDownwardsLog) {
  EXPECT_EQ(
      find_actions("[t=0.02s] Solution found!\npick-up b1 (1)\nstack b1 b2 (1)\nrest (1)\nPlan length: 3 step(s).\n",
                   three_operators),
      three_actions);
}

TEST(PlanOutput, OfSeveralPlansTheLastCounts) {
  EXPECT_EQ(find_actions("0: (rest)\n1: (rest)\n0: (pick-up b1)\n1: (stack b1 b2)\n2: (rest)\n", three_operators),
            three_actions);
}

TEST(PlanOutput, MayHoldNoPlan) {
  EXPECT_TRUE(find_actions("", three_operators).empty());
  EXPECT_TRUE(find_actions("(fly b1)\nstep 0: pick-up b1 b2\n\xFF\x00(\n()\n:::\n0:\n", three_operators).empty());
}

TEST(PlanOutput, OfAFileWithOtherLinesIsGarbage) {
  EXPECT_EQ(read_actions("(pick-up b1)\n(fly b1)\n", three_operators).error().symbol, "garbage");
  EXPECT_EQ(read_actions("(pick-up b1)\n(stack b1", three_operators).error().symbol, "garbage");
  EXPECT_TRUE(read_actions("; nothing to do\n\n", three_operators).value().empty());
}

}  // namespace
}  // namespace pizarra::pddl_planner
