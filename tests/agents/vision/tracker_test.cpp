#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agents/vision/agent/reply_text.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

constexpr int bridged_frames = 5;  // ten a second

class Tracker : public testing::Test {
 protected:
  // The five in a row, in the order of cell_marks().
  Tracker() {
    for (std::size_t i = 0; i < cell_marks().size(); ++i) {
      scene.faces.push_back(
          {.mark = drawn_as(cell_marks()[i]), .place = {-160 + 80.0 * static_cast<double>(i), 0, 850}});
    }
  }
  SceneFace& face(const std::string& name) {
    return scene.faces[static_cast<std::size_t>(std::ranges::find(cell_marks(), name) - cell_marks().begin())];
  }
  void track(const std::string& name) { ASSERT_TRUE(tracker.add(*learned_cell().find(name))); }
  std::vector<TrackSighting> see() {
    DrawnSight drawn(scene, random);
    now += between;
    return tracker.update(drawn.sight, now);
  }
  void expect_at(const TrackSighting& sighting, const cv::Point3d& place) {
    ASSERT_TRUE(sighting.seen) << sighting.name;
    EXPECT_LT(cv::norm(sighting.centre - project(DrawnSight::model(), place, false)), 0.4) << sighting.name;
    EXPECT_NEAR(sighting.range_mm, cv::norm(place), 4) << sighting.name;
  }

  Scene scene;
  Random random{5};
  Duration between = 100ms;  // frames
  Time now = {};
  MarkTracker tracker{learned_cell()};
};

TEST_F(Tracker, PutsTheEndEffectorFirstAndFollowsAll) {
  for (const std::string& name : cell_marks()) track(name);
  track("circle");
  const std::vector<TrackSighting> sightings = see();
  ASSERT_EQ(sightings.size(), 5U);
  EXPECT_EQ(sightings[0].name, "end-effector");
  EXPECT_EQ(sightings[1].name, "circle");
  for (const TrackSighting& sighting : sightings) expect_at(sighting, face(sighting.name).place);
}

TEST_F(Tracker, TakesAsManyObjectsAsCanBeKnownAndRefusesOneMore) {
  LearnedObject object = *learned_cell().find("cross");
  for (std::size_t i = 0; i < most_objects; ++i) {
    object.name = fmt::format("cross-{}", i);
    ASSERT_TRUE(tracker.add(object)) << object.name;
  }
  ASSERT_TRUE(tracker.add(object)) << "once more is harmless";
  object.name = "one-more";
  const Result<void> refused = tracker.add(object);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().symbol, "full");
  EXPECT_EQ(see().size(), most_objects);
}

TEST_F(Tracker, FollowsAMotionThatSpeedsUpAndTurns) {
  track("cross");
  for (int frame = 0; frame < 25; ++frame) {
    const double t = frame * 0.1;
    scene.faces = {{.mark = "cross",
                    .place = {120 * std::sin(2 * t), 60 * std::cos(2 * t), 850 + 40 * std::sin(t)},
                    .yaw_deg = 30 * std::sin(3 * t)}};
    const std::vector<TrackSighting> sightings = see();
    SCOPED_TRACE(frame);
    expect_at(sightings[0], scene.faces[0].place);
  }
}

TEST_F(Tracker, LosesAHiddenObjectAndRecoversItWhileTheOthersGoOn) {
  for (const std::string name : {"circle", "square", "triangle"}) track(name);
  see();
  const cv::Point2d centre = project(DrawnSight::model(), face("square").place, false);
  scene.blots = {{.box = {centre.x - 25, centre.y - 25, 50, 50}, .level = 150, .disparity_px = 46}};
  for (int frame = 0; frame < 3; ++frame) {
    const std::vector<TrackSighting> sightings = see();
    EXPECT_FALSE(sightings[1].seen);
    expect_at(sightings[0], face("circle").place);
    expect_at(sightings[2], face("triangle").place);
  }
  scene.blots.clear();
  expect_at(see()[1], face("square").place);
}

TEST_F(Tracker, FindsAnObjectThatJumpedInTheSameFrame) {
  for (const std::string name : {"circle", "cross"}) track(name);
  see();
  face("circle").place = {-150, 90, 880};
  const std::vector<TrackSighting> sightings = see();
  expect_at(sightings[0], face("circle").place);
  expect_at(sightings[1], face("cross").place);
}

// The twin comes into sight after the one that is tracked, as large or nearer.
TEST_F(Tracker, TakesNoTwinForWhatIsHidden) {
  for (const std::string name : {"circle", "square", "cross", "triangle"}) {
    for (const double depth_mm : {850, 760}) {
      SCOPED_TRACE(name + std::string(" and its twin at ") + std::to_string(depth_mm));
      tracker.clear();
      track(name);
      const SceneFace tracked{.mark = name, .place = {-90, -50, 850}};
      SceneFace twin{.mark = name, .place = {110, 50, depth_mm}};
      scene.faces = {tracked};
      see();
      scene.faces = {tracked, twin};
      for (int frame = 0; frame < 3; ++frame) expect_at(see()[0], tracked.place);
      const cv::Point2d centre = project(DrawnSight::model(), tracked.place, false);
      scene.blots = {{.box = {centre.x - 25, centre.y - 25, 50, 50}, .level = 150, .disparity_px = 46}};
      for (int frame = 0; frame < 2 * bridged_frames; ++frame) {
        scene.faces[1].place.y -= 4;
        EXPECT_FALSE(see()[0].seen);
      }
      scene.blots.clear();
      expect_at(see()[0], tracked.place);
    }
  }
}

// Nearer than two faces of one cube are, but both seen from the front.
TEST_F(Tracker, TakesNoTwinBesideIt) {
  for (const std::string name : {"circle", "square", "cross", "triangle"}) {
    SCOPED_TRACE(name);
    tracker.clear();
    track(name);
    const SceneFace tracked{.mark = name, .place = {-30, 0, 850}};
    scene.faces = {tracked, {.mark = name, .place = {45, 0, 850}}};
    scene.blots = {};
    const TrackSighting first = see()[0];
    ASSERT_TRUE(first.seen);
    const SceneFace& hidden = scene.faces[first.centre.x < 170 ? 0 : 1];
    const cv::Point2d centre = project(DrawnSight::model(), hidden.place, false);
    scene.blots = {{.box = {centre.x - 15, centre.y - 15, 30, 30}, .level = 150, .disparity_px = 46}};
    for (int frame = 0; frame < 2 * bridged_frames; ++frame) EXPECT_FALSE(see()[0].seen) << frame;
    scene.blots.clear();
    expect_at(see()[0], hidden.place);
  }
}

// It was in sight when tracking began, and is behind something when what is tracked is hidden too.
TEST_F(Tracker, TakesNoTwinThatWasHiddenMeanwhile) {
  track("cross");
  const SceneFace one{.mark = "cross", .place = {-90, -50, 850}};
  const SceneFace other{.mark = "cross", .place = {110, 50, 850}};
  scene.faces = {one, other};
  const TrackSighting first = see()[0];
  ASSERT_TRUE(first.seen);
  const bool is_one = first.centre.x < 160;
  const auto cover = [&](const SceneFace& face) {
    const cv::Point2d centre = project(DrawnSight::model(), face.place, false);
    scene.blots.push_back({.box = {centre.x - 25, centre.y - 25, 50, 50}, .level = 150, .disparity_px = 46});
  };
  scene.blots = {};
  cover(is_one ? other : one);
  for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(see()[0].seen);
  scene.blots = {};
  cover(is_one ? one : other);
  for (int frame = 0; frame < 2 * bridged_frames; ++frame) EXPECT_FALSE(see()[0].seen) << frame;
  scene.blots.clear();
  expect_at(see()[0], (is_one ? one : other).place);
}

// Its front goes down, and then its upper side shows where the front was. Both bear the mark.
TEST_F(Tracker, StaysWithTheFaceThatItFollowedWhereACubeFallsOver) {
  track("square");
  scene.faces = {{.mark = "square", .place = {0, 0, 850}}};
  for (int frame = 0; frame < 3; ++frame) see();
  SceneFace front{.mark = "square", .place = {0, 30, 850}, .pitch_deg = 40};
  scene.faces = {front};
  for (int frame = 0; frame < 3; ++frame) see();
  const SceneFace upper{.mark = "square", .place = {0, -6, 850}, .pitch_deg = -50};
  scene.faces = {front, upper};
  for (int frame = 0; frame < 3; ++frame) expect_at(see()[0], front.place);
  front.pitch_deg = 10;
  scene.faces = {front};
  for (int frame = 0; frame < 3; ++frame) expect_at(see()[0], front.place);
}

// One frame shows what falls beside it as if it were another one; it comes to lie there.
TEST_F(Tracker, FindsWhatCameToLieWhereSomethingLikeItWasSeenToFall) {
  track("triangle");
  SceneFace own{.mark = "triangle", .place = {0, 0, 850}};
  scene.faces = {own};
  for (int frame = 0; frame < 3; ++frame) expect_at(see()[0], own.place);
  scene.faces = {own, {.mark = "triangle", .place = {-22, 34, 850}, .pitch_deg = -50}};
  expect_at(see()[0], own.place);
  scene.faces = {{.mark = "triangle", .place = {-20, 48, 850}, .pitch_deg = -58}};
  see();
  own.place = {-18, 50, 850};
  scene.faces = {own};
  for (int frame = 0; frame < 2 * bridged_frames; ++frame) see();
  expect_at(see()[0], own.place);
}

TEST_F(Tracker, IsNotTakenInByAnotherCubeInTheSamePlace) {
  track("circle");
  see();
  face("circle").mark = "square";
  face("square").mark = "none";
  for (int frame = 0; frame < 3; ++frame) EXPECT_FALSE(see()[0].seen);
}

TEST_F(Tracker, TwoObjectsThatSwapPlacesSwapPlaces) {
  track("circle");
  track("triangle");
  see();
  std::swap(face("circle").place, face("triangle").place);
  const std::vector<TrackSighting> sightings = see();
  expect_at(sightings[0], face("circle").place);
  expect_at(sightings[1], face("triangle").place);
}

// Whatever slides over the mark, in either image, a position that is told is right.
TEST_F(Tracker, TellsTheRangeByTheSizeWhereTheRightImageEnds) {
  for (const std::string& name : cell_marks()) {
    SCOPED_TRACE(name);
    tracker.clear();
    track(name);
    std::vector<TrackSighting> sightings;
    // The left image ends at -270, the right one at -180 and the mark's half width.
    for (int x_mm = -120; x_mm >= -225; x_mm -= 5) {
      scene.faces = {{.mark = drawn_as(name), .place = {static_cast<double>(x_mm), 60, 850}}};
      sightings = see();
      if (sightings[0].seen) {
        EXPECT_NEAR(sightings[0].range_mm, cv::norm(scene.faces[0].place), 20) << "at " << x_mm;
      }
    }
    EXPECT_TRUE(sightings[0].seen);
  }
}

TEST_F(Tracker, TellsHowFarAFaceIsTurned) {
  for (const std::string& name : cell_marks()) {
    tracker.clear();
    track(name);
    for (const double x_mm : {-150.0, 0.0, 150.0}) {
      for (const double yaw_deg : {-30.0, -15.0, 0.0, 15.0, 30.0}) {
        SCOPED_TRACE(name + " at " + std::to_string(x_mm) + " turned " + std::to_string(yaw_deg));
        scene.faces = {{.mark = drawn_as(name), .place = {x_mm, 60, 850}, .yaw_deg = yaw_deg}};
        double sum = 0;
        const int frames = campaign(4, 10);
        for (int i = 0; i < frames; ++i) {
          const std::vector<TrackSighting> sightings = see();
          ASSERT_TRUE(sightings[0].yaw_deg.has_value());
          sum += *sightings[0].yaw_deg;
        }
        EXPECT_NEAR(sum / frames, yaw_deg, 5);
      }
    }
  }
}

TEST_F(Tracker, ASlidingOccluderNeverMakesAConfidentWrongPosition) {
  for (const std::string name : {"circle", "square", "cross", "triangle"}) {
    for (const int level : {25, 120, 225}) {
      SCOPED_TRACE(name + std::string(" level ") + std::to_string(level));
      MarkTracker one(learned_cell());
      ASSERT_TRUE(one.add(*learned_cell().find(name)));
      scene.faces = {{.mark = name, .place = {20, 10, 850}}};
      const cv::Point2d centre = project(DrawnSight::model(), scene.faces[0].place, false);
      for (double edge = -22; edge < 22; edge += 2.5) {
        // In the right image the same edge lies elsewhere on the mark, as a nearer thing's would.
        scene.blots = {{.box = {centre.x + edge - 60, centre.y - 30, 60, 60}, .level = level}};
        DrawnSight drawn(scene, random);
        const std::vector<TrackSighting> sightings = one.update(drawn.sight, now += between);
        if (!sightings[0].seen) continue;
        EXPECT_LT(cv::norm(sightings[0].centre - centre), 1.5) << "edge at " << edge;
        EXPECT_NEAR(sightings[0].range_mm, cv::norm(scene.faces[0].place), 15) << "edge at " << edge;
      }
    }
  }
}

TEST(Replies, AreTheThesisTexts) {
  EXPECT_EQ(learn_reply("circle", true), "(LEARN \"circle\" OK)");
  EXPECT_EQ(learn_reply("circle", false), "(LEARN \"circle\" FAIL)");
  EXPECT_EQ(find_reply("circle", cv::Point2d(112.254, 87.5)), "(FIND \"circle\" OK (112.25, 87.50))");
  EXPECT_EQ(find_reply("circle", std::nullopt), "(FIND \"circle\" FAIL)");
  const std::vector<TrackSighting> sightings = {
      {.name = "end-effector",
       .seen = true,
       .centre = {160.123, 88.4},
       .range_mm = 812.3,
       .yaw_deg = {},
       .contour = {}},
      {.name = "circle", .seen = false, .centre = {}, .range_mm = 0, .yaw_deg = {}, .contour = {}}};
  EXPECT_EQ(track_reply(sightings), "(TRACK 2 (\"end-effector\" OK (160.12, 88.40, 812.30)) (\"circle\" FAIL))");
  EXPECT_EQ(get_reply(LearnedObjects()), "(GET 0 ())");
  EXPECT_EQ(get_reply(learned_cell()), "(GET 5 (\"circle\", \"square\", \"cross\", \"triangle\", \"end-effector\"))");
}

TEST_F(Tracker, BridgesALossOfAFewFramesAndSaysThatItDoes) {
  track("circle");
  for (int frame = 0; frame < 4; ++frame) {
    scene.faces = {{.mark = "circle", .place = {-60.0 + 8 * frame, 0, 850}}};
    expect_at(see()[0], scene.faces[0].place);
  }
  double confidence = 1;
  for (int frame = 4; frame < 4 + bridged_frames; ++frame) {
    scene.faces = {{.mark = "none", .place = {-60.0 + 8 * frame, 0, 850}}};
    const TrackSighting sighting = see()[0];
    EXPECT_FALSE(sighting.seen);
    ASSERT_TRUE(sighting.bridged);
    EXPECT_LT(cv::norm(sighting.centre - project(DrawnSight::model(), scene.faces[0].place, false)), 2);
    EXPECT_NEAR(sighting.range_mm, 850, 10);
    EXPECT_LT(sighting.confidence, confidence);
    confidence = sighting.confidence;
  }
  const TrackSighting gone = see()[0];
  EXPECT_FALSE(gone.seen || gone.bridged);
  EXPECT_EQ(gone.confidence, 0);
  scene.faces = {{.mark = "circle", .place = {20, 0, 850}}};
  expect_at(see()[0], scene.faces[0].place);
}

TEST_F(Tracker, APairGoesByNoGuessOfASize) {
  LearnedSample guessed = learned_cell().find("circle")->samples.front();
  guessed.size_mm *= 2;
  guessed.size_by = LearnedSample::SizeBy::guessed_face;
  LearnedObjects objects;
  objects.add("circle", guessed);
  MarkTracker one(objects);
  ASSERT_TRUE(one.add(*objects.find("circle")));
  DrawnSight drawn(scene, random);
  expect_at(one.update(drawn.sight, now)[0], face("circle").place);
}

TEST_F(Tracker, SaysHowSureItIsAndHowFarTheRangeMayBeOff) {
  for (const std::string& name : cell_marks()) track(name);
  for (const TrackSighting& sighting : see()) {
    EXPECT_GT(sighting.confidence, 0.9) << sighting.name;
    EXPECT_GT(sighting.range_spread_mm, 0.2) << sighting.name;
    EXPECT_LT(sighting.range_spread_mm, 3) << sighting.name;
  }
}

// Errors of the range, each divided by what was said of it, have a standard deviation of about one.
TEST_F(Tracker, TheSpreadOfTheRangeIsThatOfItsErrors) {
  for (const double noise : {1.0, 4.0, 10.0}) {
    double squares = 0;
    int within_three = 0;
    int count = 0;
    for (int n = 0; n < 40; ++n) {
      const std::string name = cell_marks()[static_cast<std::size_t>(n) % cell_marks().size()];
      const cv::Point3d place(random.uniform(-100, 140), random.uniform(-60, 60), random.uniform(650, 1100));
      scene.faces = {{.mark = drawn_as(name), .place = place}};
      scene.noise = noise;
      tracker.clear();
      track(name);
      const TrackSighting sighting = see()[0];
      if (!sighting.seen) continue;
      const double off = (sighting.range_mm - cv::norm(place)) / sighting.range_spread_mm;
      squares += off * off;
      within_three += std::abs(off) < 3 ? 1 : 0;
      ++count;
    }
    ASSERT_GT(count, 30) << noise;
    const double spread = std::sqrt(squares / count);
    EXPECT_GT(spread, 0.4) << "at a noise of " << noise;
    EXPECT_LT(spread, 1.6) << "at a noise of " << noise;
    EXPECT_GE(within_three, count - 2) << "at a noise of " << noise;
  }
}

TEST(Replies, SayWhatTheThesisTextHasNoRoomFor) {
  TrackSighting seen{.name = "a", .seen = true, .centre = {}, .yaw_deg = {}, .contour = {}};
  seen.captured = Time(12'340us);
  seen.confidence = 0.98765;
  seen.centre = {30, 40.555};
  seen.right_centre = {20, 40.5};
  seen.range_mm = 851.234;
  seen.range_spread_mm = 0.5678;
  seen.second = "b";
  seen.margin = 0.12345;
  seen.yaw_deg = -3.46;
  TrackSighting bridged{.name = "b", .bridged = true, .centre = {10.123, 20}, .yaw_deg = {}, .contour = {}};
  bridged.confidence = 0.5;
  bridged.range_mm = 800;
  const TrackSighting lost{.name = "c", .centre = {}, .yaw_deg = {}, .contour = {}};
  const std::vector<TrackSighting> all{seen, bridged, lost};
  EXPECT_EQ(
      write(look_fact(7, all)),
      R"x((look 7 "(TRACK 3 (\"a\" OK (30.00, 40.55, 851.23)) (\"b\" FAIL) (\"c\" FAIL))" )x"
      R"x((("a" seen 0.988 (left 30.0 40.56) (right 20.0 40.5) (range 851.23 0.57) (face -3.5) (captured 12340) (second "b" 0.123)) )x"
      R"x(("b" bridged 0.5 (left 10.12 20.0) (range 800.0 0.0)) ("c" lost))))x");
}

}  // namespace
}  // namespace pizarra::vision
