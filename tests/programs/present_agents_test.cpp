#include "programs/chaos/present_agents.hpp"

#include <gtest/gtest.h>

namespace pizarra::chaos {
namespace {

using Change = PresentAgents::Change;

TEST(PresentAgents, AreThereWhileTheirPresenceIsTold) {
  PresentAgents agents;
  EXPECT_EQ(agents.look("planner", 1, std::nullopt), Change::none);
  EXPECT_FALSE(agents.is_present("planner", 1));
  EXPECT_EQ(agents.look("planner", 1, 7), Change::came);
  EXPECT_EQ(agents.look("planner", 1, 7), Change::none);
  EXPECT_TRUE(agents.is_present("planner", 1));
  EXPECT_EQ(agents.look("planner", 1, std::nullopt), Change::went);
  EXPECT_FALSE(agents.is_present("planner", 1));
}

// The lease of a coordinator that was killed lapses up to two seconds later. Nobody perceives meanwhile, and what it
// believed stands.
TEST(PresentAgents, AreNotThereByWhatAnEarlierLifeOfTheirsTold) {
  PresentAgents agents;
  agents.look("coordinator", 1, 7);
  EXPECT_EQ(agents.look("coordinator", 2, 7), Change::none);
  EXPECT_FALSE(agents.is_present("coordinator", 2));
  EXPECT_EQ(agents.look("coordinator", 2, 31), Change::came);
  EXPECT_TRUE(agents.is_present("coordinator", 2));
}

}  // namespace
}  // namespace pizarra::chaos
