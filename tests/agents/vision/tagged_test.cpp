// Objects that the eyes know by their tags from the beginning.

#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_detection.hpp"
#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

constexpr int wide_cell_px = 6;
constexpr double whole_tag_px = 8 * wide_cell_px;  // of 36h11, with its border
constexpr double apart_px = 60;

class Tagged : public Vision {
 protected:
  Tagged() { camera.scene.faces = {}; }
  double depth_mm() const { return camera.model().focal_px * camera.model().base_line_mm / apart_px; }
  TaggedObject object(const std::string& name, int number) const {
    return {name, {"apriltag-36h11", number}, whole_tag_px * depth_mm() / camera.model().focal_px};
  }
  void live_with(std::vector<TaggedObject> objects) {
    life.reset();
    life.emplace(executor, board, camera, &streams,
                 VisionOptions{.objects_directory = "", .tagged = std::move(objects)});
    run_for(1s);
  }
  void show(int number, cv::Point at) {
    cv::Mat1b print;
    cv::resize(print_of(*family_called("apriltag-36h11"), number), print, {}, wide_cell_px, wide_cell_px,
               cv::INTER_NEAREST);
    const int around = 2 * wide_cell_px;
    cv::copyMakeBorder(print, print, around, around, around, around, cv::BORDER_CONSTANT, 255);
    print = 30 + print * (200.0 / 255);
    camera.pictures.push_back({print, at - cv::Point(around, around), static_cast<int>(apart_px)});
  }
};

TEST_F(Tagged, AreFoundAndTrackedAlthoughNobodyShowedThem) {
  show(17, {80, 60});
  show(3, {180, 120});
  live_with({object("lid", 17), object("box", 3)});
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("lid", "box")))x");
  EXPECT_TRUE(call("(find \"lid\")").starts_with(R"x((FIND "lid" OK (103.)x")) << call("(find \"lid\")");
  EXPECT_EQ(call("(track \"box\")"), "()");
  run_for(1s);
  const std::string look = says();
  EXPECT_TRUE(look.find("(TRACK 1 (\"box\" OK (203.") != std::string::npos) << look;
  EXPECT_NE(facts("(learned-template vision \"lid\" 1 apriltag-36h11-17 ? ? ? ? ? measured-face ?)"), "");
}

TEST_F(Tagged, AreAsLargeAsTheyAreSaidToBe) {
  LearnedObjects none;
  const Result<LearnedSample> sample = learn_print({"lid", {"aruco-4x4-50", 7}, 36}, none);
  ASSERT_TRUE(sample) << describe(sample.error());
  // The spread of a square's points, along either side.
  EXPECT_NEAR(sample->face_mm(), 36 / std::sqrt(12.0), 0.2);
  EXPECT_NEAR(sample->slimness, 1, 0.02);
}

TEST_F(Tagged, StayAsTheyAreKnown) {
  live_with({object("lid", 17)});
  const std::string known = facts("(learned vision ? ? ? ? ? ? ? ?)");
  live_with({object("lid", 17)});
  EXPECT_EQ(facts("(learned vision ? ? ? ? ? ? ? ?)"), known);
  live_with({object("Lid", 3)});
  EXPECT_EQ(facts("(learned vision ? ? ? ? ? ? ? ?)"), known);
}

TEST_F(Tagged, ATagThatIsKnownUnderAnotherNameIsToldAndTheOthersAreKnown) {
  live_with({object("lid", 17)});
  live_with({object("box", 17), object("cover", 3)});
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("lid", "cover")))x");
  EXPECT_NE(facts(R"x((vision-failed vision ? "(LEARN \"box\" FAIL)" ambiguous ?))x"), "");
}

}  // namespace
}  // namespace pizarra::vision
