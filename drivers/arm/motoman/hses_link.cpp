#include "drivers/arm/motoman/hses_link.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/line/octets.hpp"

namespace pizarra::arm {

namespace {

constexpr line::Retries once{.tries = 1, .pause = 100ms};
constexpr double units_per_deg = 10'000;
constexpr std::size_t axes_in_a_move = 7;
constexpr std::size_t position_size = 4 * (5 + motoman_axes);

std::string word(std::uint32_t value) { return line::OctetWriter(line::ByteOrder::little).u32(value).octets(); }

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::llround(value)); }

std::unexpected<Failure> refused(const HsesReply& reply) {
  const std::string sentence =
      fmt::format("the controller refused it: {}", reply.added_status != 0
                                                       ? fmt::format("{:04X}", reply.added_status)
                                                       : fmt::format("status {:02X} without a reason", reply.status));
  return fail("refused", sentence, to_datum(reply.added_status));
}

}  // namespace

Task<Result<std::string>> HsesLink::ask(HsesRequest request, std::size_t size, line::Retries retries) {
  request.id = ++last_id_;
  std::string datagram = write_hses(request);
  const Result<std::string> answer = co_await exchanges_.ask(request.id, std::move(datagram), retries);
  if (!answer) co_return fail(answer);
  const Result<HsesReply> reply = read_hses_reply(*answer);
  if (!reply) co_return fail("bad-reply", reply.error().sentence);
  if (reply->service != (request.service | hses::answered)) {
    co_return fail("bad-reply", fmt::format("the controller answered {:02X} with another service", request.command));
  }
  if (reply->status != 0) co_return refused(*reply);
  if (reply->data.size() != size) {
    co_return fail("bad-reply", fmt::format("the controller answered {:02X} with {} octets instead of {}",
                                            request.command, reply->data.size(), size));
  }
  co_return reply->data;
}

Task<Result<void>> HsesLink::order(HsesRequest request, line::Retries retries) {
  const Result<std::string> done = co_await ask(std::move(request), 0, retries);
  if (!done) co_return fail(done);
  co_return Result<void>();
}

Task<Result<MotomanStatus>> HsesLink::status() {
  const HsesRequest request{.command = hses::status, .instance = 1, .service = hses::get_all};
  const Result<std::string> data = co_await ask(request, 8);
  if (!data) co_return fail(data);
  line::OctetReader read(*data, line::ByteOrder::little);
  const std::uint32_t modes = read.u32();
  const std::uint32_t states = read.u32();
  co_return motoman_status(modes, states);
}

Task<Result<std::uint32_t>> HsesLink::alarm_code() {
  const HsesRequest newest{.command = hses::alarm, .instance = 1, .attribute = 1, .service = hses::get_one};
  const Result<std::string> data = co_await ask(newest, 4);
  if (!data) co_return fail(data);
  co_return line::OctetReader(*data, line::ByteOrder::little).u32();
}

Task<Result<MotomanPulses>> HsesLink::pulses() {
  const HsesRequest request{.command = hses::position, .instance = hses::robot_pulses, .service = hses::get_all};
  const Result<std::string> data = co_await ask(request, position_size);
  if (!data) co_return fail(data);
  line::OctetReader read(*data, line::ByteOrder::little);
  for (int i = 0; i < 5; ++i) read.u32();
  MotomanPulses pulses{};
  for (std::int32_t& axis : pulses) axis = read.i32();
  co_return pulses;
}

Task<Result<MotomanPose>> HsesLink::pose() {
  const HsesRequest request{.command = hses::position, .instance = hses::robot_base, .service = hses::get_all};
  const Result<std::string> data = co_await ask(request, position_size);
  if (!data) co_return fail(data);
  line::OctetReader read(*data, line::ByteOrder::little);
  MotomanPose pose;
  read.u32();
  pose.form = read.u32();
  pose.tool = read.u32();
  read.u32();
  pose.extended_form = read.u32();
  for (double& mm : pose.place_mm) mm = read.i32() / um_per_mm;
  for (double& deg : pose.angles_deg) deg = read.i32() / units_per_deg;
  co_return pose;
}

Task<Result<void>> HsesLink::turn(MotomanSwitch which, bool on) {
  HsesRequest request{.command = hses::power, .attribute = 1, .service = hses::set_one};
  request.instance = which == MotomanSwitch::servo ? hses::servo : hses::hold;
  request.data = word(on ? hses::on : hses::off);
  return order(std::move(request));
}

Task<Result<void>> HsesLink::reset() {
  HsesRequest request{.command = hses::reset, .instance = hses::reset_alarm, .attribute = 1, .service = hses::set_one};
  request.data = word(1);
  const Result<void> alarm = co_await order(request);
  if (!alarm) co_return alarm;
  request.instance = hses::cancel_error;
  const Result<void> error = co_await order(request);
  co_return error;
}

Task<Result<void>> HsesLink::move_joints(MotomanPulses target, double part) {
  line::OctetWriter data(line::ByteOrder::little);
  constexpr double hundredths = 10'000;
  const auto speed = static_cast<std::uint32_t>(std::clamp(rounded(part * hundredths), 1, rounded(hundredths)));
  data.u32(1).u32(0).u32(hses::percent).u32(speed);
  for (std::size_t axis = 0; axis < axes_in_a_move; ++axis) data.i32(target[axis]);
  data.u32(0).u32(0).zeros(36);
  HsesRequest request{.command = hses::move_pulses, .instance = hses::joint_move, .attribute = 1};
  request.service = hses::set_all;
  request.data = data.octets();
  return order(std::move(request), once);
}

Task<Result<void>> HsesLink::move_straight(MotomanPose target, double mm_s) {
  line::OctetWriter data(line::ByteOrder::little);
  constexpr double tenths = 10;
  const auto speed = static_cast<std::uint32_t>(std::max(1, rounded(mm_s * tenths)));
  data.u32(1).u32(0).u32(hses::millimetres).u32(speed).u32(hses::base_frame);
  for (const double mm : target.place_mm) data.i32(rounded(mm * um_per_mm));
  for (const double deg : target.angles_deg) data.i32(rounded(deg * units_per_deg));
  data.u32(0).u32(0).u32(target.form).u32(target.extended_form).u32(target.tool).u32(0).zeros(36);
  HsesRequest request{.command = hses::move_cartesian, .instance = hses::linear_move, .attribute = 1};
  request.service = hses::set_all;
  request.data = data.octets();
  return order(std::move(request), once);
}

Task<Result<std::int32_t>> HsesLink::variable(int number) {
  HsesRequest request{.command = hses::double_integer, .attribute = 1, .service = hses::get_one};
  request.instance = static_cast<std::uint16_t>(number);
  const Result<std::string> data = co_await ask(std::move(request), 4);
  if (!data) co_return fail(data);
  co_return line::OctetReader(*data, line::ByteOrder::little).i32();
}

Task<Result<void>> HsesLink::set_variable(int number, std::int32_t value) {
  HsesRequest request{.command = hses::double_integer, .attribute = 1, .service = hses::set_one};
  request.instance = static_cast<std::uint16_t>(number);
  request.data = word(static_cast<std::uint32_t>(value));
  return order(std::move(request));
}

}  // namespace pizarra::arm
