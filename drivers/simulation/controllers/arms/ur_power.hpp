#pragma once

// Whether the arm has power, and whether its brakes are released.
//
//   UrPower power(cabinet);
//   power.on();                    // mode(): idle
//   power.release_brakes();        // running

#include <cstdint>

#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"

namespace pizarra::simulation {

class UrPower {
 public:
  static constexpr std::int32_t off_mode = 3;
  static constexpr std::int32_t idle_mode = 5;

  // The cabinet outlives it.
  explicit UrPower(ArmCabinet& cabinet) : cabinet_(cabinet) {}
  void on() { energized_ = true; }
  void off();
  void release_brakes();
  std::int32_t mode() const;

 private:
  ArmCabinet& cabinet_;
  bool energized_ = false;  // its brakes may be on
};

}  // namespace pizarra::simulation
