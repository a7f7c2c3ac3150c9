#pragma once

// Finds the faults of a system in its contracts and its traffic.
//
//   for (const Fault& fault : faults_of(traffic)) fmt::print("{}: {}\n", fault.symbol, fault.sentence);
//
// - false-contract: an agent tells or watches a relation that its contract does not name, or is asked for an operation
//   that it does not offer.
// - never-read: a relation is told, and nobody watches it or says that it reads it.
// - never-answered: an agent was asked and did not answer.
// - does-not-scale: a fact takes longer to its readers than there is time between two.

#include "programs/method/system.hpp"

namespace pizarra::method {

struct Fault {
  std::string symbol;
  std::string subject;  // an agent or a relation
  std::string sentence;
  bool operator==(const Fault&) const = default;
};

std::vector<Fault> faults_of(const Traffic& traffic);

}  // namespace pizarra::method
