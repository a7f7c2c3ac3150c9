// Bricks and cylinders: plain things that stand in the way.

#include "drivers/simulation/render/eye.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {
namespace {

// A long brick, a cube upon a flat one, and a cylinder, apart from each other.
WorldConfig things() {
  WorldConfig config;
  config.cubes = {{.name = "circle", .mark = Mark::circle, .x_mm = 450, .y_mm = 0}};
  config.things = {{.name = "wall", .shape = {.size_mm = {30, 120, 80}}, .x_mm = 450, .y_mm = -200},
                   {.name = "slab", .shape = {.size_mm = {140, 60, 40}}, .x_mm = 450, .y_mm = 120},
                   {.name = "can", .shape = {.is_round = true, .size_mm = {50, 50, 70}}, .x_mm = 400, .y_mm = 220}};
  return config;
}

TEST(Things, StandOnTheirOwnHeight) {
  Bench bench(things());
  bench.wait(2s);
  EXPECT_NEAR(bench.truth("wall").z_mm, 40, 1);
  EXPECT_NEAR(bench.truth("slab").z_mm, 20, 1);
  EXPECT_NEAR(bench.truth("can").z_mm, 35, 1);
  for (const char* name : {"wall", "slab", "can"}) EXPECT_EQ(bench.truth(name).state, "table") << name;
  EXPECT_EQ(bench.facts().find("wall"), std::string::npos) << "the task knows nothing of them";
}

TEST(Things, BearCubesAsFarAsTheyReach) {
  Bench bench(things());
  bench.ask("(hand place circle 500 120)");
  EXPECT_EQ(bench.truth("circle").state, "(on slab)");
  EXPECT_NEAR(bench.truth("circle").z_mm, 70, 1);
}

TEST(Things, ArePushedByCubes) {
  Bench bench(things());
  bench.ask("(hand push circle 0 80)");
  EXPECT_GT(bench.truth("slab").y_mm, 135);
}

TEST(Things, AreHeldWhereTheyFitBetweenTheFingers) {
  Bench bench(things());
  bench.pick(450, 120, 24, 60);
  EXPECT_EQ(bench.truth("slab").state, "held");
  EXPECT_EQ(bench.facts().find("(arm-empty)"), std::string::npos);
  bench.put(450, 120, 24);
  EXPECT_EQ(bench.truth("slab").state, "table");
  bench.pick(400, 220, 40, 50);
  EXPECT_EQ(bench.truth("can").state, "held");
  EXPECT_NEAR(bench.truth("can").z_mm, 300, 6);
}

TEST(Things, HideTheMarksBehindThem) {
  WorldConfig config = things();
  Bench open(config);
  EXPECT_GT(open.truth("circle").visible, 0.99);
  config.things.push_back({.name = "screen", .shape = {.size_mm = {20, 100, 120}}, .x_mm = 550, .y_mm = 0});
  Bench hidden(config);
  EXPECT_LT(hidden.truth("circle").visible, 0.01);
  config.things.back() = {
      .name = "post", .shape = {.is_round = true, .size_mm = {20, 20, 120}}, .x_mm = 550, .y_mm = 0};
  Bench partly(config);
  EXPECT_GT(partly.truth("circle").visible, 0.2);
  EXPECT_LT(partly.truth("circle").visible, 0.9);
}

TEST(Things, AreSeenWhereTheyStand) {
  const WorldConfig config = things();
  Bench bench(config);
  WorldConfig bare = config;
  bare.things.clear();
  Bench without(bare);
  const camera::StereoFrame frame = bench.frame();
  const camera::StereoFrame before = without.frame();
  const Eye eye = make_eye(config.camera, Side::left);
  for (const Eigen::Vector3d& at :
       {Eigen::Vector3d(465, -200, 40), Eigen::Vector3d(520, 120, 20), Eigen::Vector3d(425, 220, 35)}) {
    const Eigen::Vector3d seen = eye.project(at);
    const auto pixel = static_cast<std::size_t>(std::lround(seen.y()) * frame.left->width + std::lround(seen.x()));
    EXPECT_GT(std::abs(frame.left->pixels[pixel] - before.left->pixels[pixel]), 8) << at.transpose();
  }
}

TEST(Things, ThatCannotBeAreRefused) {
  const auto refused = [](const ThingConfig& thing) {
    WorldConfig config = things();
    config.things.push_back(thing);
    const Result<void> sound = check(config);
    return sound ? "sound" : sound.error().symbol;
  };
  EXPECT_TRUE(check(things()));
  const BodyShape shape{.size_mm = {30, 30, 30}};
  EXPECT_EQ(refused({"Circle", shape, 300, 0}), "bad-cell") << "a cube has this name";
  EXPECT_EQ(refused({"can", shape, 300, 0}), "bad-cell");
  EXPECT_EQ(refused({"a b", shape, 300, 0}), "bad-cell");
  EXPECT_EQ(refused({"small", {.size_mm = {9, 30, 30}}, 300, 0}), "bad-cell");
  EXPECT_EQ(refused({"tall", {.size_mm = {30, 30, 151}}, 300, 0}), "bad-cell");
  EXPECT_EQ(refused({"far", shape, 700, 0}), "bad-cell");
}

}  // namespace
}  // namespace pizarra::simulation
