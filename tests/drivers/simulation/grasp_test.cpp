#include <cmath>

#include "blackboard/time/random.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

TEST(Grasp, LiftsACubeAndReadsItsWidth) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  EXPECT_EQ(bench.truth("circle").state, "held");
  EXPECT_NEAR(bench.truth("circle").z_mm, 300, 1);
  EXPECT_NEAR(bench.reading().opening_mm, 60, 1);
  EXPECT_NE(bench.facts().find("(holding circle)"), std::string::npos);
  EXPECT_EQ(bench.facts().find("(arm-empty)"), std::string::npos);
}

TEST(Grasp, TakesCubesOfSeveralSizesOffATowerAndReadsTheirWidths) {
  WorldConfig config;
  config.cubes = {{.name = "large", .x_mm = 450, .y_mm = 0},
                  {.name = "middle", .on = "large", .edge_mm = 50},
                  {.name = "small", .on = "middle", .edge_mm = 40}};
  Bench bench(config);
  EXPECT_EQ(bench.truth("middle").state, "(on large)");
  EXPECT_EQ(bench.truth("small").state, "(on middle)");
  EXPECT_NEAR(bench.truth("small").z_mm, 130, 1);
  bench.pick(450, 0, 130, 40);
  EXPECT_EQ(bench.truth("small").state, "held");
  EXPECT_NEAR(bench.reading().opening_mm, 40, 1);
  bench.put(450, 150, 22);
  EXPECT_EQ(bench.truth("small").state, "table");
  bench.pick(450, 0, 85, 50);
  EXPECT_NEAR(bench.reading().opening_mm, 50, 1);
  bench.put(450, -150, 27);
  EXPECT_EQ(bench.truth("middle").state, "table");
}

TEST(Grasp, TurnsATurnedCubeStraight) {
  WorldConfig config;
  config.cubes = {{.name = "circle", .x_mm = 450, .y_mm = 0, .yaw_deg = 14}};
  Bench bench(config);
  bench.pick(450, 0, 30);
  EXPECT_EQ(bench.truth("circle").state, "held");
  EXPECT_LT(std::abs(bench.truth("circle").yaw_deg), 3);
}

TEST(Grasp, TakesACubeThatIsOffCentre) {
  Bench bench(four_cubes());
  bench.pick(450, -158, 30);
  EXPECT_EQ(bench.truth("circle").state, "held");
}

TEST(Grasp, MissesWhereNothingIs) {
  Bench bench(four_cubes());
  bench.go(450, 0, 300);
  bench.go(450, 0, 200);
  EXPECT_EQ(bench.grip(0), 0);
  EXPECT_NE(bench.facts().find("(arm-empty)"), std::string::npos);
}

TEST(Grasp, DropsWhatIsLetGoInTheAir) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  bench.grip(84);
  bench.wait(1s);
  const TruthOf cube = bench.truth("circle");
  EXPECT_NE(cube.state, "held");
  EXPECT_LT(cube.z_mm, 60);
}

TEST(Grasp, StacksFourThatStand) {
  Bench bench(four_cubes());
  bench.pick(450, 50, 30);
  bench.put(450, 150, 90);
  bench.pick(450, -50, 30);
  bench.put(450, 150, 150);
  EXPECT_EQ(bench.truth("square").state, "(on triangle)");
  EXPECT_EQ(bench.truth("cross").state, "(on square)");
  bench.pick(450, -150, 30);
  bench.put(450, 150, 210);
  bench.wait(2s);
  EXPECT_EQ(bench.truth("circle").state, "(on cross)");
  EXPECT_EQ(bench.facts(),
            "(facts (on circle cross) (clear circle) (on cross square) (on square triangle) "
            "(on-table triangle) (arm-empty))");
  EXPECT_NEAR(bench.truth("circle").y_mm, 150, 4);
}

TEST(Grasp, HoldsWhateverLiesWithinItsTolerances) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    WorldConfig config;
    config.cubes = {{.name = "circle",
                     .x_mm = 450 + random.uniform(-15, 15),
                     .y_mm = random.uniform(-6, 6),
                     .yaw_deg = random.uniform(-9, 9)}};
    Bench bench(config);
    bench.go(450, 0, 300);
    bench.go(450, 0, 30, 0.2);
    const double opening_mm = bench.grip(0);
    EXPECT_NEAR(opening_mm, 60, 3) << "seed " << seed;
    // At full speed, round a corner.
    EXPECT_TRUE(bench.go(450, 0, 300, 1)) << "seed " << seed;
    EXPECT_TRUE(bench.go(400, 200, 200, 1)) << "seed " << seed;
    EXPECT_EQ(bench.truth("circle").state, "held") << "seed " << seed;
    EXPECT_LT(std::abs(bench.truth("circle").yaw_deg), 8) << "seed " << seed;
  }
}

TEST(Grasp, AStaircaseTooSteepTopples) {
  Bench bench(four_cubes());
  bench.pick(450, 50, 30);
  bench.put(450, 150 - 36, 90);
  bench.wait(1s);
  EXPECT_NE(bench.truth("square").state, "(on triangle)");
}

TEST(Grasp, ASwingingArmKnocksATowerOver) {
  WorldConfig config;
  config.cubes = {{.name = "low", .x_mm = 450, .y_mm = 0}, {.name = "high", .on = "low"}};
  Bench bench(config);
  bench.go(450, -150, 300);
  bench.go(450, -150, 90);
  bench.go(450, 60, 90, 0.3);
  bench.wait(1s);
  EXPECT_NE(bench.truth("high").state, "(on low)");
}

TEST(Grasp, TheArmStopsAtTheTable) {
  Bench bench(four_cubes());
  bench.go(450, 0, 100);
  EXPECT_FALSE(bench.go(450, 0, 5, 0.1));
  EXPECT_TRUE(bench.reading().stopped);
  // And can get away again.
  EXPECT_TRUE(bench.go(450, 0, 100, 0.1));
}

TEST(Grasp, TheArmStopsWhenTheHeldCubeMeetsAnother) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  bench.go(450, -50, 300);
  EXPECT_FALSE(bench.go(450, -50, 60, 0.1));
  EXPECT_EQ(bench.truth("cross").state, "table");
  EXPECT_NEAR(bench.truth("circle").z_mm, 90, 6);
  bench.grip(84);
  bench.go(450, -50, 300, 0.2);
  EXPECT_EQ(bench.truth("circle").state, "(on cross)");
}

}  // namespace pizarra::simulation
