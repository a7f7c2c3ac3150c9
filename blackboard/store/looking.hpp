#pragma once

// Counts the facts that a search has looked at, against a bound (limits::examined unless another is named). Each fact
// counts one. Where the search compared more than 16 list elements a fact, every 16 elements count one instead.
//
//   Looking looking(examined);                   // goes on from what others have looked at
//   while (looking.at_one_more()) ...            // in the end, `examined` says what all have
//   const Result<void> done = check_looking(examined, query);
//
// One that needs an index that is being made ends at once (indexing.hpp).

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/store/indexing.hpp"
#include "lisp/elements_looked_at.hpp"

namespace pizarra::store {

class Looking {
 public:
  static constexpr std::size_t elements_a_fact = 16;

  explicit Looking(std::size_t& examined, std::size_t most = limits::examined) : examined_(examined), most_(most) {}
  Looking(const Looking&) = delete;
  Looking& operator=(const Looking&) = delete;
  ~Looking() { examined_ = examined(); }

  // Whether the bound allows another fact, after what was compared so far.
  bool at_one_more() { return at_more(1); }
  // Counts work that takes as long as so many facts.
  bool at_more(std::size_t facts) {
    facts_ += facts;
    return is_allowed();
  }
  bool is_allowed() const { return examined() <= most_ && !Indexing::is_awaiting(); }
  std::size_t examined() const {
    return examined_ + std::max(facts_, (elements_looked_at - before_) / elements_a_fact);
  }

 private:
  std::size_t& examined_;
  const std::size_t most_;
  std::size_t facts_ = 0;
  const std::size_t before_ = elements_looked_at;
};

// Failure too-costly; awaits-index where it is to be done again.
Result<void> check_looking(std::size_t examined, const Datum& subject);
std::unexpected<Failure> awaits_index(const Datum& subject);

}  // namespace pizarra::store
