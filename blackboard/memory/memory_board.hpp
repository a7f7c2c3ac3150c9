#pragma once

// The wall in this process: one store, its watches and its lease timers, and a view for every teller.
//
//   MemoryBoard board(executor);
//   std::unique_ptr<Board> vision = board.view("vision");
//   board.set_journal([&](std::string_view line) { file << line << '\n'; });
//
// It outlives its views and their watches. The calls that name a teller are the same operations without the wait; the
// ZeroMQ server answers its clients with them, so that agents of this process and of others may share one board.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "blackboard/memory/statistics.hpp"
#include "blackboard/store/commit.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/watch/backlog.hpp"

namespace pizarra::store {
class FactTable;
class Store;
}  // namespace pizarra::store

namespace pizarra::watch {
class WatchQueue;
class WatchTable;
}  // namespace pizarra::watch

namespace pizarra::memory {

class MemoryBoard {
 public:
  explicit MemoryBoard(Executor& executor);
  // Goes on from what a journal restored, with resume() before anybody comes.
  MemoryBoard(Executor& executor, std::unique_ptr<store::Store> store);
  MemoryBoard(const MemoryBoard&) = delete;
  MemoryBoard& operator=(const MemoryBoard&) = delete;
  ~MemoryBoard();

  // Held by whoever brings the board messages of others. While it lives, a lease lapses only when every message that
  // had come by then was heard. `until` answers up to which time that is so, later each time while messages are read.
  class Hearing {
   public:
    Hearing(MemoryBoard& board, std::function<Time()> until);
    Hearing(const Hearing&) = delete;
    Hearing& operator=(const Hearing&) = delete;
    ~Hearing();

   private:
    friend class MemoryBoard;
    MemoryBoard& board_;
    const std::function<Time()> until_;
  };

  std::unique_ptr<Board> view(std::string teller);

  // Calls `sink` with every declaration and committed transaction from now on; beforehand with what was declared so
  // far.
  void set_journal(store::JournalSink sink);
  // The same, of declarations and durable facts alone: for a log in which each entry is costly. A board may have both.
  void set_journal_of_durable(store::JournalSink sink);
  // Removes what is not durable and puts back what was taken. Set the journal before, since it records both.
  void resume();

  Executor& executor() { return executor_; }
  const store::Store& store() const { return *store_; }
  Statistics& statistics() { return statistics_; }

  Result<void> declare(const std::string& teller, const std::vector<Relation>& relations);
  // These add to `examined` how many facts they looked at, and fail beyond limits::examined.
  Result<Revision> transact(const std::string& teller, const Transaction& transaction, std::size_t& examined);
  // `asker` is who will be named in what reader-stats says; nobody where it is empty.
  Result<Answers> ask(const Query& query, std::size_t& examined, std::string_view asker = {});
  Result<std::optional<Fact>> take(const std::string& teller, const Datum& pattern, LeaseId holder,
                                   std::size_t& examined);
  Result<LeaseId> lease(Duration length);
  Result<void> renew(LeaseId lease);
  Result<void> release(LeaseId lease);
  // Adds to `examined` as many facts as could have been looked at meanwhile.
  Result<void> release(LeaseId lease, std::size_t& examined);
  // The queue's first change is there already, unless it takes long or `examined` is limits::examined_a_turn before;
  // `ready` is called whenever one comes to an empty queue. `watcher` is who will be named in what relation-stats says
  // (statistics.hpp); its queues may share a backlog.
  Result<std::unique_ptr<watch::WatchQueue>> watch(const std::string& watcher, const Query& query,
                                                   std::function<void()> ready, std::shared_ptr<watch::Backlog> backlog,
                                                   std::size_t& examined);
  // The same for callers in this process that need no count.
  Result<Revision> transact(const std::string& teller, const Transaction& transaction);
  Result<Answers> ask(const Query& query, std::string_view asker = {});
  Result<std::optional<Fact>> take(const std::string& teller, const Datum& pattern, LeaseId holder);
  Result<std::unique_ptr<watch::WatchQueue>> watch(const std::string& watcher, const Query& query,
                                                   std::function<void()> ready);

 private:
  // begin(): before an operation, lapses what is due. schedule(): after it, sets the timer. Of the facts that lapse
  // together only a part is removed at a time, however many operations there are. The next part follows after a pause.
  Time begin();
  void schedule();
  template <class Lapse>
  void lapse(Time now, Lapse&& some);
  Time heard_until(Time now) const;
  void committed(const store::Commit& commit);
  void journal_declared(const store::JournalSink& sink) const;

  Executor& executor_;
  std::unique_ptr<store::Store> store_;
  std::unique_ptr<watch::WatchTable> watches_;
  Statistics statistics_;
  std::vector<const Hearing*> hearings_;
  store::JournalSink journal_;
  store::JournalSink durable_journal_;
  Executor::TimerId timer_ = 0;
  std::optional<Time> timer_due_;
  std::size_t may_lapse_;  // of what store::Lapsing::expire counts, before
  Time lapses_again_{};    // then there is to be as much as ever
};

}  // namespace pizarra::memory
