#pragma once

// The board's own activity, as facts of relations that nobody tells and anybody may ask for, each alone:
//
//   (relation-stats NAME FACTS TOLD GONE PER-SECOND ((TELLER COUNT) ...) ((WATCHER COUNT) ...))
//   (reader-stats NAME ((ASKER COUNT) ...) ((TAKER COUNT) ...))
//
//   (journey-stats NAME (COUNT P50 P90 P99) (COUNT P50 P90 P99))
//   (watcher-stats WATCHER WATCHES QUEUED BYTES)
//   (client-stats CLIENT REQUESTS REFUSED PER-SECOND)
//
// FACTS stand now; TOLD and GONE count those that came and went since the board began; PER-SECOND is how many came in
// the last whole second. A watcher's count is that of its patterns that are about the relation, an asker's that
// of its questions, a taker's that of the facts it took. At most 64 tellers, 64 watchers, 64 askers and 64 takers of a
// relation are named. A new client takes the place of one that has left, or else of the one that did nothing for
// longest. The names of all relations together take 128 kB at most, each relation having the same share, so
// that every answer fits a frame. The two journeys are those of the relation's facts lately, in microseconds: from a
// teller in another process to the commit, and from the commit to watchers in other processes, as far as these report
// them (latencies.hpp). Relations without a journey are left out. QUEUED changes, of BYTES, wait for the watcher.
// REQUESTS counts those of a client in another process, REFUSED those of them that were too many, PER-SECOND how many
// came in the last whole second (client_requests.hpp).
//
//   statistics.committed(commit);
//   if (Statistics::is_about(query)) answers = statistics.ask(query, store, watches, now, examined);

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "blackboard/memory/client_requests.hpp"
#include "blackboard/memory/latencies.hpp"
#include "blackboard/query.hpp"
#include "blackboard/store/commit.hpp"

namespace pizarra::store {
class FactTable;
class Store;
}  // namespace pizarra::store

namespace pizarra::watch {
class WatchQueue;
class WatchTable;
}  // namespace pizarra::watch

namespace pizarra::memory {

class Statistics {
 public:
  static constexpr std::size_t max_names = 64;           // of one relation
  static constexpr std::size_t names_bytes = 128 << 10;  // of all

  void committed(const store::Commit& commit);
  // A question that was answered. A replay and a count have no name, and are no askers.
  void asked(std::string_view asker, const Query& query, Revision revision);
  // Under a lease or for good.
  void taken(std::string_view taker, const Datum& fact, Revision revision);
  // The client so called is gone.
  void left(std::string_view client);
  // When a fact of the relation that came to the board was sent, and how long one was under way from the board to a
  // watcher. Ignored for a relation that the board does not have, and for times longer than any journey, which come of
  // a wrong clock.
  static constexpr Duration longest_journey = 60s;
  void came(std::string_view relation, Time sent, Time now);
  void delivered(std::string_view relation, Duration took, Time now);
  ClientRequests& requests() { return requests_; }
  // Whether one of its patterns is.
  static bool is_about(const Query& query);
  // Where the query names one, by its first argument, that one is made up alone. Adds to `examined` how many of these
  // facts it looked at, and as many as could have been looked at while they were made up. Failures too-costly, and
  // bad-query where other relations are asked for too.
  Result<Answers> ask(const Query& query, const store::Store& store, const watch::WatchTable& watches, Time now,
                      std::size_t& examined);

 private:
  struct Journeys {
    Latencies to_board;
    Latencies to_watchers;
  };
  // What one client did with a relation's facts.
  struct Did {
    std::uint64_t count = 0;
    Revision newest = 0;
    bool gone = false;
    void again(Revision now);
  };
  using Clients = std::map<std::string, Did, std::less<>>;
  struct Counts {
    std::uint64_t told = 0;
    std::uint64_t gone = 0;
    Rate rate;
    Clients tellers, askers, takers;
    std::unique_ptr<Journeys> journeys;
  };
  static bool sooner_forgotten(const Did& a, const Did& b);
  static Did& did_by(Clients& clients, std::string_view client);
  static Datum named(const Clients& clients, std::size_t room);
  Counts& counts_of(std::string_view relation);
  Journeys* journeys_of(std::string_view relation);
  // What can be asked of the board at present.
  struct Asked {
    std::string about;
    std::optional<Datum> named;  // all, where there is none
    const store::Store& store;
    const watch::WatchTable& watches;
    Time now;
  };
  std::size_t looks_for(const Asked& asked) const;
  std::vector<Datum> facts_of(const Asked& asked);
  Datum relation_fact(const store::FactTable& table, const Asked& asked);
  Datum reader_fact(const store::FactTable& table, const Asked& asked);

  ClientRequests requests_;
  std::map<std::string, Counts, std::less<>> relations_;
  std::pair<const std::string, Counts>* last_ = nullptr;
};

}  // namespace pizarra::memory
