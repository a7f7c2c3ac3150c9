// A mark goes behind something, a hand comes over it, or both move, slowly and quickly, at 10 to 120 frames a second;
// or a part of it is hidden from the first. A mark that is told surely is where it is told.

#include "tests/agents/vision/meeting.hpp"

#include <gtest/gtest.h>

#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

class Meetings : public testing::TestWithParam<std::tuple<std::string, Meeting::Way>> {
 protected:
  static void expect_true(const ToldOfMeeting& told) {
    EXPECT_LT(told.most_off_px, 1.5);
    // One in three hundred may be a little off, as the noise falls.
    EXPECT_LE(told.wrong, told.sure / 300) << "of " << told.sure << " sure ones of " << told.positions;
  }
};

TEST_P(Meetings, AreToldForSureOnlyWhereTheMarkIs) {
  const auto& [name, way] = GetParam();
  // What is left of these looks like these.
  const bool deceives = name == "square" || name == "triangle";
  const int meetings = deceives ? campaign(4, 8) : 2;
  ToldOfMeeting by_pair;
  ToldOfMeeting by_one;
  for (int seed = 1; seed <= meetings; ++seed) {
    Meeting meeting(name, static_cast<std::uint64_t>(seed), way);
    meeting.run();
    by_pair += meeting.by_pair;
    by_one += meeting.by_one;
  }
  expect_true(by_pair);
  expect_true(by_one);
  if (way == Meeting::Way::hidden_from_the_first) return;
  // Before it is hidden each is told for sure.
  EXPECT_GT(by_pair.sure, 4 * meetings);
  EXPECT_GT(by_one.sure, 3 * meetings);
}

// The part left of a square looks like a square that is turned.
TEST(Finding, OfAHalfCoveredSquareIsNotSure) {
  camera::StereoModel alone = DrawnSight::model();
  alone.base_line_mm = 0;
  alone.learned_at_mm = 850;
  const LearnedObject& square = *learned_cell().find("square");
  int found_by_one = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random = Random(seed).split("half covered");
    Scene scene;
    scene.noise = random.uniform(1, 6);
    scene.blur_px = random.uniform(0.5, 1);
    scene.faces = {
        {.mark = "square", .place = {random.uniform(-60, 80), random.uniform(-60, 60), random.uniform(560, 1000)}}};
    const double size_px = 44 * DrawnSight::model().focal_px / scene.faces[0].place.z;
    const double disparity = DrawnSight::model().focal_px * DrawnSight::model().base_line_mm / scene.faces[0].place.z;
    const double from = CV_PI / 2 * static_cast<double>(random.below(4));
    const double hidden = random.uniform(0.12, 0.5) * size_px;
    const cv::Point2d centre = project(DrawnSight::model(), scene.faces[0].place, false);
    const cv::Point2d cover = centre + (50 + size_px / 2 - hidden) * cv::Point2d(std::cos(from), std::sin(from));
    const int levels[] = {95, 150, 190, 225};
    scene.blots = {{.box = {cover.x - 50, cover.y - 50, 100, 100},
                    .level = levels[random.below(4)],
                    .disparity_px = disparity + (random.below(2) == 0 ? 1 : random.uniform(0.02, 0.3) * disparity)}};
    DrawnSight drawn(scene, random);
    StereoSight by_one(drawn.sight.left(), cv::Mat::zeros(alone.height, alone.width, CV_8UC1), alone);
    for (StereoSight* sight : {&drawn.sight, &by_one}) {
      const std::optional<SeenPair> found = sight->find(learned_cell(), square);
      if (!found) continue;
      EXPECT_LT(confidence_in_look(*sight, square, *found), ToldOfMeeting::surely)
          << (sight == &by_one ? "one camera" : "a pair") << ", " << hidden << " of " << size_px << " px hidden";
      found_by_one += sight == &by_one ? 1 : 0;
    }
  }
  EXPECT_GT(found_by_one, 10);
}

std::string meeting_name(const testing::TestParamInfo<Meetings::ParamType>& one) {
  const char* const ways[] = {"GoesBehindSlowly", "GoesBehindQuickly", "UnderAHand", "BothMove", "HiddenFromTheFirst"};
  std::string name = std::get<0>(one.param);
  std::erase(name, '-');
  return name + ways[static_cast<int>(std::get<1>(one.param))];
}

INSTANTIATE_TEST_SUITE_P(Marks, Meetings,
                         testing::Combine(testing::ValuesIn(cell_marks()),
                                          testing::Values(Meeting::Way::mark_slowly, Meeting::Way::mark_quickly,
                                                          Meeting::Way::hand, Meeting::Way::both,
                                                          Meeting::Way::hidden_from_the_first)),
                         meeting_name);

}  // namespace
}  // namespace pizarra::vision
