#include <cmath>

#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

TEST(ClumsyFingers, LetSlipWhatTheyHoldAndCloseBehindIt) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  bench.ask("(fingers slip)");
  bench.wait(2s);
  EXPECT_EQ(bench.reading().opening_mm, 0);
  const TruthOf cube = bench.truth("circle");
  EXPECT_NE(cube.state, "held");
  EXPECT_LT(cube.z_mm, 60);
}

TEST(ClumsyFingers, HaveNothingToLetSlip) {
  Bench bench(four_cubes());
  EXPECT_EQ(bench.outcome("(fingers slip)"), "not-held");
  EXPECT_EQ(bench.outcome("(fingers slips 2 1 6)"), "bad-request");
  EXPECT_EQ(bench.outcome("(fingers slips 0.5 0 6)"), "bad-request");
  EXPECT_EQ(bench.outcome("(fingers misplace -1)"), "bad-request");
}

TEST(ClumsyFingers, LetASlippedCubeBeTakenAgain) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  bench.go(450, -150, 40);
  bench.ask("(fingers slip)");
  bench.wait(1s);
  bench.go(450, -150, 300);
  const TruthOf cube = bench.truth("circle");
  ASSERT_EQ(cube.state, "table");
  bench.pick(cube.x_mm, cube.y_mm, 30);
  EXPECT_EQ(bench.truth("circle").state, "held");
}

// It fell a little, and the fingers rose no further than it takes to open above it.
TEST(ClumsyFingers, LetACubeThatSlippedCloseBelowThemBeTakenAgain) {
  Bench bench(four_cubes());
  bench.pick(450, -150, 30);
  bench.go(450, -150, 50);
  bench.ask("(fingers slip)");
  bench.wait(1s);
  bench.go(450, -150, 84);
  const TruthOf cube = bench.truth("circle");
  ASSERT_EQ(cube.state, "table");
  bench.grip(95);
  bench.go(cube.x_mm, cube.y_mm, 30);
  bench.grip(0);
  EXPECT_EQ(bench.truth("circle").state, "held");
}

TEST(ClumsyFingers, SlipAtAnInstantOfTheirOwnWhileNothingElseMoves) {
  Bench bench(four_cubes());
  bench.ask("(fingers slips 1 1 5)");
  bench.pick(450, -150, 30);
  bench.wait(6s);
  EXPECT_NE(bench.truth("circle").state, "held");
}

TEST(ClumsyFingers, PutDownWithinThePartOfTheEdge) {
  double furthest_mm = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    WorldConfig config = four_cubes();
    config.seed = seed;
    Bench bench(config);
    bench.ask("(fingers misplace 0.5)");
    bench.pick(450, -150, 30);
    bench.put(450, -150, 31);
    const TruthOf cube = bench.truth("circle");
    EXPECT_EQ(cube.state, "table") << seed;
    furthest_mm = std::max(furthest_mm, std::hypot(cube.x_mm - 450, cube.y_mm + 150));
  }
  EXPECT_GT(furthest_mm, 10);
  EXPECT_LT(furthest_mm, 32);
}

}  // namespace pizarra::simulation
