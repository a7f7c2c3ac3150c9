// Objects that the eyes know by their tags from the beginning.

#include "tests/agents/vision/printed_tags.hpp"

namespace pizarra::vision {
namespace {

class Tagged : public PrintedTags {
 protected:
  TaggedObject object(const std::string& name, int number) const {
    return {name, {"apriltag-36h11", number}, side_mm()};
  }
  void live_with(std::vector<TaggedObject> objects) {
    PrintedTags::live_with({.objects_directory = "", .tagged = std::move(objects)});
    run_for(1s);
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
