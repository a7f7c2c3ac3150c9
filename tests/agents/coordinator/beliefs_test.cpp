#include "agents/coordinator/perceive/beliefs.hpp"

#include <gtest/gtest.h>

#include "agents/coordinator/geometry/sightings.hpp"

namespace pizarra::coordinator {
namespace {

const Datum a = list("clear"_sym, "a"_sym);
const Datum b = list("clear"_sym, "b"_sym);

TEST(Beliefs, ComeAfterAFewLooksInARow) {
  Beliefs beliefs(3);
  EXPECT_FALSE(beliefs.perceive({a}, {}).any());
  EXPECT_FALSE(beliefs.perceive({a}, {}).any());
  EXPECT_EQ(beliefs.perceive({a}, {}).come, std::vector<Datum>{a});
  EXPECT_EQ(beliefs.facts(), Facts{a});
  EXPECT_TRUE(beliefs.settled());
}

TEST(Beliefs, OutlastAHandThatPasses) {
  Beliefs beliefs(2);
  beliefs.perceive({a, b}, {});
  beliefs.perceive({a, b}, {});
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(beliefs.perceive({a}, {}).any());
    EXPECT_FALSE(beliefs.settled());
    EXPECT_FALSE(beliefs.perceive({a, b}, {}).any());
  }
  beliefs.perceive({a}, {});
  EXPECT_EQ(beliefs.perceive({a}, {}).gone, std::vector<Datum>{b});
}

TEST(Beliefs, ComeAtOnceWithoutPatience) {
  Beliefs beliefs(1);
  EXPECT_EQ(beliefs.perceive({b}, {}).come, std::vector<Datum>{b});
}

std::vector<forms::SeenObject> circle_at(double x_mm) { return {{"circle", {x_mm, 150.0, 30.0}, {}}}; }

TEST(Sightings, KnowWhatIsSeenNowAndForHowLongItLiesStill) {
  Sightings sightings;
  for (int i = 0; i < 8; ++i) sightings.look(100 + i, circle_at(100));
  EXPECT_TRUE(sightings.recent("circle", 1));
  EXPECT_FALSE(sightings.recent("cross", 100));
  EXPECT_EQ(sightings.still_looks("circle"), 7u);
  EXPECT_EQ(sightings.frame(), 107);
  sightings.look(108, circle_at(110));
  EXPECT_EQ(sightings.still_looks("circle"), 0u);
  sightings.look(109, {});
  EXPECT_FALSE(sightings.recent("circle", 1));
  EXPECT_TRUE(sightings.recent("circle", 2));
}

TEST(Beliefs, KnowTheLookThatChangedThem) {
  Beliefs beliefs(2);
  for (std::int64_t frame = 1; frame <= 3; ++frame) beliefs.perceive({a}, {frame, 100 + static_cast<FactId>(frame)});
  EXPECT_EQ(beliefs.changed_in(a).frame, 2);
  EXPECT_EQ(beliefs.changed_in(a).look, 102U);
  EXPECT_EQ(beliefs.changed_in(b).frame, 0);
}

TEST(Sightings, AverageTheFaceOfWhatLiesStillAsTheCameraIsMounted) {
  Sightings sightings;
  const std::vector<forms::SeenObject> turned{{"circle", {450, 0, 30}, 25.0}};
  for (int i = 0; i < 2; ++i) sightings.look(i, turned, 5);
  EXPECT_FALSE(sightings.face_deg("circle")) << "too few looks told";
  sightings.look(2, turned, 5);
  EXPECT_NEAR(sightings.face_deg("circle").value_or(0), 20, 1e-9);
  sightings.look(3, circle_at(600));
  EXPECT_FALSE(sightings.face_deg("circle")) << "it was moved";
}

TEST(Sightings, AnExcusedObjectStaysAsYoungAsItWasButNotForEver) {
  Sightings sightings;
  sightings.look(1, circle_at(450));
  for (int i = 0; i < Sightings::most_excused; ++i) {
    sightings.look(2 + i, {});
    sightings.excuse("circle");
    ASSERT_TRUE(sightings.recent("circle", 2)) << i;
  }
  for (int i = 0; i < 10; ++i) {
    sightings.look(1000 + i, {});
    sightings.excuse("circle");
  }
  EXPECT_FALSE(sightings.recent("circle", 10));
}

TEST(Sightings, AgeFromTheEndOfTheirExcuses) {
  Sightings sightings;
  sightings.look(1, circle_at(450));
  for (int i = 0; i < 20; ++i) {
    sightings.look(2 + i, {});
    if (i == 10) sightings.end_excuses();
    sightings.excuse("circle");
  }
  EXPECT_FALSE(sightings.recent("circle", 9));
  EXPECT_TRUE(sightings.recent("circle", 11));
}

TEST(Sightings, RememberWhatAnotherCoversAsThereAndNotAsSeen) {
  Sightings sightings;
  sightings.look(1, circle_at(450));
  for (int i = 0; i < Sightings::most_excused; ++i) {
    sightings.look(2 + i, {});
    sightings.cover("circle");
    ASSERT_TRUE(sightings.remembered("circle", 10)) << i;
  }
  EXPECT_TRUE(sightings.covered("circle"));
  EXPECT_FALSE(sightings.recent("circle", 10));
  for (int i = 0; i < 10; ++i) {
    sightings.look(1000 + i, {});
    sightings.cover("circle");
  }
  EXPECT_FALSE(sightings.remembered("circle", 10)) << "not for ever";
  sightings.look(2000, circle_at(450));
  EXPECT_FALSE(sightings.covered("circle"));
}

TEST(Sightings, RememberAgainWhatIsFoundToBeCoveredSoonAfterItWasForgotten) {
  Sightings sightings;
  sightings.look(1, circle_at(450));
  for (int i = 0; i < 20; ++i) sightings.look(2 + i, {});
  EXPECT_FALSE(sightings.remembered("circle", 10));
  sightings.cover("circle");
  EXPECT_TRUE(sightings.remembered("circle", 10));
  for (std::uint64_t i = 0; i < Sightings::most_patience; ++i) sightings.look(100, circle_at(450));
  for (std::uint64_t i = 0; i <= Sightings::most_patience; ++i) sightings.look(200, {});
  sightings.cover("circle");
  EXPECT_FALSE(sightings.remembered("circle", 10)) << "it was unseen for too long";
}

TEST(Sightings, RememberWhatIsHardToSeeForLonger) {
  Sightings sightings;
  sightings.look(1, circle_at(450));
  const auto unseen_for = [&](int looks) {
    for (int i = 0; i < looks; ++i) sightings.look(1, {});
  };
  unseen_for(12);
  EXPECT_FALSE(sightings.remembered("circle", 10));
  sightings.look(1, circle_at(450));
  unseen_for(20);
  EXPECT_TRUE(sightings.remembered("circle", 10)) << "it was unseen for long before, and had not gone";
  unseen_for(20);
  EXPECT_FALSE(sightings.remembered("circle", 10));
  sightings.look(1, circle_at(480));
  unseen_for(12);
  EXPECT_FALSE(sightings.remembered("circle", 10)) << "nothing is known of how it is seen there";
}

TEST(Sightings, CountLooksThoughFrameNumbersBeginAgain) {
  Sightings sightings;
  sightings.look(500, circle_at(100));
  sightings.look(1, circle_at(100));
  EXPECT_EQ(sightings.looks(), 2u);
  EXPECT_TRUE(sightings.recent("circle", 1));
}

}  // namespace
}  // namespace pizarra::coordinator
