#include "drivers/ptu/ptu_reply.hpp"

#include <gtest/gtest.h>

namespace pizarra::ptu {
namespace {

using enum PtuLine::Result;

TEST(PtuReply, AnAnswerIsTakenApartIntoEchoResultAndText) {
  const PtuLine line = read_ptu_line("PP * Current Pan position is 1000");
  EXPECT_EQ(line.echo, "PP");
  EXPECT_EQ(line.result, ok);
  EXPECT_EQ(line.text, "Current Pan position is 1000");
}

TEST(PtuReply, LimitHitsStandBeforeBetweenAndBesideAnswers) {
  const PtuLine reset = read_ptu_line("R !T!T!P!P*");
  EXPECT_EQ(reset.echo, "R");
  EXPECT_TRUE(reset.pan_hit && reset.tilt_hit);
  EXPECT_EQ(reset.result, ok);
  const PtuLine before = read_ptu_line("!PPP * 7");
  EXPECT_EQ(before.echo, "PP");
  EXPECT_TRUE(before.pan_hit);
  EXPECT_FALSE(before.tilt_hit);
  EXPECT_EQ(before.text, "7");
  EXPECT_EQ(read_ptu_line("!T").result, none);
}

TEST(PtuReply, ARefusalIsNotALimitHit) {
  const PtuLine line = read_ptu_line("! Pan speed cannot exceed 5833 positions/sec");
  EXPECT_EQ(line.result, error);
  EXPECT_FALSE(line.pan_hit || line.tilt_hit);
  EXPECT_EQ(line.text, "Pan speed cannot exceed 5833 positions/sec");
}

TEST(PtuReply, TheFirstNumberOfATextIsFoundWithItsSign) {
  EXPECT_EQ(first_number("185.1428 seconds arc per position"), 185.1428);
  EXPECT_EQ(first_number("Minimum Pan position is -3090"), -3090);
  EXPECT_EQ(first_number("0"), 0);
  EXPECT_EQ(first_number("ASCII verbose mode"), std::nullopt);
}

}  // namespace
}  // namespace pizarra::ptu
