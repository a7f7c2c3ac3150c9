#include "drivers/arm/simple_message/simple_message.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"

namespace pizarra::arm {
namespace {

std::string point_message(line::ByteOrder order) {
  SimpleMessage message{.type = simple::trajectory_point, .kind = simple::request};
  SimplePoint point{.sequence = 3, .velocity = 0.5f, .duration_s = 2};
  point.joints_rad[1] = -0.25f;
  message.data = write_point(point, order);
  return write_simple(message, order);
}

TEST(SimpleMessages, APointStandsAsTheSpecificationHasIt) {
  const std::string frame = tcp_frame(point_message(line::ByteOrder::little), line::ByteOrder::little);
  ASSERT_EQ(frame.size(), 4u + 12 + 4 + 40 + 8);
  EXPECT_EQ(frame.substr(0, 20), std::string("\x40\0\0\0\x0b\0\0\0\2\0\0\0\0\0\0\0\3\0\0\0", 20));
  EXPECT_EQ(frame.substr(24, 4), std::string("\0\0\x80\xbe", 4));  // -0.25
  EXPECT_EQ(tcp_frame(point_message(line::ByteOrder::big), line::ByteOrder::big).substr(0, 8),
            std::string("\0\0\0\x40\0\0\0\x0b", 8));
}

TEST(SimpleMessages, ASerialFrameBearsTheSumOfItsOctets) {
  const std::string frame = serial_frame(std::string("\1\0\0\0\2\0\0\0\xff\0\0\0", 12));
  EXPECT_EQ(frame.substr(0, 8), std::string("\xff\xff\xfe\x02\x0c\0\0\0", 8));
}

TEST(SimpleMessages, WhatIsWrittenIsReadBackInEitherOrder) {
  for (const line::ByteOrder order : {line::ByteOrder::little, line::ByteOrder::big}) {
    const Result<SimpleMessage> message = read_simple(point_message(order), order);
    ASSERT_TRUE(message);
    EXPECT_EQ(message->type, simple::trajectory_point);
    const Result<SimplePoint> point = read_point(message->data, order);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->sequence, 3);
    EXPECT_EQ(point->joints_rad[1], -0.25f);
    EXPECT_EQ(point->velocity, 0.5f);
  }
}

TEST(SimpleMessages, AnAngleThatIsNoNumberIsRefusedWithItsAxis) {
  SimplePosition position;
  position.joints_rad[3] = std::nanf("");
  const Result<SimplePosition> read =
      read_position(write_position(position, line::ByteOrder::little), line::ByteOrder::little);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().subject, to_datum(4));
}

// Whatever a serial line does to the octets, what is taken for a message is one that was sent.
TEST(SimpleMessages, OfAGarbledLineOnlyWholeMessagesAreTaken) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const std::string message = point_message(line::ByteOrder::little);
    std::string line;
    for (int i = 0; i < 200; ++i) {
      line += serial_frame(message);
      if (random.below(3) == 0) line.insert(random.below(line.size()), std::string(random.below(9), '\xff'));
      if (random.below(3) == 0) line.erase(line.size() - 1 - random.below(60), 1 + random.below(8));
    }
    int taken = 0;
    while (!line.empty()) {
      const Result<std::optional<line::Frame>> frame = frame_of_serial(line);
      ASSERT_TRUE(frame);
      if (!*frame) break;
      EXPECT_EQ((*frame)->message, message) << "seed " << seed;
      ++taken;
      line.erase(0, (*frame)->octets);
    }
    EXPECT_GT(taken, 50) << "seed " << seed;
  }
}

TEST(SimpleMessages, WhateverComesIsReadOrRefused) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
      std::string damaged = tcp_frame(point_message(line::ByteOrder::little), line::ByteOrder::little);
      for (std::uint64_t edits = random.below(4); edits > 0; --edits) {
        damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
      }
      damaged.resize(random.below(damaged.size() + 1));
      const Result<std::optional<line::Frame>> frame = frame_of_tcp_little(damaged);
      if (!frame || !*frame) continue;
      const Result<SimpleMessage> message = read_simple((*frame)->message, line::ByteOrder::little);
      ASSERT_TRUE(message) << "seed " << seed << ", case " << i;
      const Result<SimplePoint> point = read_point(message->data, line::ByteOrder::little);
      if (!point) continue;
      for (const float joint : point->joints_rad) ASSERT_TRUE(std::isfinite(joint)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace pizarra::arm
