#include "drivers/arm/meeting.hpp"

#include <fmt/format.h>

#include "drivers/arm/move_check.hpp"

namespace pizarra::arm {

namespace {

constexpr Duration look_again = 20ms;

Task<Result<ArmReading>> bring_to_rest(Executor& executor, ArmDriver& driver) {
  const Result<void> stopping = co_await driver.stop();
  if (!stopping) co_return fail(stopping);
  const Time deadline = executor.now() + stopping_time;
  Result<ArmReading> reading = co_await driver.read();
  while (reading && reading->moving) {
    if (executor.now() >= deadline) co_return fail("fault", "the arm was found moving, and does not stop");
    co_await sleep(executor, look_again);
    reading = co_await driver.read();
  }
  co_return reading;
}

}  // namespace

bool moves_for_nobody(const ArmReading& reading) {
  const bool by_pendant = reading.trouble && reading.trouble->kind == ArmTrouble::Kind::stopped;
  return reading.moving && !by_pendant;
}

Task<Result<ArmMeeting>> meet_arm(Executor& executor, ArmDriver& driver, const ArmModel& model) {
  const Result<std::string> type = co_await driver.identify();
  if (!type) {
    // As of one whose state is silent and whose motion is not. Another's arm is let alone.
    const bool perhaps_moves = type.error().symbol != "unknown-arm";
    if (perhaps_moves) {
      [[maybe_unused]] const Result<void> stopped = co_await driver.stop();
    }
    co_return fail(type);
  }
  if (*type != model.type) {
    co_return fail("unknown-arm",
                   fmt::format("the controller is of a {}, and the cell describes a {}", *type, model.type),
                   to_datum(*type));
  }
  Result<ArmReading> reading = co_await driver.read();
  const bool moves = reading && moves_for_nobody(*reading);
  // Of one that does not say whether it moves nobody knows that it stands.
  const bool stops = moves || !reading;
  if (stops) reading = co_await bring_to_rest(executor, driver);
  if (!reading) co_return fail(reading);
  const Result<void> possible = check_reading(model, reading->joints);
  if (!possible) {
    co_return fail(
        "joint-limit",
        fmt::format("{}: the arm is no {}, or its pendant must bring it back", possible.error().sentence, model.type),
        possible.error().subject);
  }
  ArmMeeting meeting{*reading, moves};
  co_return meeting;
}

}  // namespace pizarra::arm
