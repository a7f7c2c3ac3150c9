#pragma once

// What the coordinator offers, posts, reads, lets you configure and monitor, with the domain's predicates among it.

#include <string>

#include "agents/coordinator/plan/task_domain.hpp"

namespace pizarra::coordinator {

// `head`: whether the camera stands on one.
std::string coordinator_contract(const TaskDomain& domain, bool head);

}  // namespace pizarra::coordinator
