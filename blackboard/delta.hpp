#pragma once

// The change that a commit makes to the answers of a watched query, or all its answers, as they are kept for a reader
// and sent to it: every answer as the facts that the query's positive patterns matched. The bindings follow from the
// query.
//
// All that holds may come in parts, facts with higher ids in each. A fact that was sent and has gone since is `removed`
// in a later part. After the last one the reader knows what holds at that part's revision.

#include <optional>
#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "lisp/pattern.hpp"

namespace pizarra {

struct Delta {
  enum class Kind : std::uint8_t { change, all, first_part, part, last_part };
  struct Side {
    std::size_t answers = 0;
    std::vector<Fact> facts;  // those of one answer after those of another
  };

  Revision revision = 0;
  Kind kind = Kind::change;
  Side added;
  Side removed;
};

// How many facts an answer of the query has.
std::size_t width_of(const Query& query);

// Says as answers what a delta says as facts.
//
//   const Answering answering(query);
//   Result<Change> change = answering.change(std::move(delta));
class Answering {
 public:
  explicit Answering(const Query& query);
  // Of facts that are as many for each answer as the query's answers have. Failure bad-frame where one does not fit.
  Result<std::vector<Answer>> answers(Delta::Side side) const;
  // The same of the whole: one that is not Kind::change resynchronises.
  Result<Change> change(Delta delta) const;

 private:
  bool match_next(std::size_t pattern, const Datum& datum, Bindings& bindings) const;

  std::vector<Datum> patterns_;
  std::optional<FlatPattern> only_;  // where there is one pattern, and it is flat
};

}  // namespace pizarra
