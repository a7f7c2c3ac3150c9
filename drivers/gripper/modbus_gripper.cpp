#include "drivers/gripper/modbus_gripper.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pizarra::gripper {

namespace {

std::uint16_t part_of(double part, const forms::RegisterField& field) {
  return static_cast<std::uint16_t>(std::lround(part * ((1 << field.bits) - 1)));
}

}  // namespace

Task<Result<RegisterImage>> ModbusGripper::state() {
  const RegisterImage empty(states_of(setup_));
  Result<std::vector<std::uint16_t>> values = co_await client_.read(empty.first(), empty.values().size());
  if (!values) co_return fail(values);
  co_return RegisterImage(empty.first(), std::move(*values));
}

Task<Result<void>> ModbusGripper::tell(bool active, bool go, int target) {
  RegisterImage image(orders_of(setup_));
  image.put(setup_.activate, active ? 1 : 0);
  image.put(setup_.go, go ? 1 : 0);
  image.put(setup_.target, static_cast<std::uint16_t>(target));
  image.put(setup_.speed_field, part_of(setup_.speed, setup_.speed_field));
  image.put(setup_.force_field, part_of(setup_.force, setup_.force_field));
  return client_.write(image.first(), image.values());
}

// Whether it can be moved.
Result<void> ModbusGripper::sound(const RegisterImage& state) const {
  const int fault = state.get(setup_.fault);
  if (fault != 0) return fail("not-in-control", fmt::format("the gripper has fault {}", fault), to_datum(fault));
  if (state.get(setup_.active) != gripper::ready) return fail("not-in-control", "the gripper is not activated");
  return {};
}

Task<Result<void>> ModbusGripper::connect() {
  const Result<RegisterImage> found = co_await state();
  if (!found) co_return fail(found);
  Result<void> ready = sound(*found);
  if (ready) co_return ready;
  for (const bool active : {false, true}) {
    const Result<void> written = co_await tell(active, false, setup_.open_count);
    if (!written) co_return written;
  }
  const Time deadline = executor_.now() + activation_time;
  while (!ready && executor_.now() < deadline) {
    co_await sleep(executor_, look_again);
    const Result<RegisterImage> now = co_await state();
    if (!now) co_return fail(now);
    ready = sound(*now);
  }
  co_return ready;
}

Task<Result<void>> ModbusGripper::start(double opening_mm) {
  if (!std::isfinite(opening_mm)) co_return fail("not-finite", "the opening is not a number");
  const Result<RegisterImage> now = co_await state();
  if (!now) co_return fail(now);
  const Result<void> ready = sound(*now);
  if (!ready) co_return ready;
  const double part = (opening_mm - setup_.closed_mm) / (setup_.open_mm - setup_.closed_mm);
  const double count = std::lerp(setup_.closed_count, setup_.open_count, std::clamp(part, 0.0, 1.0));
  const Result<void> told = co_await tell(true, true, static_cast<int>(std::lround(count)));
  if (!told) co_return told;
  started_at_ = executor_.now();
  co_return Result<void>();
}

Task<Result<GripperReading>> ModbusGripper::read() {
  const Result<RegisterImage> now = co_await state();
  if (!now) co_return fail(now);
  const Result<void> ready = sound(*now);
  if (!ready) co_return fail(ready);
  const int range = setup_.open_count - setup_.closed_count;
  const double part = static_cast<double>(now->get(setup_.opening) - setup_.closed_count) / range;
  const std::uint16_t object = now->get(setup_.object);
  GripperReading reading{.opening_mm = std::lerp(setup_.closed_mm, setup_.open_mm, part),
                         .moving = object == gripper::on_its_way || executor_.now() - started_at_ < starting_time,
                         .gripped = object == gripper::met_opening || object == gripper::met_closing};
  // One that was never sent anywhere stands.
  if (started_at_ == Time{}) reading.moving = false;
  co_return reading;
}

}  // namespace pizarra::gripper
