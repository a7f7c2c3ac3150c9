#pragma once

// What the dashboard server answers: power, mode and stored programs.
//
//   UrDashboard dashboard(cabinet, power, programs);
//   const std::string answer = co_await dashboard.answer("robotmode");     // "Robotmode: IDLE"

#include <string>

#include "drivers/simulation/controllers/arms/ur_power.hpp"
#include "drivers/simulation/controllers/arms/ur_programs.hpp"

namespace pizarra::simulation {

class UrDashboard {
 public:
  // All outlive it.
  UrDashboard(ArmCabinet& cabinet, UrPower& power, UrPrograms& programs)
      : cabinet_(cabinet), power_(power), programs_(programs) {}
  Task<std::string> answer(std::string line);

 private:
  std::string loaded_program() const;
  std::string program_state() const;
  std::string safety(bool status) const;

  ArmCabinet& cabinet_;
  UrPower& power_;
  UrPrograms& programs_;
};

}  // namespace pizarra::simulation
