#pragma once

// A gripper with a controller of its own, as a cell file has it:
//
//   (arm ur5e (driver universal "192.168.0.4")
//     (gripper (driver modbus "192.168.0.11" 502)       ; Modbus TCP
//       (unit 9)                                        ; whom it is to, at this address
//       (opening 0 85)                                  ; mm, closed and open
//       (counts 255 0)                                  ; what the target says of each of these
//       (speed 100) (force 20)                          ; percent of its own
//       (registers (force 1002 0 8))))                  ; those that lie elsewhere: register, lowest bit, bits
//
// Without further words it is laid out as Robotiq's two-finger grippers are; those open 85 or 140 mm.

#include <string>

namespace pizarra::forms {

// Some bits of a register.
struct RegisterField {
  int number;
  int low_bit;
  int bits;
  bool operator==(const RegisterField&) const = default;
};

struct GripperSetup {
  std::string protocol;  // modbus; empty: the arm's own gripper
  std::string place;
  int port = 502;
  int unit = 9;
  double closed_mm = 0;
  double open_mm = 100;
  int closed_count = 255;
  int open_count = 0;
  double speed = 1;  // parts of its own
  double force = 0.2;

  // What it is told, in holding registers.
  RegisterField activate{1000, 8, 1};
  RegisterField go{1000, 11, 1};
  RegisterField target{1001, 0, 8};
  RegisterField speed_field{1002, 8, 8};
  RegisterField force_field{1002, 0, 8};
  // What it tells.
  RegisterField active{2000, 12, 2};
  RegisterField object{2000, 14, 2};
  RegisterField fault{2001, 8, 8};
  RegisterField opening{2002, 8, 8};
};

}  // namespace pizarra::forms
