#pragma once

// The answers of a watched query of several patterns, kept up to date from what commits change: the answers that a fact
// brings, ends, blocks (one that a `not` fits) or frees are found from that fact on, whatever else is on the board.
//
// Of a query with a limit only the answers within it are kept. It is answered anew when one of them goes while others
// may stand outside: nobody knows which of those comes in.
//
//   JoinedAnswers answers(query, tables);
//   Result<Delta::Side> all = answers.all(examined);
//   Result<void> followed = answers.follow(commit, delta, examined);          // what is added and removed
//
// After a failure, too-large or too-costly, what is kept is worth nothing, until all() is asked for again.

#include <map>
#include <optional>
#include <vector>

#include "blackboard/delta.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/store/commit.hpp"
#include "blackboard/store/evaluate.hpp"

namespace pizarra::watch {

// Of the list around the facts of an answer, as it is written.
inline constexpr std::size_t answer_bytes = 3;

class JoinedAnswers {
 public:
  // The query has been checked on the tables, which outlive this.
  JoinedAnswers(const Query& query, const store::Tables& tables);

  // Adds to `examined` how many facts were looked at.
  Result<Delta::Side> all(std::size_t& examined);
  // The same, and goes on from so many; what else it does counts, too (commit_looks.hpp).
  Result<void> follow(const store::Commit& commit, Delta& delta, std::size_t& examined);

 private:
  using Ids = std::vector<FactId>;
  struct Rank {
    Datum value;  // what the answers are ordered by, where they are
    Ids ids;
  };
  struct Before {
    bool descending;
    bool operator()(const Rank& a, const Rank& b) const;
  };
  struct Standing {
    std::uint64_t serial;
    std::vector<Fact> facts;
  };
  using Answers = std::map<Rank, Standing, Before>;
  struct Changes {
    Answers added;
    Answers removed;
  };

  Rank rank_of(const Answer& answer) const;
  void add(Answer answer, Changes* changes);
  void remove(Answers::iterator answer, Changes& changes);
  void remove_with(FactId fact, Changes& changes, std::size_t& examined);
  void cut(Changes& changes);
  Result<void> check_allowed(std::size_t examined) const;
  std::optional<store::SearchStart> start_from(const Fact& fact, std::size_t clause) const;
  Result<std::vector<Answer>> search_from(store::SearchStart start, const std::vector<std::size_t>& course,
                                          std::size_t& examined) const;
  Result<void> find_blocked(const store::Commit& commit, Changes& changes, std::size_t& examined);
  Result<void> find_new(const store::Commit& commit, Changes& changes, std::size_t& examined);
  Result<void> answer_anew(Changes& changes, std::size_t& examined);

  const Query query_;
  const store::Tables& tables_;
  // From each clause: to the answers that a fact brings or frees, and, through no other `not`, to those it may block.
  std::vector<std::vector<std::size_t>> courses_;
  std::vector<std::vector<std::size_t>> positive_courses_;
  Answers standing_;
  std::map<std::pair<FactId, std::uint64_t>, Answers::iterator> standing_with_;  // a fact, by the answers' serials
  std::uint64_t next_serial_ = 1;
  Weight weight_;
};

}  // namespace pizarra::watch
