#pragma once

// Arm files: an arm as data, read by the embedded Scheme like cell files. A new arm is one of these, under 60 lines.
//
//   (arm crs-t265
//     (units mm deg)                                       ; or cm, m, in; rad. Left out: these
//     (articulated (height 300) (offset 0) (upper-arm 254) (forearm 254) (raise 0) (wrist 50) (tool 130))
//     (axis turn     (limits -175 175) (speed 175))        ; axis 1; a second: degrees or mm
//     (axis shoulder (limits 0 110)    (speed 175) (sense 1) (zero 0))
//     (axis elbow    (limits -125 0)   (speed 175) (from base) (zero 90))   ; a linkage holds it against the base
//     (axis pitch    (limits -180 180) (speed 300) (from base) (stops -110 110))  ; against the forearm
//     (axis spin     (limits -180 180) (speed 350) (pulses-per-turn 283600))
//     (axis track    (limits 0 1000)   (speed 500) (along x) (zero -500))
//     (home  0 100 -72 -90 0 500)                          ; a number an axis
//     (ready 0 60 -90 -90 0 500))
//
// `articulated` may be polar, scara or gantry instead; arm_model.hpp says which axes each has and what they count. Of
// `articulated`, without an axis of roll, also (side 133) where the links' plane lies beside axis 1, and (across 100)
// where the tool lies beside the pitch axis. A number that is left out is 0. An axis counts upwards (sense 1) and from
// the link before, unless it says otherwise. (pizarra arm) interprets it.

#include "drivers/arm/arm_model.hpp"
#include "lisp/reader.hpp"

namespace pizarra::arm {

// A failure reports every error of the file, each with a caret.
Result<ArmModel> read_arm_file(const std::string& path);

// The arm that arms/NAME.scm describes. Failure: unknown-arm, with the nearest name.
Result<ArmModel> shipped_arm(std::string_view name);

// As every robot agent of a cell may be asked to drive.
const ArmModel& crs_f3();

}  // namespace pizarra::arm
