// The messages of public clients of the High Speed Ethernet Server (fs100, moto-hses), and those that the manual has
// besides.

#include <cmath>
#include <gtest/gtest.h>

#include "drivers/line/octets.hpp"
#include "tests/drivers/arm/motoman/hses_cell.hpp"

namespace pizarra::arm {
namespace {

class HsesClients : public testing::Test, protected HsesCell {
 protected:
  HsesReply say(std::uint16_t command, std::uint16_t instance, std::uint8_t attribute, std::uint8_t service,
                std::string data = "") {
    HsesRequest request{.id = 1, .command = command, .instance = instance, .attribute = attribute};
    request.service = service;
    request.data = std::move(data);
    const std::string reply = run(executor, emulator.answer(write_hses(request)));
    return read_hses_reply(reply).value_or(HsesReply{.status = 0xff});
  }
  std::uint16_t code(std::uint16_t command, std::uint16_t instance, std::uint8_t attribute, std::uint8_t service,
                     std::string data = "") {
    return say(command, instance, attribute, service, std::move(data)).added_status;
  }
  static std::string words(std::initializer_list<std::int64_t> values) {
    line::OctetWriter octets(line::ByteOrder::little);
    for (const std::int64_t value : values) octets.u32(static_cast<std::uint32_t>(value));
    return octets.octets();
  }
  static std::uint32_t word(const HsesReply& reply, std::size_t at = 0) {
    return line::OctetReader(std::string_view(reply.data).substr(4 * at), line::ByteOrder::little).u32();
  }
  void servo_on() {
    ASSERT_EQ(code(0x83, 2, 1, 0x10, words({1})), 0);
    executor.run_for(1s);
  }
  Joints here() { return run(executor, cabinet.read()).joints; }
  ToolPose tool() { return forward(up6(), here()); }
  // By this many pulses of the first axis from where it stands.
  std::string pulse_move(std::int32_t more, std::int64_t speed_class = 0, std::int64_t speed = 1000) {
    const HsesReply at = say(0x75, 1, 0, 0x01);
    std::string data = words({1, 0, speed_class, speed});
    for (std::size_t axis = 0; axis < 7; ++axis) {
      const std::uint32_t pulses = word(at, 5 + axis);
      data += words({axis == 0 ? static_cast<std::int64_t>(pulses) + more : static_cast<std::int64_t>(pulses)});
    }
    return data + words({0, 0}) + std::string(36, '\0');
  }
  static std::string cartesian_move(std::int64_t frame, std::initializer_list<std::int64_t> six,
                                    std::int64_t speed_class = 1, std::int64_t speed = 500) {
    return words({1, 0, speed_class, speed, frame}) + words(six) + words({0, 0, 0, 0, 0, 0}) + std::string(36, '\0');
  }
};

TEST_F(HsesClients, TheStatusIsToldWholeOrByItsElement) {
  const HsesReply off = say(0x72, 1, 2, 0x0e);
  ASSERT_EQ(off.data.size(), 4u);
  EXPECT_EQ(word(off) & 0x40, 0u) << "the servos are off";
  servo_on();
  EXPECT_EQ(word(say(0x72, 1, 2, 0x0e)), 0x40u);
  EXPECT_EQ(word(say(0x72, 1, 1, 0x0e)), 0xc4u) << "on and on, play, remote";
  const HsesReply whole = say(0x72, 1, 0, 0x01);
  ASSERT_EQ(whole.data.size(), 8u);
  EXPECT_EQ(word(whole, 1), 0x40u);
  EXPECT_EQ(code(0x72, 1, 3, 0x0e), 0xa002);
  EXPECT_EQ(code(0x72, 1, 1, 0x01), 0xa002);
  EXPECT_EQ(code(0x72, 2, 0, 0x01), 0xa001);
  EXPECT_EQ(code(0x72, 1, 0, 0x10), 0xa000);
}

TEST_F(HsesClients, NothingMovesButByTheServiceOfAnOrder) {
  servo_on();
  const std::string order = pulse_move(20'000);
  for (const int service : {0x01, 0x0e, 0x10, 0x33}) {
    EXPECT_EQ(code(0x8b, 1, 1, static_cast<std::uint8_t>(service), order), 0xa000) << service;
    EXPECT_EQ(code(0x8a, 2, 1, static_cast<std::uint8_t>(service), cartesian_move(16, {0, 0, 0, 0, 0, 0})), 0xa000);
  }
  EXPECT_EQ(code(0x8b, 1, 0, 0x02, order), 0xa002);
  executor.run_for(1s);
  EXPECT_EQ(cabinet.moves(), 0u);
  EXPECT_EQ(code(0x8b, 1, 1, 0x02, order), 0);
  EXPECT_EQ(cabinet.moves(), 1u);
}

TEST_F(HsesClients, TheLatestAlarmIsToldWholeAndByItsElements) {
  EXPECT_EQ(say(0x70, 1, 0, 0x01).data, std::string(60, '\0'));
  ASSERT_TRUE(cabinet.obey("alarm 4107"));
  const HsesReply whole = say(0x70, 1, 0, 0x01);
  ASSERT_EQ(whole.data.size(), 60u);
  EXPECT_EQ(word(whole), 4107u);
  EXPECT_TRUE(std::string_view(whole.data).substr(28).starts_with("ALARM 4107"));
  EXPECT_EQ(word(say(0x70, 1, 1, 0x0e)), 4107u);
  EXPECT_EQ(say(0x70, 1, 5, 0x0e).data.size(), 32u);
  EXPECT_EQ(word(say(0x70, 2, 1, 0x0e)), 0u);
  EXPECT_EQ(code(0x70, 5, 0, 0x01), 0xa001);
  EXPECT_EQ(code(0x70, 1, 6, 0x0e), 0xa002);
}

TEST_F(HsesClients, PastAlarmsAreKeptByHowBadTheyAreTheNewestFirst) {
  for (const char* alarm : {"alarm 4107", "alarm 300", "alarm 4321", "alarm 0"}) ASSERT_TRUE(cabinet.obey(alarm));
  EXPECT_EQ(word(say(0x71, 1001, 0, 0x01)), 4321u);
  EXPECT_EQ(word(say(0x71, 1002, 1, 0x0e)), 4107u);
  EXPECT_EQ(word(say(0x71, 1, 1, 0x0e)), 300u);
  EXPECT_EQ(word(say(0x71, 2, 1, 0x0e)), 0u);
  for (const int wrong : {0, 101, 1000, 5001}) {
    EXPECT_EQ(code(0x71, static_cast<std::uint16_t>(wrong), 0, 0x01), 0xa001) << wrong;
  }
}

TEST_F(HsesClients, VariablesOfEveryTypeHoldWhatTheyAreGiven) {
  const std::pair<int, std::size_t> kinds[] = {{0x78, 1}, {0x79, 2}, {0x7a, 1}, {0x7b, 2},
                                               {0x7c, 4}, {0x7d, 4}, {0x7e, 16}};
  for (const auto& [command, size] : kinds) {
    const auto number = static_cast<std::uint16_t>(command == 0x78 ? 2501 : 5);
    const auto kind = static_cast<std::uint16_t>(command);
    const std::string value = std::string(size - 1, 'a') + "b";
    EXPECT_EQ(say(kind, number, 1, 0x0e).data, std::string(size, '\0')) << command;
    EXPECT_EQ(code(kind, number, 1, 0x10, value), 0) << command;
    EXPECT_EQ(say(kind, number, 1, 0x0e).data, value) << command;
    EXPECT_EQ(code(kind, number, 1, 0x10, value + "x"), 0xb003) << command;
    EXPECT_EQ(code(kind, number, 2, 0x0e), 0xa002) << command;
    EXPECT_EQ(code(kind, 9999, 1, 0x0e), 0xa001) << command;
  }
  EXPECT_EQ(code(0x78, 1, 1, 0x10, "a"), 0xb002) << "an input that the cell's wires set";
}

TEST_F(HsesClients, PositionVariablesAreSetWholeAndReadByElement) {
  const std::string pose = words({17, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_EQ(code(0x7f, 127, 0, 0x02, pose), 0);
  EXPECT_EQ(say(0x7f, 127, 0, 0x01).data, pose);
  EXPECT_EQ(word(say(0x7f, 127, 8, 0x0e)), 3u);
  EXPECT_EQ(code(0x80, 0, 0, 0x02, words({0, 1, 2, 3, 4, 5, 6, 7, 8})), 0);
  EXPECT_EQ(word(say(0x80, 0, 9, 0x0e)), 8u);
  EXPECT_EQ(code(0x80, 0, 10, 0x0e), 0xa002);
}

TEST_F(HsesClients, SeveralVariablesAreReadAndSetAtOnce) {
  EXPECT_EQ(code(0x304, 10, 0, 0x34, words({3, 7, -8, 9})), 0);
  EXPECT_EQ(say(0x304, 10, 0, 0x33, words({3})).data, words({3, 7, -8, 9}));
  EXPECT_EQ(word(say(0x7c, 11, 1, 0x0e)), static_cast<std::uint32_t>(-8));
  EXPECT_EQ(code(0x302, 0, 0, 0x33, words({3})), 0xb003) << "octets go in pairs";
  EXPECT_EQ(code(0x304, 98, 0, 0x33, words({3})), 0xa001);
  EXPECT_EQ(code(0x304, 0, 0, 0x33, words({0xffffffff})), 0xb003);
  EXPECT_EQ(code(0x304, 0, 0, 0x34, words({2, 1})), 0xb003);
}

TEST_F(HsesClients, ItTellsItsAxesItsJobItsModelAndThatNothingStrainsIt) {
  EXPECT_TRUE(say(0x74, 1, 0, 0x01).data.starts_with(std::string_view("S\0\0\0L\0\0\0", 8)));
  EXPECT_EQ(say(0x74, 101, 4, 0x0e).data, std::string_view("Rx\0\0", 4));
  EXPECT_EQ(word(say(0x73, 1, 4, 0x0e)), 10'000u);
  EXPECT_EQ(say(0x73, 1, 0, 0x01).data.size(), 44u);
  EXPECT_TRUE(std::string_view(say(0x89, 11, 0, 0x01).data).substr(24).starts_with("motoman-up6"));
  EXPECT_EQ(say(0x76, 1, 0, 0x01).data, std::string(32, '\0'));
  EXPECT_EQ(say(0x77, 1, 0, 0x01).data, std::string(32, '\0'));
}

TEST_F(HsesClients, SwitchesAndThePendantTakeWhatTheyKnow) {
  EXPECT_EQ(code(0x83, 3, 1, 0x10, words({1})), 0);
  EXPECT_EQ(code(0x83, 4, 1, 0x10, words({1})), 0xa001);
  EXPECT_EQ(code(0x83, 2, 1, 0x10, words({3})), 0xb004);
  EXPECT_EQ(code(0x83, 2, 1, 0x0e), 0xa000);
  EXPECT_EQ(code(0x84, 2, 1, 0x10, words({1})), 0);
  EXPECT_EQ(word(say(0x72, 1, 1, 0x0e)) & 7, 1u);
  EXPECT_EQ(code(0x84, 2, 1, 0x10, words({4})), 0xb004);
  EXPECT_EQ(code(0x85, 1, 1, 0x10, "hello" + std::string(27, '\0')), 0);
  EXPECT_EQ(code(0x85, 1, 1, 0x10, "hello"), 0xb003);
  EXPECT_EQ(code(0x87, 1, 0, 0x02, std::string(36, 'x')), 0x4040);
  EXPECT_EQ(code(0x86, 1, 1, 0x10, words({1})), 0x4040);
  EXPECT_EQ(code(0x99, 1, 1, 0x10, words({1})), 0xa000);
}

TEST_F(HsesClients, AnIncrementGoesOnFromWhereTheToolIs) {
  servo_on();
  const ToolPose before = tool();
  ASSERT_EQ(code(0x8a, 3, 1, 0x02, cartesian_move(16, {0, 30'000, 0, 0, 0, 0})), 0);
  executor.run_for(5s);
  EXPECT_TRUE((tool().translation() - before.translation()).isApprox(Eigen::Vector3d(0, 30, 0), 1e-2));
  ASSERT_EQ(code(0x8a, 3, 1, 0x02, cartesian_move(19, {0, 0, 20'000, 0, 0, 0})), 0);
  executor.run_for(5s);
  const Eigen::Vector3d ahead = before.linear().col(2) * 20 + Eigen::Vector3d(0, 30, 0);
  EXPECT_TRUE((tool().translation() - before.translation()).isApprox(ahead, 1e-2));
  EXPECT_EQ(code(0x8a, 3, 1, 0x02, cartesian_move(18, {0, 0, 0, 0, 0, 0})), 0xb00b);
}

TEST_F(HsesClients, AJointMoveToAPlaceAndAStraightOneToPulsesEndThere) {
  servo_on();
  const HsesReply place = say(0x75, 101, 0, 0x01);
  const Joints begin = here();
  ASSERT_EQ(code(0x8b, 2, 1, 0x02, pulse_move(20'000, 1, 2000)), 0);
  executor.run_for(10s);
  EXPECT_NEAR(here()[0] - begin[0], 20'000 * 360.0 / up6().axes[0].pulses_per_turn, 0.01);
  std::string back = words({1, 0, 0, 5000, 16});
  back += place.data.substr(20, 24) + words({0, 0, 0, 0, 0, 0}) + std::string(36, '\0');
  ASSERT_EQ(code(0x8a, 1, 1, 0x02, back), 0);
  executor.run_for(10s);
  EXPECT_TRUE(are_same_place(here(), begin, 0.01));
  EXPECT_EQ(code(0x8b, 2, 1, 0x02, pulse_move(100, 0)), 0xb009) << "a straight line has no percent";
}

}  // namespace
}  // namespace pizarra::arm
