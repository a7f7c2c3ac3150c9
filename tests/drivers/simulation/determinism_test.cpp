#include <functional>

#include "lisp/writer.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

namespace {

// A run with everything in it, as one number.
std::size_t story(std::uint64_t seed) {
  WorldConfig config = four_cubes();
  config.seed = seed;
  Bench bench(config);
  std::string all;
  const auto look = [&] {
    const camera::StereoFrame frame = bench.frame();
    for (const auto& image : {frame.left, frame.right}) all.append(image->pixels.begin(), image->pixels.end());
    all += write(bench.ask("(truth)"));
  };
  look();
  bench.pick(450, -150, 30);
  look();
  bench.put(450, -50, 90);
  look();
  bench.ask("(hand knock circle)");
  look();
  bench.ask("(hand push triangle -20 -30)");
  look();
  return std::hash<std::string>()(all);
}

}  // namespace

TEST(Determinism, TheSameSeedGivesTheSameFramesAndPoses) {
  EXPECT_EQ(story(7), story(7));
  EXPECT_NE(story(7), story(8));
}

TEST(Determinism, LookingChangesNothing) {
  const auto end = [](bool look) {
    Bench bench(four_cubes());
    for (int i = 0; i < 40; ++i) {
      if (i == 5) {
        EXPECT_TRUE(run(bench.executor, bench.arm.start_move({bench.config.arm.home}, 0.5)));
      }
      bench.wait(37ms);
      if (look) bench.ask("(truth)");
    }
    return write(bench.ask("(truth)")) + write(bench.ask("(arm read)"));
  };
  EXPECT_EQ(end(true), end(false));
}

TEST(Determinism, FramesDoNotDependOnWhichWereTakenBefore) {
  const auto last = [](bool watch) {
    Bench bench(four_cubes());
    for (int i = 0; i < 10; ++i) {
      bench.wait(100ms);
      if (watch) bench.ask("(camera next 0 grey)");
    }
    bench.executor.run_for(Time(3s) - bench.executor.now());
    const camera::StereoFrame frame = bench.frame();
    EXPECT_EQ(frame.captured, Time(3s));
    return frame.left->pixels;
  };
  EXPECT_EQ(last(true), last(false));
}

}  // namespace pizarra::simulation
