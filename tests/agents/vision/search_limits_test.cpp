// Where and how often the eyes look for an object, as a client says.

#include "agents/vision/sight/search_limits.hpp"

#include <fmt/format.h>
#include <set>

#include "tests/agents/vision/printed_tags.hpp"

namespace pizarra::vision {
namespace {

class SearchLimit : public Vision {
 protected:
  SearchLimit() { learn_all(); }
  cv::Point2d centre(std::size_t face) const { return project(camera.model(), camera.scene.faces[face].place, false); }
  // An area of 70 x 70 px around a place of the left image.
  static std::string search_around(cv::Point2d place, const std::string& name) {
    return fmt::format("(search-in {:.1f} {:.1f} 70 70 \"{}\")", place.x - 35, place.y - 35, name);
  }
  // When the frames were captured by which looks told of an object during so long.
  std::set<std::int64_t> captured_for(const std::string& name, Duration duration) {
    std::set<std::int64_t> out;
    const Time end = executor.now() + duration;
    while (executor.now() < end) {
      run_for(20ms);
      const std::string written = facts("(look vision ? ? ?)");
      if (written.empty()) continue;
      const Datum look = form(written);
      for (const Datum& object : look[4].items()) {
        if (object[0].text() != name) continue;
        for (const Datum& part : object.items()) {
          if (part.is_form("captured")) out.insert(part[1].integer());
        }
      }
    }
    return out;
  }
};

TEST_F(SearchLimit, AnObjectIsFoundInItsAreaAndNowhereElse) {
  EXPECT_EQ(call(search_around(centre(0), "Circle")), "()");
  EXPECT_EQ(call("(find \"circle\")").substr(0, 19), R"x((FIND "circle" OK ()x");
  EXPECT_EQ(call(search_around(centre(1), "circle")), "()");
  EXPECT_EQ(call("(find \"circle\")"), R"x((FIND "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? not-seen ?)"), "");
  EXPECT_EQ(call("(find \"end-effector\")").substr(0, 25), R"x((FIND "end-effector" OK ()x");
  EXPECT_EQ(call("(search-everywhere \"circle\")"), "()");
  EXPECT_EQ(call("(find \"circle\")").substr(0, 19), R"x((FIND "circle" OK ()x");
}

TEST_F(SearchLimit, ATrackedObjectThatLeavesItsAreaIsNotSeenUntilItIsBack) {
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(call(search_around(centre(0), "circle")), "()");
  run_for(500ms);
  EXPECT_NE(says().find("(\"circle\" OK"), std::string::npos) << says();
  // As slowly as it is followed.
  cv::Point3d& place = camera.scene.faces[0].place;
  const cv::Point3d before = place;
  for (int i = 0; i < 8; ++i) {
    place.y += 10;
    run_for(100ms);
  }
  run_for(300ms);
  EXPECT_NE(says().find("(\"circle\" FAIL)"), std::string::npos) << says();
  EXPECT_NE(says().find("(\"end-effector\" OK"), std::string::npos) << says();
  place = before;
  run_for(500ms);
  EXPECT_NE(says().find("(\"circle\" OK"), std::string::npos) << says();
}

TEST_F(SearchLimit, AnObjectIsLookedAtNoMoreOftenThanItsRate) {
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(call("(look-at-most 2 \"circle\")"), "()");
  run_for(1s);
  const std::set<std::int64_t> seldom = captured_for("circle", 5s);
  EXPECT_GE(seldom.size(), 9U);
  EXPECT_LE(seldom.size(), 11U);
  for (auto next = std::next(seldom.begin()); next != seldom.end(); ++next) {
    EXPECT_GE(*next - *std::prev(next), 500'000 - 100'000) << "the camera gives a frame each 100 ms";
  }
  EXPECT_GE(captured_for("end-effector", 5s).size(), 45U);
  EXPECT_NE(says().find("(\"circle\" OK"), std::string::npos) << "it stands in each look: " << says();
  EXPECT_EQ(call("(look-always \"circle\")"), "()");
  EXPECT_GE(captured_for("circle", 5s).size(), 45U);
}

TEST_F(SearchLimit, NoLookIsToldOfAFrameInWhichNothingIsLookedAt) {
  for (const char* name : {"circle", "end-effector"}) {
    EXPECT_EQ(call(fmt::format("(look-at-most 1 \"{}\")", name)), "()");
  }
  EXPECT_EQ(call("(track \"circle\")"), "()");
  std::set<std::string> looks;
  for (int i = 0; i < 50; ++i) {
    run_for(100ms);
    looks.insert(facts("(look vision ? ? ?)"));
  }
  looks.erase("");
  EXPECT_GE(looks.size(), 4U);
  EXPECT_LE(looks.size(), 6U);
}

TEST_F(SearchLimit, WhatMovedBetweenTwoLooksAtItIsFoundInTheNextOne) {
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(call("(look-at-most 1 \"circle\")"), "()");
  run_for(1500ms);
  camera.scene.faces[0].place.y += 70;
  run_for(1200ms);
  const std::string look = says();
  double x = 0;
  double y = 0;
  const std::size_t at = look.find("(\"circle\" OK");
  ASSERT_NE(at, std::string::npos) << look;
  ASSERT_EQ(std::sscanf(look.c_str() + at, R"x(("circle" OK (%lf, %lf)x", &x, &y), 2) << look;
  EXPECT_NEAR(x, centre(0).x, 0.5);
  EXPECT_NEAR(y, centre(0).y, 0.5);
}

TEST_F(SearchLimit, ALostCameraLeavesNothingSeenThatIsLookedAtSeldom) {
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(call("(look-at-most 0.2 \"circle\")"), "()");
  run_for(500ms);
  EXPECT_NE(says().find("(\"circle\" OK"), std::string::npos) << says();
  camera.plugged = false;
  run_for(1s);
  EXPECT_EQ(says(), "nothing");
}

TEST_F(SearchLimit, WhatIsRefusedIsSaidAndChangesNothing) {
  EXPECT_EQ(call(search_around(centre(0), "circle")), "()");
  EXPECT_EQ(call("(look-at-most 5 \"circle\")"), "()");
  const auto told = [&] { return facts("(searched-in vision ? ? ? ? ?)") + facts("(looked-at-most vision ? ?)"); };
  const std::string before = told();
  for (const char* area : {"-1 0 50 50", "0 0 321 50", "300 200 50 50", "0 0 50 241", "1e300 0 50 50"}) {
    const std::string request = fmt::format("(search-in {} \"circle\")", area);
    EXPECT_TRUE(call(request).starts_with("outside ")) << call(request);
  }
  for (const char* area : {"0 0 15 50", "0 0 50 0", "0 0 50 -20"}) {
    const std::string request = fmt::format("(search-in {} \"circle\")", area);
    EXPECT_TRUE(call(request).starts_with("too-small ")) << call(request);
  }
  for (const char* rate : {"0", "-3", "0.05", "1001"}) {
    EXPECT_TRUE(call(fmt::format("(look-at-most {} \"circle\")", rate)).starts_with("bad-rate ")) << rate;
  }
  EXPECT_EQ(call("(search-in 0 0 50 50 \"star\")"), "not-learned \"star\"");
  EXPECT_EQ(call("(look-always \"star\")"), "not-learned \"star\"");
  EXPECT_EQ(call("(search-everywhere \"a b\")"), "bad-name \"a b\"");
  EXPECT_EQ(told(), before);
}

TEST_F(SearchLimit, AnotherClientThatTracksItIsNotDisturbed) {
  Client other(*this, "other");
  EXPECT_EQ(other.call("(track \"circle\")"), "()");
  EXPECT_EQ(call("(search-in 0 0 50 50 \"circle\")"), "busy other");
  EXPECT_EQ(call("(look-at-most 5 \"circle\")"), "busy other");
  EXPECT_EQ(other.call("(end-track)"), "()");
  EXPECT_EQ(call("(look-at-most 5 \"circle\")"), "()");
}

TEST_F(SearchLimit, GoesByTheNewNameAndEndsWithTheObject) {
  EXPECT_EQ(call("(search-in 10.5 20 80.9 60 \"circle\")"), "()");
  EXPECT_EQ(call("(look-at-most 2.5 \"circle\")"), "()");
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_EQ(facts("(searched-in vision ? ? ? ? ?)"), "(searched-in vision \"disc\" 11 20 80 60)");
  EXPECT_EQ(facts("(looked-at-most vision ? ?)"), "(looked-at-most vision \"disc\" 2.5)");
  EXPECT_EQ(call("(forget \"disc\")"), "()");
  EXPECT_EQ(facts("(searched-in vision ? ? ? ? ?)"), "");
  EXPECT_EQ(facts("(looked-at-most vision ? ?)"), "");
  EXPECT_EQ(call("(learn " + fmt::format("{} {}", centre(0).x, centre(0).y) + " \"disc\")"), R"x((LEARN "disc" OK))x");
  EXPECT_EQ(facts("(looked-at-most vision ? ?)"), "");
}

class SearchLimitOfATag : public PrintedTags {};

TEST_F(SearchLimitOfATag, HoldsForFindingAndTracking) {
  show(17, {80, 60});
  live_with({.objects_directory = "", .tagged = {{"lid", {"apriltag-36h11", 17}, side_mm()}}});
  run_for(1s);
  EXPECT_EQ(call("(search-in 150 40 150 150 \"lid\")"), "()");
  EXPECT_EQ(call("(find \"lid\")"), R"x((FIND "lid" FAIL))x");
  EXPECT_EQ(call("(track \"lid\")"), "()");
  run_for(500ms);
  EXPECT_EQ(says(), R"x((TRACK 1 ("lid" FAIL)))x");
  EXPECT_EQ(call("(search-in 50 30 150 150 \"lid\")"), "()");
  run_for(500ms);
  EXPECT_TRUE(says().starts_with(R"x((TRACK 1 ("lid" OK ()x")) << says();
}

TEST(LookPace, KeepsTheRateThoughTheCameraIsNotInStepWithIt) {
  for (const double rate : {1.0, 7.0, 10.0, 29.0}) {
    LookPace pace;
    Random random(3);
    int looks = 0;
    for (int frame = 0; frame < 3000; ++frame) {
      const Time captured = Time(3600s) + frame * 33'333us + Duration(static_cast<int>(random.uniform(-500, 500)));
      if (!pace.is_due(captured, rate)) continue;
      pace.looked(captured, rate);
      ++looks;
    }
    EXPECT_LE(looks, 100 * rate + 1);
    EXPECT_GE(looks, 97 * rate);
  }
}

TEST(LookPace, LooksAtOnceWhereTheClockOfTheImagesWasSetBack) {
  LookPace pace;
  pace.looked(Time(18000s), 1);
  EXPECT_FALSE(pace.is_due(Time(18000s) + 500ms, 1));
  EXPECT_TRUE(pace.is_due(Time(3600s), 1));
  EXPECT_TRUE(pace.is_due(Time(18000s) + 500ms, 10)) << "another rate was said";
}

}  // namespace
}  // namespace pizarra::vision
