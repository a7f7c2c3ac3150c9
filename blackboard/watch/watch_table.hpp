#pragma once

// Watched queries, found by what a commit changes: a commit costs what it concerns, not the number of watches.
//
// A changed fact leads to patterns that it may fit, also under `not` (pattern_index.hpp). It touches the watches of
// those patterns that it does fit, unless a comparison rules it out. A commit whose facts lead to very many patterns
// touches every watch of their relations.
//
//   Result<std::unique_ptr<WatchQueue>> queue = watches.add(query, [&] { wake_reader(); });
//   watches.committed(commit);

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "blackboard/watch/watch_queue.hpp"

namespace pizarra::watch {

// It outlives its queues.
class WatchTable {
 public:
  explicit WatchTable(const store::Store& store) : store_(store) {}
  WatchTable(const WatchTable&) = delete;
  WatchTable& operator=(const WatchTable&) = delete;
  ~WatchTable();

  // The first change is queued, unless it takes long or `examined` is limits::examined_a_turn before; to that is added
  // how many facts were looked at. Failure awaits-index as of Store::ask(). `on_ready` is called whenever the queue
  // becomes ready after having been empty.
  Result<std::unique_ptr<WatchQueue>> add(const Query& query, std::function<void()> on_ready, std::string watcher,
                                          std::shared_ptr<Backlog> backlog, std::size_t& examined);
  Result<std::unique_ptr<WatchQueue>> add(const Query& query, std::function<void()> on_ready, std::string watcher = "",
                                          std::shared_ptr<Backlog> backlog = std::make_shared<Backlog>()) {
    std::size_t examined = 0;
    return add(query, std::move(on_ready), std::move(watcher), std::move(backlog), examined);
  }
  void committed(const store::Commit& commit);
  std::size_t size() const { return size_; }
  // How many patterns of whose watches are about a relation.
  using Watchers = std::map<std::string, std::size_t, std::less<>>;
  const Watchers& watchers_of(std::string_view relation) const;
  // The changes that wait for each watcher.
  struct Load {
    std::size_t watches = 0;
    std::size_t changes = 0;
    std::size_t bytes = 0;
  };
  using Queues = std::set<const WatchQueue*>;
  static Load load_of(const Queues& queues);
  using ByWatcher = std::map<std::string, Queues, std::less<>>;
  const ByWatcher& watchers() const { return queues_; }
  std::size_t watches_of(std::string_view watcher) const;

 private:
  friend class WatchQueue;
  void enter(WatchQueue& watch);
  void forget(const WatchQueue& watch);
  std::vector<WatchQueue*> touched_by(const store::Commit& commit) const;
  // Answers how many patterns the fact led to.
  static std::size_t find_touched(const PatternIndex& patterns, const Fact& fact, Revision revision,
                                  std::vector<WatchQueue*>& touched);
  static void touch(WatchQueue& watch, Revision revision, std::vector<WatchQueue*>& touched);

  const store::Store& store_;
  std::uint64_t next_number_ = 1;
  std::size_t size_ = 0;
  std::map<std::string, PatternIndex, std::less<>> patterns_;  // by relation
  std::map<std::string, Watchers, std::less<>> watchers_;      // by relation
  ByWatcher queues_;
};

}  // namespace pizarra::watch
