#pragma once

// Watched queries: what each commit changes in their answers, queued for whoever watches.
//
// A commit touches only the watches that its facts could concern: those of the fact's relation whose patterns leave the
// key open, and those whose patterns name just that key. A watch of one positive pattern is brought up to date from the
// changed facts alone; any other is answered anew and compared.
//
// A queue holds at most 1024 changes and a frame's weight; when it overflows it is emptied, and what holds when it is
// read next comes as one resynchronised change.
//
//   Result<std::unique_ptr<WatchQueue>> queue = watches.add(query, [&] { wake_reader(); });
//   while ((*queue)->ready()) Result<Change> change = (*queue)->pop();

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "blackboard/board.hpp"
#include "blackboard/commit.hpp"
#include "blackboard/store.hpp"

namespace pizarra {

class WatchTable;

// Destroying it ends the watch.
class WatchQueue {
 public:
  WatchQueue(WatchTable& table, Query query, std::function<void()> on_ready);
  WatchQueue(const WatchQueue&) = delete;
  WatchQueue& operator=(const WatchQueue&) = delete;
  ~WatchQueue();

  bool ready() const { return lagging_ || !changes_.empty(); }
  // It must be ready. A failure, too-large, means that all that holds fits no message; it stays ready.
  Result<Change> pop();
  // Forgets what is queued; the next change is a resynchronised one.
  void resynchronise();

 private:
  friend class WatchTable;
  using AnswerKey = std::vector<FactId>;

  Result<void> begin();
  void committed(const Commit& commit);
  Change difference_by_facts(const Commit& commit) const;
  Result<Change> difference_by_answers(const Commit& commit);
  Result<std::vector<Answer>> answers_now();
  void push(Change change);

  WatchTable& table_;
  const Query query_;
  const bool by_facts_;
  std::function<void()> on_ready_;
  std::uint64_t number_ = 0;
  std::map<AnswerKey, Answer> standing_;  // unless by_facts_
  struct Queued {
    Change change;
    std::size_t bytes;
  };
  std::deque<Queued> changes_;
  std::size_t queued_bytes_ = 0;
  bool lagging_ = false;
};

// It outlives its queues.
class WatchTable {
 public:
  explicit WatchTable(const Store& store) : store_(store) {}
  WatchTable(const WatchTable&) = delete;
  WatchTable& operator=(const WatchTable&) = delete;
  ~WatchTable();

  // The first change is queued; `on_ready` is called whenever the queue becomes ready after having been empty.
  Result<std::unique_ptr<WatchQueue>> add(const Query& query, std::function<void()> on_ready);
  void committed(const Commit& commit);

 private:
  friend class WatchQueue;
  // By relation, then by key; an empty list stands for patterns that leave the key open.
  using Interest = std::pair<std::string, Datum>;

  std::vector<Interest> interests_of(const Query& query) const;
  void collect(const Interest& interest, std::map<std::uint64_t, WatchQueue*>& into) const;

  const Store& store_;
  std::uint64_t next_number_ = 1;
  std::map<std::uint64_t, WatchQueue*> watches_;
  std::map<Interest, std::set<std::uint64_t>> interested_;
};

}  // namespace pizarra
