// Several that are one as much as the other: shapes alike, or tags of one number. One is told, and that it may be
// another one.

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/agents/vision/vision_life.hpp"

namespace pizarra {
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
}  // namespace pizarra
