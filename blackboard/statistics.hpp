#pragma once

// What goes on on a board, as facts of a relation that nobody tells and anybody may ask for, alone:
//
//   (relation-stats NAME FACTS TOLD GONE PER-SECOND ((TELLER COUNT) ...) ((WATCHER COUNT) ...))
//
// FACTS stand now; TOLD and GONE count those that came and went since the board began; PER-SECOND is how many came in
// the last whole second. A watcher's count is that of its patterns that are about the relation. At most 64 of each are
// named.
//
//   statistics.committed(commit);
//   if (Statistics::is_about(query)) answers = statistics.ask(query, store, watches, now);

#include <map>
#include <string>

#include "blackboard/commit.hpp"
#include "blackboard/query.hpp"

namespace pizarra {

class Store;
class WatchTable;

class Statistics {
 public:
  static constexpr std::size_t max_names = 64;  // of one relation

  void committed(const Commit& commit);
  // Whether one of its patterns is.
  static bool is_about(const Query& query);
  // Failure bad-query where other relations are asked for too.
  Result<Answers> ask(const Query& query, const Store& store, const WatchTable& watches, Time now);

 private:
  // Counts by the second.
  struct Rate {
    Time begun{};
    std::uint64_t now = 0;
    std::uint64_t before = 0;
    void pass_to(Time time);
  };
  struct Counts {
    std::uint64_t told = 0;
    std::uint64_t gone = 0;
    Rate rate;
    std::map<std::string, std::uint64_t, std::less<>> tellers;
  };
  Counts& counts_of(std::string_view relation);
  Datum fact_about(const std::string& relation, std::size_t facts, const WatchTable& watches, Time now);

  std::map<std::string, Counts, std::less<>> relations_;
  std::pair<const std::string, Counts>* last_ = nullptr;
};

}  // namespace pizarra
