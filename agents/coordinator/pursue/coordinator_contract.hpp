#pragma once

// The coordinator's contract, with the domain's predicates in it.

#include <string>

#include "agents/coordinator/plan/task_domain.hpp"

namespace pizarra::coordinator {

// `head`: whether the camera stands on one.
std::string coordinator_contract(const TaskDomain& domain, bool head);

}  // namespace pizarra::coordinator
