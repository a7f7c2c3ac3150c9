// A hand, light or dark, slides over a mark and away again: slowly and fast, from anywhere, before one camera and
// before a pair. A mark that is told as seen is where it is told.

#include "tests/agents/vision/covered_mark.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

class Covering : public testing::TestWithParam<std::tuple<std::string, int>> {
 protected:
  void slide(const Hand& hand) {
    for (double edge = CoveredMark::reach_px; edge > -CoveredMark::reach_px; edge -= hand.speed_px) {
      SCOPED_TRACE(testing::Message() << "its edge " << edge << " px from the centre");
      mark.put_hand(hand, edge);
      mark.look();
    }
    mark.put_hand(hand, -CoveredMark::reach_px);
    mark.look();
    EXPECT_FALSE(mark.seen_by_pair || mark.seen_by_one);
    for (double edge = -CoveredMark::reach_px; edge < CoveredMark::reach_px; edge += hand.speed_px) {
      SCOPED_TRACE(testing::Message() << "leaving, its edge " << edge << " px from the centre");
      mark.put_hand(hand, edge);
      mark.look();
    }
    mark.scene.blots.clear();
    look_on(2);
  }
  void look_on(int frames) {
    for (int n = 0; n < frames; ++n) mark.look();
    EXPECT_TRUE(mark.seen_by_pair && mark.seen_by_one);
  }

  CoveredMark mark{std::get<0>(GetParam()), static_cast<std::uint64_t>(std::get<1>(GetParam()))};
};

TEST_P(Covering, NeverMakesAConfidentWrongPosition) {
  look_on(4);
  Random& random = mark.random;
  for (int n = 0; n < 4; ++n) {
    const int levels[] = {25, 60, 95, 150, 190, 225};
    Hand hand{random.uniform(0, 360), random.below(2) == 0 ? random.uniform(1, 2) : random.uniform(5, 15),
              levels[random.below(6)], 0};
    hand.disparity_px = mark.disparity() + (random.below(2) == 0 ? 1 : 12);
    SCOPED_TRACE(testing::Message() << "from " << hand.from_deg << " degrees at " << hand.speed_px
                                    << " px a frame, level " << hand.level << ", disparity "
                                    << hand.disparity_px - mark.disparity() << " more, yaw "
                                    << mark.scene.faces[0].yaw_deg);
    slide(hand);
  }
}

class CoveringATriangle : public Covering {};

// The part left in view has the triangle's form, and is smaller.
TEST_P(CoveringATriangle, AlongASideLeavesNoTriangle) {
  mark.scene.faces[0].yaw_deg = 0;
  look_on(4);
  for (const double side_deg : {90.0, 210.7, 329.3}) {
    SCOPED_TRACE(testing::Message() << "from " << side_deg << " degrees");
    slide({side_deg + mark.scene.faces[0].roll_deg, mark.random.uniform(1.5, 2.5), 190, mark.disparity() + 12});
  }
}

std::string covering_name(const testing::TestParamInfo<Covering::ParamType>& one) {
  std::string name = std::get<0>(one.param);
  std::erase(name, '-');
  return name + std::to_string(std::get<1>(one.param));
}

INSTANTIATE_TEST_SUITE_P(Seeds, Covering,
                         testing::Combine(testing::Values("circle", "square", "cross", "triangle", "end-effector"),
                                          testing::Range(1, campaign(2, 3))),
                         covering_name);
INSTANTIATE_TEST_SUITE_P(Seeds, CoveringATriangle,
                         testing::Combine(testing::Values("triangle", "end-effector"),
                                          testing::Range(1, campaign(2, 3))),
                         covering_name);

}  // namespace
}  // namespace pizarra::vision
