#include "drivers/simulation/controllers/arms/simple_emulator.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::int32_t version = 2;          // a type of message
constexpr std::int32_t begin_download = -1;  // in place of a sequence number
constexpr std::int32_t begin_streaming = -2;

}  // namespace

line::FrameReader SimpleEmulator::frames() const {
  if (kind_.serial) return arm::frame_of_serial;
  return kind_.order == line::ByteOrder::little ? arm::frame_of_tcp_little : arm::frame_of_tcp_big;
}

std::string SimpleEmulator::framed(const arm::SimpleMessage& message) const {
  const std::string octets = arm::write_simple(message, kind_.order);
  return kind_.serial ? arm::serial_frame(octets) : arm::tcp_frame(octets, kind_.order);
}

Task<bool> SimpleEmulator::obey(arm::SimplePoint point) {
  if (point.sequence == begin_streaming) co_return true;
  if (point.sequence == begin_download) co_return false;
  const bool next = point.sequence == 0 || point.sequence == last_sequence_ + 1;
  if (point.sequence == arm::simple::stop_trajectory || !next) {
    last_sequence_ = -1;
    co_await cabinet_.stop();
    co_return point.sequence == arm::simple::stop_trajectory;
  }
  const arm::ArmReading reading = co_await cabinet_.read();
  const arm::ArmModel& model = cabinet_.model();
  arm::Joints target = reading.joints;
  std::size_t joint = 0;
  for (std::size_t axis = 0; axis < target.size(); ++axis) {
    if (model.axes[axis].role == arm::Role::track && !kind_.track) continue;
    target[axis] = arm::axis_of_joint(model.axes[axis].role, point.joints_rad[joint++], kind_.sign);
  }
  std::vector<arm::Joints> waypoints{target};
  const double speed = kind_.fixed_speed > 0 ? kind_.fixed_speed : point.velocity;
  const Refusal refusal = co_await cabinet_.move(std::move(waypoints), speed);
  if (refusal == Refusal::none) last_sequence_ = point.sequence;
  co_return refusal == Refusal::none;
}

Task<std::string> SimpleEmulator::answer(std::string octets) {
  const Result<arm::SimpleMessage> message = arm::read_simple(octets, kind_.order);
  const bool asked = message && cabinet_.powered() && message->kind == arm::simple::request;
  if (!asked) co_return std::string();
  arm::SimpleMessage reply{.type = message->type, .kind = arm::simple::reply, .code = arm::simple::failure};
  reply.data = std::string(4 * arm::simple::axes, '\0');
  if (message->type == arm::simple::ping) reply.code = arm::simple::success;
  if (message->type == version) {
    reply.code = arm::simple::success;
    reply.data = line::OctetWriter(kind_.order).i32(1).i32(0).i32(0).octets();
  }
  if (message->type == arm::simple::trajectory_point) {
    const Result<arm::SimplePoint> point = arm::read_point(message->data, kind_.order);
    const bool done = point.has_value();
    if (done) {
      const bool obeyed = co_await obey(*point);
      if (obeyed) reply.code = arm::simple::success;
    }
  }
  co_return framed(reply);
}

Task<std::string> SimpleEmulator::state() {
  const arm::ArmReading reading = co_await cabinet_.read();
  const arm::ArmModel& model = cabinet_.model();
  arm::SimplePosition position;
  std::size_t joint = 0;
  for (std::size_t axis = 0; axis < reading.joints.size(); ++axis) {
    if (model.axes[axis].role == arm::Role::track && !kind_.track) continue;
    position.joints_rad[joint++] = arm::joint_of_axis(model.axes[axis].role, reading.joints[axis], kind_.sign);
  }
  arm::SimpleStatus status;
  status.drives_powered = cabinet_.servo() ? 1 : 0;
  status.emergency_stopped = cabinet_.emergency() ? 1 : 0;
  status.error_code = cabinet_.alarm();
  status.in_error = cabinet_.alarm() != 0 ? 1 : 0;
  status.in_motion = reading.moving ? 1 : 0;
  status.mode = cabinet_.pendant() ? 1 : 2;
  status.motion_possible = cabinet_.servo() && !cabinet_.pendant_hold() ? 1 : 0;
  arm::SimpleMessage told{.type = arm::simple::status, .kind = arm::simple::topic};
  told.data = arm::write_status(status, kind_.order);
  std::string both = framed(told);
  told.type = arm::simple::joint_position;
  told.data = arm::write_position(position, kind_.order);
  co_return both + framed(told);
}

}  // namespace pizarra::simulation
