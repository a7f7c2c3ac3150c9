#include "tests/network/packet_line.hpp"

#include <gtest/gtest.h>

namespace pizarra::network {
namespace {

using std::chrono::milliseconds;

LineConditions conditions(const std::vector<std::string>& words) { return LineConditions::from(words).value(); }

TEST(PacketLine, ReadsWhatIsTheMatter) {
  const LineConditions read = conditions({"delay", "80", "loss", "1.5", "rate", "1000", "cut"});
  EXPECT_EQ(read.delay, milliseconds(80));
  EXPECT_DOUBLE_EQ(read.loss, 0.015);
  EXPECT_EQ(read.kbit_per_s, 1000u);
  EXPECT_TRUE(read.cut);
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"delay"}, {"delay", "x"}, {"loss", "101"}, {"speed", "1"}, {"delay", "-1"}}) {
    EXPECT_FALSE(LineConditions::from(wrong));
  }
}

TEST(PacketLine, GivesInOrderWhatItDelays) {
  PacketLine line(1);
  const Moment begun{};
  line.set(conditions({"delay", "80"}));
  line.take({1}, begun);
  line.set({});
  line.take({2}, begun + milliseconds(1));
  EXPECT_FALSE(line.give(begun + milliseconds(79)));
  EXPECT_EQ(line.next(), begun + milliseconds(80));
  EXPECT_EQ(line.give(begun + milliseconds(80)), Packet{1});
  EXPECT_EQ(line.give(begun + milliseconds(80)), Packet{2});
  EXPECT_FALSE(line.next());
}

TEST(PacketLine, LosesItsShareAndTheSameForTheSameSeed) {
  const auto lost = [](std::uint64_t seed) {
    PacketLine line(seed);
    line.set(conditions({"loss", "1"}));
    for (int i = 0; i < 100'000; ++i) {
      line.take({1}, Moment{});
      line.give(Moment{});
    }
    return line.lost();
  };
  EXPECT_NEAR(static_cast<double>(lost(7)), 1000, 150);
  EXPECT_EQ(lost(7), lost(7));
  EXPECT_NE(lost(7), lost(8));
}

TEST(PacketLine, SendsNoFasterThanItsRateAndDropsWhatCannotWait) {
  PacketLine line(1);
  const Moment begun{};
  line.set(conditions({"rate", "1000"}));
  // 125,000 bytes a second.
  for (int i = 0; i < 1000; ++i) line.take(Packet(1250), begun);
  EXPECT_EQ(line.lost(), 1000 - PacketLine::most_bytes / 1250);
  int given = 0;
  while (line.give(begun + milliseconds(500))) ++given;
  EXPECT_EQ(given, 50);
}

TEST(PacketLine, ThatIsCutGivesNothingThatWasInIt) {
  PacketLine line(1);
  line.set(conditions({"delay", "10"}));
  line.take({1}, Moment{});
  line.set(conditions({"cut"}));
  line.take({2}, Moment{});
  EXPECT_FALSE(line.give(Moment{} + milliseconds(10)));
  EXPECT_EQ(line.lost(), 2u);
}

}  // namespace
}  // namespace pizarra::network
