#include "agents/coordinator/perceive/beliefs.hpp"

#include <gtest/gtest.h>

#include "agents/coordinator/geometry/sightings.hpp"
#include "lisp/reader.hpp"

namespace pizarra::coordinator {
namespace {

const Datum a = list("clear"_sym, "a"_sym);
const Datum b = list("clear"_sym, "b"_sym);

TEST(Beliefs, ComeAfterAFewLooksInARow) {
  Beliefs beliefs(3);
  EXPECT_FALSE(beliefs.perceive({a}).any());
  EXPECT_FALSE(beliefs.perceive({a}).any());
  EXPECT_EQ(beliefs.perceive({a}).come, std::vector<Datum>{a});
  EXPECT_EQ(beliefs.facts(), Facts{a});
  EXPECT_TRUE(beliefs.settled());
}

TEST(Beliefs, OutlastAHandThatPasses) {
  Beliefs beliefs(2);
  beliefs.perceive({a, b});
  beliefs.perceive({a, b});
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(beliefs.perceive({a}).any());
    EXPECT_FALSE(beliefs.settled());
    EXPECT_FALSE(beliefs.perceive({a, b}).any());
  }
  beliefs.perceive({a});
  EXPECT_EQ(beliefs.perceive({a}).gone, std::vector<Datum>{b});
}

TEST(Beliefs, ComeAtOnceWithoutPatience) {
  Beliefs beliefs(1);
  EXPECT_EQ(beliefs.perceive({b}).come, std::vector<Datum>{b});
}

Datum track(double x_px) { return list("track"_sym, list("circle", x_px, 150.0, 900.0), list("cross", "fail"_sym)); }

TEST(Sightings, KnowWhatIsSeenNowAndForHowLongItLiesStill) {
  const CameraView view({}, {});
  Sightings sightings;
  for (int i = 0; i < 8; ++i) sightings.look(100 + i, track(100), view);
  EXPECT_TRUE(sightings.recent("circle", 1));
  EXPECT_FALSE(sightings.recent("cross", 100));
  EXPECT_EQ(sightings.still_looks("circle"), 7u);
  EXPECT_EQ(sightings.frame(), 107);
  sightings.look(108, track(110), view);
  EXPECT_EQ(sightings.still_looks("circle"), 0u);
  sightings.look(109, list("track"_sym, list("circle", "fail"_sym)), view);
  EXPECT_FALSE(sightings.recent("circle", 1));
  EXPECT_TRUE(sightings.recent("circle", 2));
}

TEST(Sightings, CountLooksThoughFrameNumbersBeginAgain) {
  const CameraView view({}, {});
  Sightings sightings;
  sightings.look(500, track(100), view);
  sightings.look(1, track(100), view);
  EXPECT_EQ(sightings.looks(), 2u);
  EXPECT_TRUE(sightings.recent("circle", 1));
}

}  // namespace
}  // namespace pizarra::coordinator
