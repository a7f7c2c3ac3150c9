#pragma once

// What a transaction tells, for what its own retractions will look at: counted before anything is done, since nothing
// is undone.
//
//   OwnTells own;
//   own.add(fact);                                  // lives on
//   examined += own.candidates(table, pattern);     // of what was told until here
//
// They are counted as the table will find them, by the arguments that it has an index of; each is gone through once for
// each such index, of which a table has few.

#include <string_view>
#include <unordered_map>

#include "blackboard/store/fact_table.hpp"

namespace pizarra::store {

class OwnTells {
 public:
  // Of its relation's shape, and so are patterns.
  void add(const Datum& fact) { told_.push_back(&fact); }
  // As how many facts looking at one of them may count (looking.hpp).
  std::size_t heaviest();
  std::size_t candidates(const FactTable& table, const Datum& pattern);

 private:
  struct Counts {
    std::size_t counted = 0;  // of the relation's
    std::unordered_map<Datum, std::size_t> alike;
  };
  struct OfRelation {
    std::vector<const Datum*> facts;
    std::map<FactTable::Mask, Counts> by_arguments;
  };

  std::vector<const Datum*> told_;
  std::size_t weighed_ = 0;  // of these
  std::size_t heaviest_ = 1;
  std::size_t sorted_ = 0;  // of these, by relation
  std::unordered_map<std::string_view, OfRelation> relations_;
};

}  // namespace pizarra::store
