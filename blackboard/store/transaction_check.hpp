#pragma once

// A transaction is checked before any of it is done. Nothing of a transaction is undone, so all that can fail fails
// here.
//
// Lifecycle: one transaction, in one call. The kept facts and the transaction outlive it.
//
//   const Result<void> checked = TransactionCheck(kept, "vision", transaction, examined).all();

#include <map>
#include <set>

#include "blackboard/board.hpp"
#include "blackboard/store/kept_facts.hpp"

namespace pizarra::store {

class TransactionCheck {
 public:
  // Adds to `examined` how many facts it looked at.
  TransactionCheck(const KeptFacts& kept, const std::string& teller, const Transaction& transaction,
                   std::size_t& examined)
      : kept_(kept), teller_(teller), transaction_(transaction), examined_(examined) {}

  Result<void> all();
  // Some relations are told by the board alone.
  static Result<void> teller(const std::string& teller, const Relation& relation);

 private:
  Result<void> precondition(const Transaction::Precondition& precondition);
  Result<void> unchanged(const FactTable& table, const Transaction::Unchanged& wanted);
  Result<void> step(const Transaction::Step& step);
  Result<void> settling(FactId taken);
  Result<void> telling(const Transaction::Tell& tell);
  Result<void> retracting(const Datum& pattern);
  // Makes the datum's relation the one that the step is about.
  Result<void> turn_to(const Datum& datum);
  // A transaction's own retractions will look at the facts that it tells: counted before anything is done.
  std::size_t looks_at_told(const Datum& pattern);

  const KeptFacts& kept_;
  const std::string& teller_;
  const Transaction& transaction_;
  std::size_t& examined_;
  const FactTable* table_ = nullptr;  // that the last step was about, as most of those after it are
  std::set<FactId> settled_;
  std::map<const FactTable*, std::size_t> told_;
  std::size_t heaviest_ = 0;  // as how many facts looking at one told may count; 0 before that was asked
};

}  // namespace pizarra::store
