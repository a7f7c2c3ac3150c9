// A mark goes behind something, a hand comes over it, or both move, slowly and quickly, at 10 to 120 frames a second; or
// a part of it is hidden from the first. What is told for sure is where the mark is.

#include <gtest/gtest.h>

#include "tests/agents/vision/meeting.hpp"

namespace pizarra {
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
  const int meetings = deceives ? 8 : 2;
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

std::string instance_name(const testing::TestParamInfo<Meetings::ParamType>& one) {
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
                         instance_name);

}  // namespace
}  // namespace pizarra
