#pragma once

// A Motoman arm driven over an emulated controller in virtual time, by a line that may be bad.

#include "drivers/arm/arm_file.hpp"
#include "drivers/arm/motoman/hses_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "tests/drivers/arm/driven_arm.hpp"
#include "tests/drivers/line/lossy_line.hpp"

namespace pizarra::arm {

inline const ArmModel& up6() {
  static const ArmModel model = shipped_arm("motoman-up6").value();
  return model;
}

struct HsesCell : DrivenArm<HsesCell> {
  explicit HsesCell(std::uint64_t seed = 1) : seed_(seed) {}

 private:
  std::uint64_t seed_;

 public:
  VirtualExecutor executor;
  simulation::MovingArm body{executor, up6()};
  simulation::ArmCabinet cabinet{executor, body, up6()};
  simulation::HsesEmulator emulator{cabinet};
  line::LossyLine line{executor, Random(seed_), [this](std::string said) { return emulator.answer(std::move(said)); }};
  HsesLink link{executor, line};
  MotomanArm arm{executor, link, up6()};
};

}  // namespace pizarra::arm
