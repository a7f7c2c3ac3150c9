#pragma once

// An agent's contract: what it offers, posts, reads, lets you configure and monitor, as one s-expression that the board
// shows as (contract NAME FORM).
//
//   (contract vision
//     (offers (learn (x number) (y number) (name string)) (find (name string)) (get-objects)
//             (goal (fact list) ...))                         ; `...`: the last argument repeats
//     (posts (relation learned ((name string) (area number)) (key name)) stop)    ; by name where another declares it
//     (reads frames (relation lamp ((colour symbol)) (key)))   ; whole where it may not be declared yet
//     (configures ...) (monitors ...))

#include <vector>

#include "blackboard/relation.hpp"

namespace pizarra::runtime {

struct Operation {
  std::string name;
  std::vector<Argument> arguments;
  bool repeats = false;  // the last argument may stand any number of times, none included
};

struct Contract {
  std::string kind;
  std::vector<Operation> offers;
  std::vector<Relation> posts;  // those that are given whole: the agent declares them
  std::vector<Relation> reads;  // of these, too
  std::string context = {};     // where it binds its name, within (cell); empty: where its kind does (own_name.hpp)
  Datum form;                   // as the board shows it: what it reads stands there by name
};

// A malformed contract is a bug of the agent's author; the failure says where.
Result<Contract> contract_from_text(std::string_view text);

// Whether the contract offers the operation with such arguments. Failures: unknown-operation (names the nearest),
// wrong-shape.
Result<void> check_operation(const Contract& contract, const Datum& operation);

// The relations all agents share: agent, contract, request, reply.
std::vector<Relation> runtime_relations();

}  // namespace pizarra::runtime
