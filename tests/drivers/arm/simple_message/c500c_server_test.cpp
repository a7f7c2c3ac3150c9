// The answers of the C500C's published control server (crs-c500c-utils), message by message, to a client on its line.

#include <gtest/gtest.h>

#include "drivers/line/octets.hpp"
#include "tests/drivers/arm/driven_cells.hpp"

namespace pizarra::arm {
namespace {

class C500cServer : public testing::Test, protected SimpleCell {
 protected:
  C500cServer() : SimpleCell({.serial = true, .sign = -1, .fixed_speed = 0.2}) {}
  // Little-endian words of the answer.
  std::vector<std::int32_t> say(std::int32_t type, const std::string& data) {
    line::OctetWriter message(line::ByteOrder::little);
    message.i32(type).i32(2).i32(0).text(data);
    const std::string frame = ask(emulator.answer(message.octets()));
    const Result<std::optional<line::Frame>> read = frame_of_serial(frame);
    std::vector<std::int32_t> words;
    if (!read || !*read) return words;
    line::OctetReader octets((*read)->message, line::ByteOrder::little);
    while (octets.left() >= 4) words.push_back(octets.i32());
    return words;
  }
  std::vector<std::int32_t> point(std::int32_t sequence, float turn_rad = 0, float velocity = 1) {
    line::OctetWriter data(line::ByteOrder::little);
    data.i32(sequence);
    for (std::size_t joint = 0; joint < 10; ++joint) data.f32(joint == 0 ? turn_rad : at_rest(joint));
    return say(11, data.f32(velocity).f32(0).octets());
  }
  float at_rest(std::size_t joint) {
    const Joints joints = ask(cabinet.read()).joints;
    if (joint >= joints.size() || model().axes[joint].role == Role::track) return 0;
    return static_cast<float>(joint_of_axis(model().axes[joint].role, joints[joint], -1));
  }
};

TEST_F(C500cServer, TellsItsVersion) { EXPECT_EQ(say(2, ""), (std::vector<std::int32_t>{2, 3, 1, 1, 0, 0})); }

TEST_F(C500cServer, TakesTheBeginningOfAStreamAndRefusesADownload) {
  EXPECT_EQ(point(-2).at(2), 1);
  EXPECT_EQ(point(-1).at(2), 2);
  EXPECT_EQ(cabinet.moves(), 0u);
}

TEST_F(C500cServer, NeitherStopsTheArm) {
  ASSERT_EQ(point(0, 1).at(2), 1);
  executor.run_for(300ms);
  point(-2);
  point(-1);
  executor.run_for(200ms);
  EXPECT_TRUE(ask(cabinet.read()).moving);
  EXPECT_EQ(point(-5).at(2), 2) << "one that it does not know does";
  executor.run_for(500ms);
  EXPECT_FALSE(ask(cabinet.read()).moving);
}

TEST_F(C500cServer, MovesAtAFifthOfItsSpeedWhateverAPointSays) {
  const double degrees_a_second = 0.2 * model().axes[0].speed;
  const double begin = ask(cabinet.read()).joints[0];
  ASSERT_EQ(point(0, 1, 1).at(2), 1);
  executor.run_for(1s);
  const double moved = std::abs(ask(cabinet.read()).joints[0] - begin);
  EXPECT_LT(moved, degrees_a_second);
  EXPECT_GT(moved, 0.5 * degrees_a_second);
}

}  // namespace
}  // namespace pizarra::arm
