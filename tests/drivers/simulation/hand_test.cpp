#include <cmath>
#include <fmt/format.h>

#include "lisp/reader.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

TEST(Hand, PushesACubeWhereItIsTold) {
  Bench bench(four_cubes());
  const Time before = bench.executor.now();
  bench.ask("(hand push circle -40 -50)");
  const TruthOf cube = bench.truth("circle");
  EXPECT_NEAR(cube.x_mm, 410, 5);
  EXPECT_NEAR(cube.y_mm, -200, 5);
  EXPECT_EQ(cube.state, "table");
  EXPECT_GE(bench.executor.now() - before, 500ms);
  EXPECT_NEAR(bench.truth("cross").y_mm, -50, 0.1);
}

TEST(Hand, SlidesACubeAtTheSpeedThatItIsTold) {
  Bench bench(four_cubes());
  const double from_mm = bench.truth("circle").x_mm;
  std::optional<Result<Message>> answer;
  const Job job = bench.executor.spawn(keep(bench.link.call(*read_one("(hand slide circle -40 0 50)"), 20s), answer));
  bench.wait(400ms);
  EXPECT_NEAR(bench.truth("circle").x_mm, from_mm - 20, 2);
  bench.wait(2s);
  EXPECT_NEAR(bench.truth("circle").x_mm, from_mm - 40, 2);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(*answer);
  EXPECT_EQ(bench.outcome("(hand slide circle 10 0 0)"), "bad-request");
}

TEST(Hand, APushedCubePushesItsNeighbour) {
  Bench bench(four_cubes());
  bench.ask("(hand push circle 0 90)");
  EXPECT_NEAR(bench.truth("circle").y_mm, -60, 6);
  EXPECT_GE(bench.truth("cross").y_mm, bench.truth("circle").y_mm + 59);
}

TEST(Hand, ACubePushedOverTheEdgeIsGone) {
  Bench bench(four_cubes());
  bench.ask("(hand push triangle 0 240)");
  bench.wait(1s);
  EXPECT_EQ(bench.truth("triangle").state, "gone");
  EXPECT_EQ(bench.truth("triangle").visible, 0);
  EXPECT_EQ(bench.outcome("(hand push triangle 0 10)"), "unknown-object");
}

TEST(Hand, PlacesAndStacksStraight) {
  Bench bench(four_cubes());
  bench.ask("(hand place circle 380 200)");
  EXPECT_NEAR(bench.truth("circle").x_mm, 380, 3);
  EXPECT_NEAR(bench.truth("circle").y_mm, 200, 3);
  bench.ask("(hand stack cross square)");
  EXPECT_EQ(bench.truth("cross").state, "(on square)");
  EXPECT_EQ(bench.outcome("(hand stack cross cross)"), "bad-request");
}

TEST(Hand, HoldsACubeInTheWayAndPutsItBack) {
  Bench bench(four_cubes());
  const TruthOf before = bench.truth("circle");
  std::optional<Result<Message>> answer;
  const Job job = bench.executor.spawn(keep(bench.link.call(*read_one("(hand hold circle 450 0 250 3)"), 20s), answer));
  bench.wait(3s);
  EXPECT_NEAR(bench.truth("circle").y_mm, 0, 5);
  EXPECT_NEAR(bench.truth("circle").z_mm, 250, 5);
  EXPECT_EQ(bench.truth("circle").state, "carried");
  bench.wait(6s);
  EXPECT_NEAR(bench.truth("circle").x_mm, before.x_mm, 3);
  EXPECT_NEAR(bench.truth("circle").y_mm, before.y_mm, 3);
  EXPECT_EQ(bench.truth("circle").state, "table");
  ASSERT_TRUE(answer);
  EXPECT_TRUE(*answer);
  EXPECT_EQ(bench.outcome("(hand hold circle 450 0 250 61)"), "bad-request");
}

TEST(Hand, TurnsACubeWhereItStandsAlsoOnAnother) {
  WorldConfig config = four_cubes();
  config.cubes.push_back({.name = "top", .on = "square"});
  Bench bench(config);
  for (const char* cube : {"circle", "top"}) {
    const TruthOf before = bench.truth(cube);
    bench.ask(fmt::format("(hand turn {} 90)", cube));
    bench.ask(fmt::format("(hand turn {} -30)", cube));
    const TruthOf after = bench.truth(cube);
    EXPECT_NEAR(after.x_mm, before.x_mm, 3) << cube;
    EXPECT_NEAR(after.y_mm, before.y_mm, 3) << cube;
    EXPECT_NEAR(std::remainder(after.yaw_deg - before.yaw_deg - 60, 90), 0, 2) << cube;
    EXPECT_EQ(after.state, before.state) << cube;
  }
  EXPECT_EQ(bench.outcome("(hand turn circle 181)"), "bad-request");
  EXPECT_EQ(bench.outcome("(hand turn circle)"), "bad-request");
}

TEST(Hand, KnocksATowerOver) {
  WorldConfig config;
  config.cubes = {{.name = "a", .x_mm = 450, .y_mm = 0}, {.name = "b", .on = "a"}, {.name = "c", .on = "b"}};
  Bench bench(config);
  bench.wait(1s);
  EXPECT_EQ(bench.truth("c").state, "(on b)");
  bench.ask("(hand knock b)");
  bench.wait(1s);
  EXPECT_NE(bench.truth("b").state, "(on a)");
  EXPECT_NE(bench.truth("c").state, "(on b)");
}

TEST(Hand, StealsOutOfTheGripper) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  EXPECT_EQ(bench.truth("circle").state, "held");
  bench.ask("(hand steal circle)");
  EXPECT_EQ(bench.truth("circle").state, "gone");
  EXPECT_NE(bench.facts().find("(arm-empty)"), std::string::npos);
  // The gripper notices when it closes.
  EXPECT_EQ(bench.grip(0), 0);
}

TEST(Hand, StealingTheLowestMakesTheTowerFall) {
  WorldConfig config;
  config.cubes = {{.name = "a", .x_mm = 450, .y_mm = 0}, {.name = "b", .on = "a"}};
  Bench bench(config);
  bench.ask("(hand steal a)");
  bench.wait(1s);
  EXPECT_EQ(bench.truth("a").state, "gone");
  EXPECT_LT(bench.truth("b").z_mm, 60);
}

TEST(Hand, BringsNothingBackToWhereTheGripperStands) {
  Bench bench(four_cubes());
  bench.ask("(hand remove square)");
  bench.wait(3s);
  bench.go(420, 60, 120);
  EXPECT_EQ(bench.outcome("(hand add square \"square\" 430 40)"), "busy");
  bench.go(420, -200, 300);
  bench.ask("(hand add square \"square\" 430 40)");
  bench.wait(3s);
  EXPECT_EQ(bench.truth("square").state, "table");
}

TEST(Hand, RemovesAndAdds) {
  Bench bench(four_cubes());
  bench.ask("(hand remove square)");
  EXPECT_EQ(bench.truth("square").state, "gone");
  bench.ask("(hand add square \"square\" 420 60)");
  EXPECT_EQ(bench.truth("square").state, "table");
  bench.ask("(hand add star \"cross\" 450 -220)");
  EXPECT_EQ(bench.truth("star").state, "table");
  EXPECT_EQ(bench.outcome("(hand add star \"cross\" 450 0)"), "bad-request");
  EXPECT_EQ(bench.outcome("(hand add moon \"moon\" 450 0)"), "bad-request");
}

TEST(Hand, DoesOneThingAtATime) {
  Bench bench(four_cubes());
  std::optional<Result<Message>> first;
  const Job job = bench.executor.spawn(keep(bench.link.call(*read_one("(hand place circle 380 200)"), 20s), first));
  bench.wait(200ms);
  EXPECT_EQ(bench.truth("circle").state, "carried");
  EXPECT_EQ(bench.outcome("(hand push cross 10 0)"), "busy");
  bench.wait(5s);
  ASSERT_TRUE(first);
  EXPECT_TRUE(*first);
}

TEST(Hand, PullsACubeFromAHoldThatIsTooWeak) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  bench.ask("(hand push circle 120 0)");
  EXPECT_NE(bench.truth("circle").state, "held");
}

TEST(Hand, RefusesWhatItDoesNotKnow) {
  Bench bench(four_cubes());
  EXPECT_EQ(bench.outcome("(hand push moon 1 1)"), "unknown-object");
  EXPECT_EQ(bench.outcome("(hand juggle circle)"), "bad-request");
  EXPECT_EQ(bench.outcome("(hand push circle far 1)"), "bad-request");
  EXPECT_EQ(bench.outcome("(hand push circle 1e9 1)"), "bad-request");
  EXPECT_EQ(bench.outcome("nonsense"), "bad-request");
  EXPECT_EQ(bench.outcome("()"), "bad-request");
}

}  // namespace pizarra::simulation
