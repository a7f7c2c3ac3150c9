#pragma once

// What the controller makes of programs: those that come over a line, and those that the dashboard loads and plays. A
// new program ends the one before. One that it does not understand is not begun, and the messages say so.
//
// A program is of one line, or lies between `def` and `end`; between `sec` and `end` it runs beside the one that runs,
// and does only what takes no time. URScript's variables, branches, loops and threads are not understood.
//
//   UrPrograms programs(cabinet, values, messages, [](std::string_view name) { return program_in_a_file(name); });
//   programs.run("movej([0, 0, 0, 0, 0, 0])");
//   programs.load("pick.urp"), programs.play();

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/ur_messages.hpp"
#include "drivers/simulation/controllers/arms/ur_values.hpp"
#include "drivers/simulation/controllers/arms/urscript.hpp"

namespace pizarra::simulation {

class UrPrograms {
 public:
  enum class Phase : std::uint8_t { stopped, playing, paused };
  // The text of those that the dashboard may load, by name.
  using Stored = std::function<std::optional<std::string>(std::string_view name)>;

  // All that it is given outlives it.
  UrPrograms(ArmCabinet& cabinet, UrValues& values, UrMessages& messages, Stored stored)
      : cabinet_(cabinet),
        executor_(cabinet.executor()),
        values_(values),
        messages_(messages),
        stored_(std::move(stored)) {}
  UrPrograms(const UrPrograms&) = delete;
  UrPrograms& operator=(const UrPrograms&) = delete;

  void run(std::string_view program);
  // What the dashboard answers.
  std::string load(std::string_view name);
  // Begins the loaded program, or goes on with one that pauses.
  bool play();
  Task<bool> pause();
  Task<void> end();
  void end_soon();
  Phase phase() const { return phase_; }
  // Of the one that runs, or ran, or was loaded.
  const std::string& name() const { return name_; }
  bool has_loaded() const { return loaded_.has_value(); }

 private:
  static constexpr Duration look_again = 8ms;
  void start(std::string name, std::vector<UrStep> steps);
  void forget();
  Task<void> while_paused();
  Task<void> wait(Duration left);
  Task<void> carry_out(std::vector<UrStep> steps);
  Task<bool> move(std::vector<UrStep> moves);
  void set(const UrStep& step);

  ArmCabinet& cabinet_;
  Executor& executor_;
  UrValues& values_;
  UrMessages& messages_;
  Stored stored_;
  Phase phase_ = Phase::stopped;
  std::string name_;
  std::optional<std::vector<UrStep>> loaded_;
  Job running_;
  Job ending_;
};

}  // namespace pizarra::simulation
