#pragma once

// A fault of a run, as data: its class, when it comes, and what goes wrong.
//
//   Fault fault{"network", {.after_s = 3.5}, read_one("(break coordinator)").value()};
//   write(fault_to_datum(fault));          // (network (after 3.5) (break coordinator))

#include <optional>
#include <string>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::chaos {

struct Fault {
  // Seconds after the first goal was given; or when an operation of this kind is in hand and the servo in this state,
  // and so many seconds later.
  struct When {
    double after_s = 0;
    std::string operation = {};
    int servo_state = 0;
  };
  std::string kind;
  When when;
  Datum what;
};

Datum fault_to_datum(const Fault& fault);

// The classes of faults, each with what `chaos --help` says of it.
struct FaultClass {
  const char* name;
  const char* sentence;
};
const std::vector<FaultClass>& fault_classes();

}  // namespace pizarra::chaos
