#include "drivers/arm/motoman/hses_packet.hpp"

#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"

namespace pizarra::arm {
namespace {

std::string octets(std::initializer_list<int> values) {
  std::string out;
  for (const int value : values) out += static_cast<char>(value);
  return out;
}

// As the manual's figures have them.
TEST(HsesPacket, ARequestStandsAsTheManualHasIt) {
  HsesRequest servo_on{.id = 5, .command = hses::power, .instance = hses::servo, .attribute = 1};
  servo_on.service = hses::set_one;
  servo_on.data = octets({1, 0, 0, 0});
  EXPECT_EQ(write_hses(servo_on), "YERC" + octets({0x20, 0, 4, 0, 3, 1, 0, 5, 0, 0, 0, 0}) + "99999999" +
                                      octets({0x83, 0, 2, 0, 1, 0x10, 0, 0, 1, 0, 0, 0}));
}

TEST(HsesPacket, AReplyStandsAsTheManualHasIt) {
  const HsesReply refused{.id = 9, .service = 0x90, .status = 0x1f, .added_status = 0x2010};
  EXPECT_EQ(write_hses(refused), "YERC" + octets({0x20, 0, 0, 0, 3, 1, 1, 9, 0, 0, 0, 0x80}) + "99999999" +
                                     octets({0x90, 0x1f, 1, 0, 0x10, 0x20, 0, 0}));
}

TEST(HsesPacket, WhatIsWrittenIsReadBack) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const HsesRequest request{.id = static_cast<std::uint8_t>(random.below(256)),
                              .command = static_cast<std::uint16_t>(random.below(65536)),
                              .instance = static_cast<std::uint16_t>(random.below(65536)),
                              .attribute = static_cast<std::uint8_t>(random.below(256)),
                              .service = static_cast<std::uint8_t>(random.below(256)),
                              .data = std::string(random.below(400), 'x')};
    const Result<HsesRequest> read = read_hses_request(write_hses(request));
    ASSERT_TRUE(read);
    EXPECT_EQ(write_hses(*read), write_hses(request));
    EXPECT_FALSE(read_hses_reply(write_hses(request))) << "a request is no reply";
  }
}

TEST(HsesPacket, CutOffOrLengthenedNoneIsTakenForWhole) {
  const std::string reply = write_hses(HsesReply{.id = 1, .service = 0x81, .data = "12345678"});
  for (std::size_t size = 0; size < reply.size(); ++size) {
    const Result<HsesReply> read = read_hses_reply(reply.substr(0, size));
    ASSERT_FALSE(read) << size;
    EXPECT_EQ(read.error().symbol, "bad-message");
  }
  EXPECT_FALSE(read_hses_reply(reply + "x"));
}

TEST(HsesPacket, WhateverComesIsReadOrRefused) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const std::string sound = write_hses(HsesReply{.id = 1, .service = 0x81, .data = "12345678"});
    for (int i = 0; i < 20'000; ++i) {
      std::string damaged = sound;
      for (std::uint64_t edits = random.below(4); edits > 0; --edits) {
        damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
      }
      damaged.resize(random.below(damaged.size() + 1));
      const Result<HsesReply> read = read_hses_reply(damaged);
      EXPECT_EQ(read ? read->data.size() + 32 : damaged.size(), damaged.size()) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace pizarra::arm
