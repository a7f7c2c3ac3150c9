#pragma once

// Descriptions of components that people write, and the lists that stand with the drivers:
//
//   (system "the thesis' cell"
//     (component vision-server (physical) (performance) (connections 3))
//     (connection coordinator vision-server SEND))
//   (component robot (physical) (does transformation interpretation))         a kind of agents
//   (wrapped robot "CRS" (operations home ready) (functions (CRSRobot 126) (CRSPath 5)))
//
//   Result<System> system = read_system("examples/09-method/thesis.scm");
//
// In a component stand (level 1) or (level 2), and what is met of (physical), (performance), (abstraction). Without
// (operations ...) a wrapper's operations are all that its contract offers.

#include <map>
#include <optional>

#include "lisp/result.hpp"
#include "programs/method/system.hpp"

namespace pizarra::method {

// Of one driver: what the software or device that it wraps offers.
struct Wrapped {
  std::string kind;  // of the agents that stand on it
  std::string name;
  std::set<std::string> operations;
  std::size_t functions = 0;
};

// Failures bad-description, and those of a file that cannot be read, with their places.
Result<System> read_system(const std::string& path);
// Whether the file describes a system, rather than a cell.
bool is_system_file(const std::string& path);

// By kind: those of ours, and those of the file, which may be empty.
Result<std::map<std::string, Component>> known_components(const std::string& more);
// The lists of the drivers that have one.
Result<std::vector<Wrapped>> known_wrapped();

}  // namespace pizarra::method
