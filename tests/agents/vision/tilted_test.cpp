// Whole marks that a pair of cameras follows while they turn about any axis, come nearer or go away, and then rest.
// Nothing covers them, so none is lost.

#include <algorithm>
#include <gtest/gtest.h>
#include <ostream>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

struct Motion {
  const char* name;
  double yaw_deg;
  double pitch_deg;
  double roll_deg;
  double away_mm;

  friend void PrintTo(const Motion& motion, std::ostream* out) { *out << motion.name; }
};

constexpr Motion motions[] = {{"TiltsBack", 0, 18, 0, 0},    {"TiltsForward", 0, -18, 0, 0},
                              {"Yaws", 22, 0, 0, 0},         {"TiltsAndYaws", 15, 12, 0, 0},
                              {"Rolls", 0, 0, 30, 0},        {"GoesAway", 0, 0, 0, 200},
                              {"ComesNearer", 0, 0, 0, -200}};

class WholeMarks : public testing::TestWithParam<std::tuple<std::string, Motion>> {};

TEST_P(WholeMarks, AreNotLostHoweverTheyTurnComeOrGo) {
  const auto& [name, motion] = GetParam();
  constexpr int begun = 2;
  constexpr int moving = 14;
  constexpr int frames = 40;
  int seen = 0;
  int seen_at_the_end = 0;
  const int runs = campaign(2, 6);
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(runs); ++seed) {
    Random random = Random(seed).split(name);
    const double rate = random.below(2) == 0 ? 10 : 30;
    Scene scene;
    scene.noise = random.uniform(1, 5);
    scene.blur_px = random.uniform(0.4, 1);
    scene.faces = {{.mark = drawn_as(name),
                    .place = {random.uniform(-60, 60), random.uniform(-40, 40), random.uniform(750, 850)},
                    .roll_deg = random.uniform(-10, 10)}};
    const SceneFace first = scene.faces.front();
    MarkTracker tracker{learned_cell()};
    tracker.add(*learned_cell().find(name)).value();
    Time now = {};
    for (int frame = 0; frame < frames; ++frame) {
      const double done = std::clamp(static_cast<double>(frame - begun) / moving, 0.0, 1.0);
      SceneFace& face = scene.faces.front();
      face.yaw_deg = done * motion.yaw_deg;
      face.pitch_deg = done * motion.pitch_deg;
      face.roll_deg = first.roll_deg + done * motion.roll_deg;
      face.place.z = first.place.z + done * motion.away_mm;
      DrawnSight drawn(scene, random);
      now += std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / rate));
      const bool is_seen = tracker.update(drawn.sight, now).front().seen;
      seen += is_seen ? 1 : 0;
      if (frame + 1 == frames) seen_at_the_end += is_seen ? 1 : 0;
    }
  }
  EXPECT_GE(seen, 0.97 * runs * frames);
  EXPECT_EQ(seen_at_the_end, runs);
}

std::string instance_name(const testing::TestParamInfo<WholeMarks::ParamType>& one) {
  std::string name = std::get<0>(one.param);
  std::erase(name, '-');
  return name + std::get<1>(one.param).name;
}

INSTANTIATE_TEST_SUITE_P(Marks, WholeMarks,
                         testing::Combine(testing::ValuesIn(cell_marks()), testing::ValuesIn(motions)), instance_name);

}  // namespace
}  // namespace pizarra::vision
