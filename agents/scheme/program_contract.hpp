#pragma once

// The contract of an agent that is a Scheme file: what the file offers and posts, and which relations its rules read.
//
//   const Result<runtime::Contract> contract = contract_of(&program, "counter");

#include "agents/runtime/contract.hpp"
#include "lisp/forms/agent_program.hpp"

namespace pizarra::scheme {

// `program` may be none: then of an agent whose file does not load. Failures: as of contract_from_text.
Result<runtime::Contract> contract_of(const forms::AgentProgram* program, const std::string& agent);

}  // namespace pizarra::scheme
