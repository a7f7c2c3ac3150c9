#pragma once

// The kinds of devices that `emulate` knows, each with the options it takes.
//
//   const int status = emulate_arm(choices);

#include <string>
#include <vector>

namespace pizarra::programs {

struct EmulateChoices {
  std::string device;
  bool pty = false;
  int port = -1;  // the device's own where it is negative
  std::string address = "127.0.0.1";
  std::string world;     // of the simulated world whose arm is moved; empty: an arm of its own
  std::string programs;  // the folder of those that a ur5e has stored; empty: it has none
  bool json = false;
};

std::vector<std::string> pan_tilt_names();
int emulate_pan_tilt(const EmulateChoices& choices);

std::vector<std::string> arm_device_names();
int emulate_arm(const EmulateChoices& choices);

inline constexpr const char* gripper_name = "gripper";
int emulate_gripper(const EmulateChoices& choices);

// Says that `choices` are emulated, and where.
void say_where(const EmulateChoices& choices, const std::string& where);

}  // namespace pizarra::programs
