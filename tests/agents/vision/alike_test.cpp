// Several that are one as much as the other: shapes alike, or tags of one number. One is told, and that it may be
// another one.

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

class Alike : public Vision {
 protected:
  // What FIND says last of this object.
  double confidence(const std::string& name) {
    const Datum found = form(facts("(found vision \"" + name + "\" ? ? ? ? ? ?)"));
    EXPECT_EQ(found[5].text(), "") << "the second";
    return found[4].number();
  }
  std::size_t elsewhere(const std::string& name) {
    return form(facts("(found vision \"" + name + "\" ? ? ? ? ? ?)"))[7].size();
  }
  cv::Point2d find(const std::string& name) {
    const std::string answer = call("(find \"" + name + "\")");
    cv::Point2d out;
    const std::string format = "(FIND \"" + name + "\" OK (%lf, %lf))";
    EXPECT_EQ(std::sscanf(answer.c_str(), format.c_str(), &out.x, &out.y), 2) << answer;
    return out;
  }
};

class TrackedAlike : public Alike {
 protected:
  TrackedAlike() {
    EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
    camera.scene.faces.erase(camera.scene.faces.begin() + 1, camera.scene.faces.end());
  }
  // Another circle, to the right of the first.
  void add_twin() {
    camera.scene.faces.push_back(camera.scene.faces[0]);
    camera.scene.faces.back().place.x += 120;
  }
  void remove_twin() { camera.scene.faces.pop_back(); }
  void begin_tracking() {
    EXPECT_EQ(call("(track \"circle\")"), "()");
    run_for(1s);
  }
  Datum sighting() { return form(facts("(look vision ? ? ?)"))[4][0]; }
  double confidence_now() {
    const Datum now = sighting();
    EXPECT_EQ(now[1].text(), "seen") << write(now);
    return now[2].number();
  }
  cv::Point2d place_now() {
    const Datum left = sighting()[3];
    return {left[1].number(), left[2].number()};
  }
};

TEST_F(TrackedAlike, WhatWasTakenForItAmongOthersLikeItIsNotSureWhileTheyAreInView) {
  find("circle");
  add_twin();
  begin_tracking();
  EXPECT_LE(confidence_now(), 0.6);
  run_for(20s);
  EXPECT_LE(confidence_now(), 0.6);
  remove_twin();
  run_for(300ms);
  EXPECT_GT(confidence_now(), 0.9);
}

TEST_F(TrackedAlike, WhatComesLaterTakesNothingFromIt) {
  begin_tracking();
  EXPECT_GT(confidence_now(), 0.9);
  const cv::Point2d before = place_now();
  add_twin();
  run_for(1s);
  EXPECT_GT(confidence_now(), 0.9);
  EXPECT_LT(cv::norm(place_now() - before), 1);
}

TEST_F(TrackedAlike, TrackingBeginsWithTheOneThatWasFoundLast) {
  const cv::Point2d first = find("circle");
  for (const double side : {-1, 1}) {
    camera.scene.faces.push_back(camera.scene.faces[0]);
    camera.scene.faces.back().place.y += side * 120;
  }
  std::ranges::reverse(camera.scene.faces);
  begin_tracking();
  EXPECT_LT(cv::norm(place_now() - first), 1);
  EXPECT_LE(confidence_now(), 0.6);
}

TEST_F(Alike, OfTwoShapesOneIsToldThatMayBeTheOther) {
  learn_all();
  const cv::Point2d first = find("circle");
  EXPECT_GT(confidence("circle"), 0.9);
  camera.scene.faces[1] = camera.scene.faces[0];
  camera.scene.faces[1].place.x = 20;
  EXPECT_LT(cv::norm(find("circle") - first), 1);
  EXPECT_LE(confidence("circle"), 0.6);
  EXPECT_EQ(elsewhere("circle"), 1U);
}

TEST_F(Alike, OfTwoTagsOfOneNumberOneIsToldThatMayBeTheOther) {
  constexpr int side = 40;
  constexpr int margin = 10;
  cv::Mat1b tag;
  cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11)->drawMarker(17, side, tag);
  cv::copyMakeBorder(tag, tag, margin, margin, margin, margin, cv::BORDER_CONSTANT, 255);
  camera.scene.faces.clear();
  camera.pictures = {{tag, {80, 20}}};
  EXPECT_EQ(call("(learn 110 50 \"box\")"), R"x((LEARN "box" OK))x");
  const cv::Point2d first = find("box");
  EXPECT_GT(confidence("box"), 0.9);
  camera.pictures.push_back({tag, {200, 150}});
  EXPECT_LT(cv::norm(find("box") - first), 1);
  EXPECT_LE(confidence("box"), 0.5);
  EXPECT_EQ(elsewhere("box"), 1U);
  camera.pictures.erase(camera.pictures.begin());
  EXPECT_LT(cv::norm(find("box") - cv::Point2d(229.5, 179.5)), 1);
  EXPECT_GT(confidence("box"), 0.9);
}

}  // namespace
}  // namespace pizarra::vision
