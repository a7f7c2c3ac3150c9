#include "lisp/writer.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

TEST(Truth, TellsWhatStandsOnWhat) {
  WorldConfig config = four_cubes();
  config.cubes[3].on = "square";
  Bench bench(config);
  EXPECT_EQ(bench.facts(),
            "(facts (on-table circle) (clear circle) (on-table cross) (clear cross) "
            "(on-table square) (on triangle square) (clear triangle) (arm-empty))");
}

TEST(Truth, AMarkBehindAnotherCubeIsNotVisible) {
  WorldConfig config;
  config.cubes = {{.name = "front", .x_mm = 520, .y_mm = -20}, {.name = "back", .x_mm = 400, .y_mm = -15}};
  Bench bench(config);
  EXPECT_EQ(bench.truth("front").visible, 1);
  EXPECT_LT(bench.truth("back").visible, 0.35);
  EXPECT_EQ(bench.outcome("(where-seen back)"), "not-seen");
  EXPECT_EQ(bench.outcome("(where-seen front)"), "ok");
}

TEST(Truth, AMarkOutOfTheImageIsNotVisible) {
  WorldConfig config;
  config.cubes = {{.name = "aside", .x_mm = 500, .y_mm = 340}};
  Bench bench(config);
  EXPECT_LT(bench.truth("aside").visible, 0.1);
}

TEST(Truth, AMarkIsSeenInPartWhereTheImageCutsOffTheFaceAroundIt) {
  WorldConfig config;
  config.cubes = {{.name = "near", .x_mm = 600, .y_mm = 0}};
  Bench bench(config);
  EXPECT_LT(bench.truth("near").visible, 1);
  EXPECT_GT(bench.truth("near").visible, 0.5);
}

TEST(Truth, AMarkThatOneCameraAloneSeesIsNotVisible) {
  WorldConfig config;
  config.cubes = {{.name = "aside", .x_mm = 450, .y_mm = -300}};
  Bench bench(config);
  EXPECT_EQ(bench.outcome("(where-seen aside)"), "ok") << "in the left image";
  EXPECT_LT(bench.truth("aside").visible, 0.1) << "there is no depth without the right one";
}

TEST(Truth, TheEndEffectorIsAnObjectToo) {
  Bench bench(four_cubes());
  bench.go(450, 0, 200);
  const Datum at = bench.ask("(where-seen End-Effector)");
  // Its triangle's centroid is 66 above the grip centre and 30 ahead of it.
  EXPECT_NEAR(at[0].number(), 159.5 + 431 * 45.0 / 850, 0.6);
  EXPECT_NEAR(at[1].number(), 119.5 - 431 * 66.0 / 850, 0.6);
}

TEST(Truth, NamesAreComparedWithoutCase) {
  Bench bench(four_cubes());
  EXPECT_EQ(write(bench.ask("(where-seen \"Circle\")")), write(bench.ask("(where-seen circle)")));
  EXPECT_EQ(bench.outcome("(where-seen star)"), "unknown-object");
}

TEST(Truth, TheSceneListsTheCubesWithTheirMarks) {
  Bench bench(four_cubes());
  const std::string scene = write(bench.ask("(scene)"));
  EXPECT_NE(scene.find("(cube triangle \"triangle\")"), std::string::npos) << scene;
  EXPECT_NE(scene.find("(camera 1330.0 0.0 200.0 0.0 0.0 0.0)"), std::string::npos) << scene;
}

TEST(Truth, ABumpedCameraSeesOtherwise) {
  Bench bench(four_cubes());
  const Datum before = bench.ask("(where-seen circle)");
  bench.ask("(camera bump 10 0 0 0 1 0)");
  const Datum after = bench.ask("(where-seen circle)");
  EXPECT_GT(after[1].number() - before[1].number(), 5) << "a camera that looks up sees things lower";
  EXPECT_NE(write(bench.ask("(scene)")).find("(camera 1340.0 0.0 200.0 0.0 1.0 0.0)"), std::string::npos);
  EXPECT_EQ(bench.outcome("(camera bump 10)"), "bad-request");
}

TEST(Truth, AHeadThatIsTurnedByHandSeesOtherwise) {
  WorldConfig config = four_cubes();
  config.camera.head = "ptu46-17.5";
  Bench bench(config);
  const Datum before = bench.ask("(where-seen circle)");
  bench.ask("(head nudge 1.5 0)");
  const Datum after = bench.ask("(where-seen circle)");
  EXPECT_LT(after[0].number() - before[0].number(), -5) << "a camera that looks right sees things further left";
  EXPECT_EQ(bench.outcome("(head nudge 1.5)"), "bad-request");
  EXPECT_EQ(Bench(four_cubes()).outcome("(head nudge 1.5 0)"), "bad-request") << "its cameras stand on no unit";
}

TEST(Truth, ATiltedCubeIsOnNothing) {
  WorldConfig config;
  config.cubes = {{.name = "circle", .x_mm = 450, .y_mm = 0}, {.name = "cross", .x_mm = 450, .y_mm = 90}};
  Bench bench(config);
  // Put down half over the other's edge it ends up leaning or on the table, never on it.
  bench.ask("(hand add star \"cross\" 450 38)");
  bench.wait(1s);
  EXPECT_NE(bench.truth("star").state, "(on circle)");
}

}  // namespace pizarra::simulation
