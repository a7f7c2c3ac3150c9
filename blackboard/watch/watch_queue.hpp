#pragma once

// One watched query: what each commit changes in its answers, queued for whoever watches.
//
// A watch is brought up to date from the changed facts alone: one of a single pattern needs nothing else, any other
// keeps its answers (joined_answers.hpp).
//
// Lifecycle: lagging (the reader knows nothing), sending (it is told in parts what holds), following (changes are
// queued). A queue holds at most 1024 changes, and 4 MB with those that share its backlog; when it overflows it is
// emptied, and the watch lags again.
//
//   while (queue.ready()) Result<Change> change = queue.pop();          // or pop_delta(), to send it on

#include <deque>
#include <functional>
#include <optional>

#include "blackboard/delta.hpp"
#include "blackboard/store/commit.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/watch/backlog.hpp"
#include "blackboard/watch/joined_answers.hpp"
#include "blackboard/watch/pattern_index.hpp"

namespace pizarra {

class WatchTable;

// Destroying it ends the watch.
class WatchQueue {
 public:
  WatchQueue(WatchTable& table, const Store& store, Query query, std::shared_ptr<Backlog> backlog);
  WatchQueue(const WatchQueue&) = delete;
  WatchQueue& operator=(const WatchQueue&) = delete;
  ~WatchQueue();

  bool ready() const { return state_ != State::following || !deltas_.empty(); }
  // It must be ready. A failure, too-large, means that all that holds fits no message; it stays ready. What holds comes
  // whole.
  Result<Change> pop();
  // The same, and what holds comes in parts that fit a message each.
  Result<Delta> pop_delta();
  // Forgets what is queued; the next change is a resynchronised one.
  void resynchronise();
  const Query& query() const { return query_; }
  // How many facts of the board were looked at to follow the commits.
  std::uint64_t examined() const { return joined_ ? joined_->examined() : 0; }

 private:
  friend class WatchTable;
  enum class State : std::uint8_t { lagging, sending, following };

  Result<void> begin();
  void committed(const Commit& commit);
  void committed_by_facts(const Commit& commit);
  void committed_while_sending(const Commit& commit);
  bool fits(const Fact& fact) const;
  Delta next_part();
  Result<Delta> all_answers();
  void push(Delta delta);
  void empty();

  WatchTable& table_;
  const Store& store_;
  const Query query_;
  const Datum* const only_pattern_;  // what an answer's one fact fits; null for other queries
  const bool fits_all_;              // that pattern is fitted by every fact of the relation
  std::function<void()> on_ready_;
  std::string watcher_;
  std::uint64_t number_ = 0;
  Revision touched_ = 0;  // the commit that last concerned it
  std::vector<WatchedPattern> patterns_;

  State state_ = State::lagging;
  FactId sent_up_to_ = 0;  // while sending
  Delta::Side gone_;       // while sending: what was sent and went since
  std::size_t gone_bytes_ = 0;
  std::optional<JoinedAnswers> joined_;  // unless there is only_pattern_
  struct Queued {
    Delta delta;
    std::size_t bytes;
  };
  std::deque<Queued> deltas_;
  Backlog::Share waiting_;  // what is queued, or gone
};

}  // namespace pizarra
