#pragma once

// The lines of an emulated arm's controller, and who answers there: one kind for each protocol and arm.
//
//   const ArmKind& kind = *std::ranges::find(arm_kinds(), "ur5e", &ArmKind::name);
//   Result<ArmServing> serving = kind.serve(executor, cabinet, choices);
//   serving->where          // "tcp://127.0.0.1:30004,30002,29999,30001,30003"

#include <span>
#include <string>
#include <string_view>

#include "blackboard/time/executor.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "lisp/parts.hpp"
#include "programs/emulate/devices.hpp"

namespace pizarra::programs {

// Destroying it ends the lines and the answers.
struct ArmServing {
  std::string where;
  Parts parts = {};
};

struct ArmKind {
  std::string_view name;
  std::string_view arm;  // its file among arms/
  Result<ArmServing> (*serve)(Executor&, simulation::ArmCabinet&, const EmulateChoices&);
  int ports = 1;        // one after another, where the first is asked for
  bool serial = false;  // whether it has serial lines, too
};

std::span<const ArmKind> arm_kinds();

}  // namespace pizarra::programs
