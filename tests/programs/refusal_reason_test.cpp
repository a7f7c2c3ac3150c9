#include "programs/chaos/refusal_reason.hpp"

#include <gtest/gtest.h>

#include "agents/coordinator/perceive/missing_objects.hpp"

namespace pizarra::chaos {
namespace {

// The circle was taken away, the square lies beyond the arm's reach, and the triangle is there.
struct Table {
  Table() {
    world.cubes["circle"].gone = true;
    world.cubes["square"] = {};
    story::WorldState::Cube& triangle = world.cubes["triangle"];
    triangle.x_mm = 450;
    triangle.y_mm = -300;
    triangle.z_mm = 30;
    had = world;
    had.cubes["square"].gone = true;
  }
  std::optional<std::string> denies(const Failure& told) const { return denied_reason(told, world, had); }
  std::optional<std::string> denies_missing(const std::vector<std::string>& names) const {
    return denies(coordinator::missing_objects(names));
  }

  story::WorldState world;
  story::WorldState had;
};

Failure failure(const std::string& symbol) { return {symbol, "so it is said", {}, {}}; }

TEST(RefusalReason, AnObjectIsMissingThatIsGoneOrOutOfReach) {
  const Table table;
  EXPECT_EQ(table.denies_missing({"Circle"}), std::nullopt);
  EXPECT_EQ(table.denies_missing({"SQUARE"}), std::nullopt);
  EXPECT_EQ(table.denies_missing({"circle", "square"}), std::nullopt);
}

TEST(RefusalReason, AnObjectThatIsThereIsNotMissingThoughAnotherIs) {
  const Table table;
  EXPECT_EQ(table.denies_missing({"Triangle"}), "Triangle is there, at (450 -300 30), 0 % of its mark in sight");
  EXPECT_TRUE(table.denies_missing({"circle", "triangle"}));
}

TEST(RefusalReason, AnObjectThatTheWorldNeverHadIsMissing) {
  EXPECT_EQ(Table().denies_missing({"star"}), std::nullopt);
}

TEST(RefusalReason, NothingIsUnreachableWhereTheArmReachesAllThatIsThere) {
  Table table;
  EXPECT_EQ(table.denies(failure("unreachable")), std::nullopt);
  table.world.cubes["square"].gone = true;
  EXPECT_EQ(table.denies(failure("unreachable")), "nothing in the world is unreachable");
}

TEST(RefusalReason, WhereNoPlanExistsThatIsAReasonAndAFailureOfTheCellIsNone) {
  const Table table;
  EXPECT_EQ(table.denies(failure("no-plan")), std::nullopt);
  for (const char* symbol : {"absent", "stopped", "gave-up", "missed", "timeout"}) {
    EXPECT_TRUE(table.denies(failure(symbol))) << symbol;
  }
}

}  // namespace
}  // namespace pizarra::chaos
