#include "drivers/arm/simple_message/motoros_message.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pizarra::arm {

namespace {

constexpr std::size_t unused_numbers = 4 * simple::axes;  // accelerations; data of commands and replies

void write_joints(line::OctetWriter& data, const SimpleJoints& joints) {
  for (const float joint : joints) data.f32(joint);
}

void read_joints(line::OctetReader& read, SimpleJoints& joints) {
  for (float& joint : joints) joint = read.f32();
}

std::unexpected<Failure> odd_size(const char* what, std::size_t octets) {
  return fail("bad-reply", fmt::format("{} of MotoROS has {} octets", what, octets));
}

Result<void> all_finite(const SimpleJoints& joints) {
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    if (!std::isfinite(joints[axis])) {
      return fail("bad-reply", fmt::format("the value for axis {} is not a number", axis + 1), to_datum(axis + 1));
    }
  }
  return {};
}

}  // namespace

std::string write_motoros_point(const MotorosPoint& point, line::ByteOrder order) {
  line::OctetWriter data(order);
  data.i32(point.group).i32(point.sequence).i32(point.has).f32(point.time_s);
  write_joints(data, point.joints_rad);
  write_joints(data, point.speeds_rad_s);
  return data.zeros(unused_numbers).octets();
}

Result<MotorosPoint> read_motoros_point(std::string_view data, line::ByteOrder order) {
  line::OctetReader read(data, order);
  MotorosPoint point;
  point.group = read.i32();
  point.sequence = read.i32();
  point.has = read.i32();
  point.time_s = read.f32();
  read_joints(read, point.joints_rad);
  read_joints(read, point.speeds_rad_s);
  read.text(unused_numbers);
  if (!read.whole()) return odd_size("a point", data.size());
  if (!std::isfinite(point.time_s)) return fail("bad-reply", "the time of a point is no number");
  for (const SimpleJoints* joints : {&point.joints_rad, &point.speeds_rad_s}) {
    const Result<void> sound = all_finite(*joints);
    if (!sound) return fail(sound);
  }
  return point;
}

std::string write_feedback(const MotorosFeedback& feedback, line::ByteOrder order) {
  line::OctetWriter data(order);
  data.i32(feedback.group).i32(feedback.has).f32(feedback.time_s);
  write_joints(data, feedback.joints_rad);
  write_joints(data, feedback.speeds_rad_s);
  return data.zeros(unused_numbers).octets();
}

Result<MotorosFeedback> read_feedback(std::string_view data, line::ByteOrder order) {
  line::OctetReader read(data, order);
  MotorosFeedback feedback;
  feedback.group = read.i32();
  feedback.has = read.i32();
  feedback.time_s = read.f32();
  read_joints(read, feedback.joints_rad);
  read_joints(read, feedback.speeds_rad_s);
  read.text(unused_numbers);
  if (!read.whole()) return odd_size("a feedback", data.size());
  const Result<void> sound = all_finite(feedback.joints_rad);
  if (!sound) return fail(sound);
  return feedback;
}

std::string write_control(const MotorosControl& control, line::ByteOrder order) {
  line::OctetWriter data(order);
  data.i32(control.group).i32(control.sequence).i32(control.command);
  return data.zeros(unused_numbers).octets();
}

Result<MotorosControl> read_control(std::string_view data, line::ByteOrder order) {
  line::OctetReader read(data, order);
  MotorosControl control;
  control.group = read.i32();
  control.sequence = read.i32();
  control.command = read.i32();
  read.text(unused_numbers);
  if (!read.whole()) return odd_size("a command", data.size());
  return control;
}

std::string write_reply(const MotorosReply& reply, line::ByteOrder order) {
  line::OctetWriter data(order);
  data.i32(reply.group).i32(reply.sequence).i32(reply.command).i32(reply.result).i32(reply.subcode);
  return data.zeros(unused_numbers).octets();
}

Result<MotorosReply> read_reply(std::string_view data, line::ByteOrder order) {
  line::OctetReader read(data, order);
  MotorosReply reply;
  for (std::int32_t* field : {&reply.group, &reply.sequence, &reply.command, &reply.result, &reply.subcode}) {
    *field = read.i32();
  }
  read.text(unused_numbers);
  if (!read.whole()) return odd_size("a reply", data.size());
  return reply;
}

std::string_view meaning_of(const MotorosReply& reply) {
  struct Meaning {
    std::int32_t code;
    std::string_view words;
  };
  constexpr Meaning subcodes[] = {{3001, "the message has another size"},
                                  {3002, "the message's head is not sound"},
                                  {3003, "the type of the message is not known"},
                                  {3004, "there is no such control group"},
                                  {3005, "the point's number is not the next"},
                                  {3006, "the command is not known"},
                                  {3011, "the trajectory does not begin where the arm stands"},
                                  {3012, "a point is beyond the axes' limits"},
                                  {3013, "an axis would be too fast"},
                                  {3015, "a point lacks time, position or speed"},
                                  {3016, "the trajectory takes too long"},
                                  {5001, "there is an alarm"},
                                  {5002, "there is an error"},
                                  {5003, "the emergency stop is pressed"},
                                  {5004, "the controller is not in play mode"},
                                  {5005, "the pendant has control: the controller is not in remote mode"},
                                  {5006, "the servos are off"},
                                  {5007, "the controller is held"},
                                  {5008, "the job that moves the arm has not been started"},
                                  {5009, "the job that moves the arm does not wait for points"},
                                  {5011, "the limits of power and force have stopped the arm"}};
  constexpr std::string_view results[] = {
      "done", "busy", "the controller failed", "the request is not valid", "there is an alarm", "it is not ready"};
  const auto* known = std::ranges::find(subcodes, reply.subcode, &Meaning::code);
  if (known != std::end(subcodes)) return known->words;
  const auto result = static_cast<std::size_t>(reply.result);
  return result < std::size(results) ? results[result] : "the controller failed";
}

}  // namespace pizarra::arm
