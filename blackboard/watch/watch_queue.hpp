#pragma once

// One watched query: what each commit changes in its answers, queued for whoever watches.
//
// A watch is brought up to date from the changed facts alone: one of a single pattern needs nothing else, any other
// keeps its answers (joined_answers.hpp).
//
// Lifecycle: lagging (the reader knows nothing), sending (it is told in parts what holds), following (changes are
// queued). A queue holds `pending_changes`, and with those that share its backlog `pending_bytes` (limits.hpp); when
// it overflows it is emptied, and the watch lags again.
//
//   while (queue.ready()) Result<Change> change = queue.pop();
//
// A server has other readers too: it looks for what holds a bounded number of facts at a time.
//
//   std::size_t examined = 0;
//   while (queue.ready() && !(queue.must_look() && examined >= limits::examined_a_turn)) {
//     Result<std::optional<Delta>> delta = queue.pop_delta(examined);
//   }

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "blackboard/delta.hpp"
#include "blackboard/store/commit.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/watch/backlog.hpp"
#include "blackboard/watch/commit_looks.hpp"
#include "blackboard/watch/joined_answers.hpp"
#include "blackboard/watch/pattern_index.hpp"

namespace pizarra::watch {

class WatchTable;

// Destroying it ends the watch.
class WatchQueue {
 public:
  WatchQueue(WatchTable& table, const store::Store& store, Query query, std::shared_ptr<Backlog> backlog);
  WatchQueue(const WatchQueue&) = delete;
  WatchQueue& operator=(const WatchQueue&) = delete;
  ~WatchQueue();

  bool ready() const { return state_ != State::following || !deltas_.empty(); }
  // It must be ready. All that holds comes as one change. Failure too-large: that does not fit a message, and the queue
  // stays ready.
  Result<Change> pop();
  // The same, and what holds comes in parts that fit a message each. It is looked for until `examined`, to which is
  // added how many facts were looked at, is limits::examined_a_turn (a join is answered whole); nothing, where no part
  // has come of it so far, or where an index is to be awaited (indexing.hpp).
  Result<std::optional<Delta>> pop_delta(std::size_t& examined);
  // Whether that looks for what holds: no change is queued.
  bool must_look() const { return state_ != State::following; }
  // Forgets what is queued; the next change is a resynchronised one.
  void resynchronise();
  const Query& query() const { return query_; }
  // How many facts could have been looked at while it followed the commits (commit_looks.hpp).
  std::uint64_t examined() const { return examined_; }

 private:
  friend class WatchTable;
  enum class State : std::uint8_t { lagging, sending, following };

  Result<void> begin(std::size_t& examined);
  void committed(const store::Commit& commit, CommitLooks& looks);
  // These answer whether the watch goes on from what it is told so.
  bool follow(const store::Commit& commit, std::size_t& examined);
  bool follow_joins(const store::Commit& commit, std::size_t& examined);
  bool follow_facts(const store::Commit& commit, std::size_t& examined);
  bool follow_while_sending(const store::Commit& commit, std::size_t& examined);
  bool fits(const Fact& fact) const;
  Delta pop_queued();
  void begin_sending();
  std::optional<Delta> next_part(std::size_t& examined);
  Delta all_parts();
  Result<Delta> all_answers(std::size_t& examined);
  void push(Delta delta);
  // False where there is no room for it.
  bool push(Delta delta, const Weight& weight);
  void empty();

  WatchTable& table_;
  const store::Store& store_;
  const Query query_;
  const Datum* const only_pattern_;  // what an answer's one fact fits; null for other queries
  const bool fits_all_;              // that pattern is fitted by every fact of the relation
  const std::size_t looks_to_fit_;   // as many facts could be looked at while one is tried
  std::function<void()> on_ready_;
  std::string watcher_;
  std::uint64_t number_ = 0;
  Revision touched_ = 0;  // the commit that last concerned it
  std::vector<WatchedPattern> patterns_;

  State state_ = State::lagging;
  // While sending:
  FactId looked_up_to_ = 0;
  bool nothing_sent_ = true;
  Delta::Side gone_;  // what was sent and went since
  std::size_t gone_bytes_ = 0;
  std::optional<JoinedAnswers> joined_;  // unless there is only_pattern_
  std::uint64_t examined_ = 0;
  store::IndexTicket awaited_ = 0;
  struct Queued {
    Delta delta;
    std::size_t bytes;
  };
  std::deque<Queued> deltas_;
  Backlog::Share waiting_;                      // what is queued, or gone
  std::unique_ptr<const Answering> answering_;  // once a change was popped as answers
};

}  // namespace pizarra::watch
