#include "drivers/simulation/controllers/arms/motoros_emulator.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/arm/kinematics.hpp"
#include "drivers/arm/route.hpp"

namespace pizarra::simulation {

namespace {

namespace motoros = arm::motoros;

constexpr double every_angle = 1;  // angles count as the axes' do
constexpr double start_slack = 0.05;
constexpr double fastest = 1.02;  // of an axis' speed: what rounding leaves

// The part of the axes' full speeds at which a way takes `wanted_s`, ramps included. Without them, at full speed, it
// takes `way_s`. The ramps reach full speed within a quarter of a second.
double part_for(double way_s, double wanted_s) {
  constexpr double pace_per_s = 4;
  constexpr double slowest = 1e-3;
  const double beyond = wanted_s * wanted_s - 4 * way_s / pace_per_s;
  const double pace = beyond > 0 ? pace_per_s / 2 * (wanted_s - std::sqrt(beyond)) : 1;
  return std::clamp(pace, slowest, 1.0);
}

}  // namespace

line::FrameReader MotorosEmulator::frames() const {
  return order_ == line::ByteOrder::little ? arm::frame_of_tcp_little : arm::frame_of_tcp_big;
}

std::string MotorosEmulator::framed(const arm::SimpleMessage& message) const {
  return arm::tcp_frame(arm::write_simple(message, order_), order_);
}

std::int32_t MotorosEmulator::why_not_ready() const {
  if (cabinet_.alarm() != 0) return motoros::unready_alarm;
  if (cabinet_.emergency()) return motoros::unready_emergency;
  if (cabinet_.pendant()) return motoros::unready_not_remote;
  if (cabinet_.pendant_hold()) return motoros::unready_hold;
  if (!cabinet_.servo()) return motoros::unready_servo_off;
  return in_trajectory_mode_ ? 0 : motoros::unready_not_started;
}

Task<arm::MotorosReply> MotorosEmulator::obey(arm::MotorosControl control) {
  arm::MotorosReply reply{.group = control.group, .sequence = control.sequence, .command = control.command};
  if (control.command == motoros::check_ready) {
    reply.subcode = why_not_ready();
    if (reply.subcode != 0) reply.result = motoros::failure;
  } else if (control.command == motoros::check_queue) {
    reply.subcode = static_cast<std::int32_t>(waiting_.size());
    if (control.group != 0) reply.result = motoros::failure;
  } else if (control.command == motoros::stop_motion) {
    waiting_.clear();
    job_ = Job();
    following_ = false;
    co_await cabinet_.stop();
  } else if (control.command == motoros::start_servos || control.command == motoros::stop_servos) {
    const Refusal refusal = cabinet_.servo(control.command == motoros::start_servos);
    if (refusal != Refusal::none) reply.result = motoros::failure;
  } else if (control.command == motoros::reset_alarm) {
    if (cabinet_.reset() != Refusal::none) reply.result = motoros::failure;
  } else if (control.command == motoros::start_trajectories) {
    const bool by_hand = cabinet_.emergency() || cabinet_.pendant() || cabinet_.pendant_hold();
    const bool ready = !by_hand && cabinet_.reset() == Refusal::none && cabinet_.servo(true) == Refusal::none;
    in_trajectory_mode_ = ready;
    if (!ready) reply.result = motoros::not_ready;
    if (!ready) reply.subcode = why_not_ready();
  } else if (control.command == motoros::stop_trajectories || control.command == motoros::disconnect) {
    in_trajectory_mode_ = false;
  } else {
    reply.result = motoros::invalid;
    reply.subcode = motoros::invalid_command;
  }
  co_return reply;
}

arm::Joints MotorosEmulator::joints_of(const arm::SimpleJoints& joints, const arm::Joints& stands) const {
  arm::Joints read = stands;
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < read.size(); ++axis) {
    const arm::Role role = cabinet_.model().axes[axis].role;
    if (role != arm::Role::track) read[axis] = arm::axis_of_joint(role, joints[next++], every_angle);
  }
  return read;
}

// Its subcode; 0: none.
std::int32_t MotorosEmulator::fault_of(const arm::MotorosPoint& point, const arm::Joints& joints) const {
  constexpr std::int32_t needs = motoros::has_time | motoros::has_position | motoros::has_speed;
  if ((point.has & needs) != needs) return motoros::insufficient_data;
  const arm::Joints speeds = joints_of(point.speeds_rad_s, arm::Joints(joints.size()));
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    if (std::abs(speeds[axis]) > fastest * cabinet_.model().axes[axis].speed) return motoros::invalid_speed;
  }
  const bool next = point.sequence == 0 || (point.sequence == next_ && point.time_s > last_.time_s);
  if (!next) return motoros::invalid_sequence;
  return arm::check_limits(cabinet_.model(), joints) ? 0 : motoros::invalid_position;
}

Task<arm::MotorosReply> MotorosEmulator::take(arm::MotorosPoint point) {
  arm::MotorosReply reply{.group = point.group, .sequence = point.sequence, .command = motoros::trajectory_point};
  reply.subcode = why_not_ready();
  if (reply.subcode != 0) {
    reply.result = motoros::not_ready;
    co_return reply;
  }
  reply.result = motoros::invalid;
  reply.subcode = motoros::invalid_group;
  if (point.group != 0) co_return reply;
  const arm::ArmReading reading = co_await cabinet_.read();
  const arm::Joints joints = joints_of(point.joints_rad, reading.joints);
  reply.subcode = fault_of(point, joints);
  if (point.sequence == 0 && !arm::are_same_place(joints, reading.joints, start_slack)) {
    reply.subcode = motoros::invalid_start;
  }
  if (reply.subcode != 0) co_return reply;
  reply.result = waiting_.size() < most_points ? motoros::success : motoros::busy;
  if (reply.result == motoros::busy) co_return reply;
  next_ = point.sequence + 1;
  last_ = {static_cast<double>(point.time_s), joints};
  waiting_.push_back(last_);
  if (!following_) job_ = executor_.spawn(follow());
  co_return reply;
}

// Goes where the points lead that have come meanwhile, until none are left.
Task<void> MotorosEmulator::follow() {
  following_ = true;
  Place from{};
  while (!waiting_.empty()) {
    co_await sleep(executor_, gathering_time);
    arm::ArmReading reading = co_await cabinet_.read();
    if (from.joints.size() == 0) from = {waiting_.front().time_s, reading.joints};
    std::vector<arm::Joints> way;
    double way_s = 0;
    arm::Joints at = reading.joints;
    for (const Place& place : waiting_) {
      way_s += arm::seconds_between(cabinet_.model(), at, place.joints);
      at = place.joints;
      way.push_back(at);
    }
    const Place end = waiting_.back();
    waiting_.clear();
    const double part = part_for(way_s, end.time_s - from.time_s);
    from = end;
    const Refusal refusal = co_await cabinet_.move(std::move(way), part);
    if (refusal != Refusal::none) break;
    do {
      co_await sleep(executor_, look_again);
      reading = co_await cabinet_.read();
    } while (reading.moving);
    if (reading.stopped) break;
  }
  waiting_.clear();
  following_ = false;
}

Task<std::string> MotorosEmulator::answer(std::string octets) {
  const Result<arm::SimpleMessage> message = arm::read_simple(octets, order_);
  const bool asked = message && cabinet_.powered() && message->kind == arm::simple::request;
  if (!asked) co_return std::string();
  if (message->type == arm::simple::ping) {
    co_return framed({.type = message->type, .kind = arm::simple::reply, .code = arm::simple::success});
  }
  arm::MotorosReply reply{.group = -1, .sequence = -1, .command = message->type};
  reply.result = motoros::invalid;
  reply.subcode = motoros::invalid_message;
  const Result<arm::MotorosControl> control = arm::read_control(message->data, order_);
  const Result<arm::MotorosPoint> point = arm::read_motoros_point(message->data, order_);
  if (message->type == motoros::motion_control && control) {
    reply = co_await obey(*control);
  } else if (message->type == motoros::trajectory_point && point) {
    reply = co_await take(*point);
  }
  arm::SimpleMessage said{.type = motoros::motion_reply, .kind = arm::simple::reply, .code = arm::simple::success};
  said.data = arm::write_reply(reply, order_);
  co_return framed(said);
}

Task<std::string> MotorosEmulator::state() {
  const arm::ArmReading reading = co_await cabinet_.read();
  arm::MotorosFeedback feedback{.has = motoros::has_position};
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < reading.joints.size(); ++axis) {
    const arm::Role role = cabinet_.model().axes[axis].role;
    if (role == arm::Role::track) continue;
    feedback.joints_rad[next++] = arm::joint_of_axis(role, reading.joints[axis], every_angle);
  }
  arm::SimpleStatus status;
  status.drives_powered = cabinet_.servo() ? 1 : 0;
  status.emergency_stopped = cabinet_.emergency() ? 1 : 0;
  status.error_code = cabinet_.alarm();
  status.in_error = cabinet_.alarm() != 0 ? 1 : 0;
  status.in_motion = reading.moving || following_ ? 1 : 0;
  status.mode = cabinet_.pendant() ? 1 : 2;
  status.motion_possible = why_not_ready() == 0 ? 1 : 0;
  arm::SimpleMessage told{.type = motoros::feedback, .kind = arm::simple::topic};
  told.data = arm::write_feedback(feedback, order_);
  std::string both = framed(told);
  told.type = arm::simple::status;
  told.data = arm::write_status(status, order_);
  co_return both + framed(told);
}

}  // namespace pizarra::simulation
