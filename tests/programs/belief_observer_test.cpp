#include "programs/chaos/belief_observer.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::chaos {
namespace {

story::Judge blocks_judge() {
  const Result<forms::Domain> read = forms::read_domain_file(source_dir() + "/domains/blocks.scm");
  return story::Judge::make(read.value(), 60).value();
}

// The circle stands alone, and the cross on the square. The camera looks at them along -x.
class BeliefObserving : public testing::Test {
 protected:
  BeliefObserving() {
    cube("circle", 0, 30);
    cube("square", 100, 30);
    cube("cross", 100, 90).on = "square";
    for (const auto& [name, cube] : world_.cubes) told_.places[name] = mark_of(cube);
    for (const char* fact : {"(on-table circle)", "(clear circle)", "(bare circle)", "(on-table square)",
                             "(on cross square)", "(clear cross)", "(bare cross)", "(arm-empty)"}) {
      told_.facts.insert(read_one(fact).value());
    }
  }

  story::WorldState::Cube& cube(const std::string& name, double y_mm, double z_mm) {
    story::WorldState::Cube& cube = world_.cubes[name];
    cube.x_mm = 450;
    cube.y_mm = y_mm;
    cube.z_mm = z_mm;
    cube.visible = 1;
    return cube;
  }
  static Eigen::Vector3d mark_of(const story::WorldState::Cube& cube) { return {cube.x_mm + 30, cube.y_mm, cube.z_mm}; }
  void pass(Duration time, bool quiet = true) {
    for (const Time end = now_ + time; now_ < end; now_ += 250ms) {
      observer_.look({.now = now_, .quiet = quiet, .world = &world_, .opening_mm = opening_mm_, .told = told_});
    }
  }

  const story::Judge judge_ = blocks_judge();
  std::vector<std::string> unsafe_;
  BeliefObserver observer_{{1330, 0, 200}, judge_, [this](const std::string& said) { unsafe_.push_back(said); }};
  story::WorldState world_;
  ToldBeliefs told_;
  double opening_mm_ = 100;
  Time now_{10s};
};

TEST_F(BeliefObserving, SaysNothingWhereWhatIsBelievedIsSo) {
  pass(5s);
  EXPECT_EQ(unsafe_, std::vector<std::string>());
}

TEST_F(BeliefObserving, FindsAPlaceThatIsWrongForMoreThanASecondOfQuietOnce) {
  told_.places["circle"].y() += 40;
  pass(1s);
  EXPECT_EQ(unsafe_, std::vector<std::string>());
  pass(3s);
  EXPECT_EQ(unsafe_,
            std::vector<std::string>{"circle is believed 40 mm from where it is in plain sight, turned by 11 degrees"});
}

TEST_F(BeliefObserving, FindsAnObjectOfWhichNothingIsBelieved) {
  told_.places.erase("circle");
  pass(2s);
  EXPECT_EQ(unsafe_, std::vector<std::string>{
                         "nothing is believed of where circle is, which is in plain sight, turned by 11 degrees"});
}

TEST_F(BeliefObserving, FindsFactsThatAreMissingAndFactsThatAreFalse) {
  told_.facts.erase(read_one("(on cross square)").value());
  told_.facts.insert(read_one("(on circle square)").value());
  pass(2s);
  EXPECT_EQ(unsafe_, (std::vector<std::string>{"(on circle square) is believed, and the world does not show it",
                                               "(on cross square) is in plain sight, and not believed"}));
}

TEST_F(BeliefObserving, WaitsForASecondInWhichNothingFails) {
  told_.places["circle"].y() += 40;
  for (int times = 0; times < 4; ++times) {
    pass(1s);
    pass(250ms, false);
  }
  EXPECT_EQ(unsafe_, std::vector<std::string>());
}

TEST_F(BeliefObserving, DoesNotJudgeWhatIsHiddenTurnedAwayLeansOrMoves) {
  told_.places["circle"].y() += 200;
  story::WorldState::Cube& circle = world_.cubes["circle"];
  const story::WorldState::Cube stands = circle;
  circle.visible = 0.9;
  pass(3s);
  circle = stands;
  circle.yaw_deg = 45;
  pass(3s);
  circle = stands;
  circle.loose = true;
  pass(3s);
  circle = stands;
  for (int step = 0; step < 12; ++step) {
    circle.y_mm += 5;
    pass(250ms);
  }
  EXPECT_EQ(unsafe_, std::vector<std::string>());
}

// Whether the cross is still there is known to nobody, and so whether the square is clear.
TEST_F(BeliefObserving, DoesNotJudgeFactsWhileACubeIsHiddenOrBelievedThoughItIsGone) {
  world_.cubes["cross"].visible = 0;
  pass(3s);
  world_.cubes["cross"].gone = true;
  told_.facts.insert(read_one("(clear square)").value());
  pass(3s);
  EXPECT_EQ(unsafe_, std::vector<std::string>());
}

TEST_F(BeliefObserving, DoesNotJudgeFactsWhileTheFingersStandAroundACubeThatTheyDoNotHold) {
  told_.facts.insert(read_one("(holding circle)").value());
  opening_mm_ = 66;
  pass(3s);
  EXPECT_EQ(unsafe_, std::vector<std::string>());
  opening_mm_ = 84;
  pass(3s);
  EXPECT_EQ(unsafe_, std::vector<std::string>{"(holding circle) is believed, and the world does not show it"});
}

}  // namespace
}  // namespace pizarra::chaos
