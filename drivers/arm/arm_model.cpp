#include "drivers/arm/arm_model.hpp"

namespace pizarra {

const ArmModel& crs_f3() {
  static const ArmModel model{
      .type = "crs-f3",
      .base_height_mm = 350,
      .base_offset_mm = 100,
      .upper_arm_mm = 265,
      .forearm_mm = 270,
      .wrist_mm = 75,
      .tool_mm = 130,
      .limits = {{{-180, 180, 240},
                  {-135, 45, 210},
                  {-135, 135, 240},
                  {-180, 180, 375},
                  {-135, 135, 300},
                  {-18432, 18432, 375}}},
      .home = {0, 20, -80, 0, -120, 0},
      .ready = {0, 0, -90, 0, -90, 0},
  };
  return model;
}

const ArmModel* arm_model(std::string_view type) { return type == crs_f3().type ? &crs_f3() : nullptr; }

}  // namespace pizarra
