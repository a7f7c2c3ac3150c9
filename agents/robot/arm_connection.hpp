#pragma once

// The controller of one arm, as the agent has it: met or lost, with its servos on or released. It reads where the arm
// is, and keeps the facts about the arm in step.
//
// Control is taken when the agent meets the controller for the first time and finds neither alarm nor lock there, and
// from then on only when somebody asks for it: a controller that had an alarm, lost its power or was locked keeps its
// servos off until then, and a motion is refused with its reason.
//
//   ArmConnection connection(executor, driver, model, facts);
//   const Result<void> connected = co_await connection.connect();
//   if (!connected) connection.lose(connected.error());              // until it is connected again
//   const Result<arm::ArmReading> reading = co_await connection.read();
//
// Failures: disconnected, unknown-arm, and the driver's own. What it is given outlives it.

#include <functional>
#include <optional>
#include <string>

#include "agents/robot/arm_facts.hpp"

namespace pizarra::robot {

class ArmConnection {
 public:
  static constexpr Duration braking_time = 1s;  // what still moves after it is told to stop once more

  ArmConnection(Executor& executor, arm::ArmDriver& driver, const arm::ArmModel& model, ArmFacts& facts)
      : executor_(executor), driver_(driver), model_(model), facts_(facts) {}
  ArmConnection(const ArmConnection&) = delete;
  ArmConnection& operator=(const ArmConnection&) = delete;

  // Asks which arm it is, and stops what moves: nobody is left who could answer for that move.
  Task<Result<arm::ArmReading>> find();
  // The same, and switches its servos on where the controller was not met before.
  Task<Result<void>> connect();
  // Resets alarms, switches servos on, releases brakes: what somebody asked for who knows why they were as they were.
  Task<Result<void>> get_control();
  // Switches its servos off.
  Task<Result<void>> release_control();
  // Whoever released it, in an earlier life too.
  void set_released(std::string by) { released_by_ = std::move(by); }
  const std::string& released_by() const { return released_by_; }
  // The controller is away.
  void lose(const Failure& why);
  bool is_there() const { return there_; }
  const std::string& why_lost() const { return why_lost_; }

  Task<Result<arm::ArmReading>> read();
  // Gets every reading of read().
  std::function<void(const arm::ArmReading&)> on_reading = [](const arm::ArmReading&) {};
  Task<Result<void>> brake();
  // Some controllers move, or say so, while they brake.
  bool is_braking() const { return braked_at_ && executor_.now() - *braked_at_ < braking_time; }
  // What moves from here on moves for nobody.
  void forget_braking() { braked_at_.reset(); }

  arm::ArmDriver& driver() { return driver_; }
  const arm::ArmModel& model() const { return model_; }

 private:
  Task<Result<void>> switch_on();

  Executor& executor_;
  arm::ArmDriver& driver_;
  const arm::ArmModel& model_;
  ArmFacts& facts_;
  bool known_ = false;         // the controller has said once that it is of this arm
  bool found_moving_ = false;  // and was stopped, which is not told yet
  bool there_ = false;
  std::string why_lost_;
  std::string released_by_;  // empty: it is not
  std::optional<Time> braked_at_;
};

}  // namespace pizarra::robot
