#pragma once

// A Store checks a transaction before it does any of it. Nothing of a transaction is undone, so all that can fail fails
// here.
//
// Lifecycle: one transaction, in one call. The store and the transaction outlive it.
//
//   const Result<void> checked = Store::Check(store, "vision", transaction, examined).all();

#include <map>
#include <set>

#include "blackboard/store/store.hpp"

namespace pizarra::store {

class Store::Check {
 public:
  // Adds to `examined` how many facts it looked at.
  Check(const Store& store, const std::string& teller, const Transaction& transaction, std::size_t& examined)
      : store_(store), teller_(teller), transaction_(transaction), examined_(examined) {}

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

  const Store& store_;
  const std::string& teller_;
  const Transaction& transaction_;
  std::size_t& examined_;
  const FactTable* table_ = nullptr;  // that the last step was about, as most of those after it are
  std::set<FactId> settled_;
  std::map<const FactTable*, std::size_t> told_;
  std::size_t heaviest_ = 0;  // as how many facts looking at one told may count; 0 before that was asked
};

}  // namespace pizarra::store
