#include "blackboard/watch/watch_table.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "blackboard/limits.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/query_tables.hpp"

namespace pizarra::watch {

WatchTable::~WatchTable() { assert(size_ == 0); }

Result<std::unique_ptr<WatchQueue>> WatchTable::add(const Query& query, std::function<void()> on_ready,
                                                    std::string watcher, std::shared_ptr<Backlog> backlog,
                                                    std::size_t& examined) {
  if (query.at) return fail("bad-query", "the past can be asked for, not watched", query_to_datum(query));
  if (size_ >= limits::watches) return fail("too-large", "the board has too many watches");
  const Result<void> checked = store::check_query_on(query, store_.tables());
  if (!checked) return fail(checked);
  auto queue = std::make_unique<WatchQueue>(*this, store_, query, std::move(backlog));
  const Result<void> begun = queue->begin(examined);
  if (!begun) return fail(begun);
  queue->on_ready_ = std::move(on_ready);
  queue->watcher_ = std::move(watcher);
  enter(*queue);
  if (store::Indexing::is_awaiting()) return store::awaits_index(query_to_datum(query));
  return queue;
}

void WatchTable::enter(WatchQueue& watch) {
  watch.number_ = next_number_++;
  ++size_;
  watch.patterns_ = patterns_of(watch.query_, &watch);
  for (WatchedPattern& pattern : watch.patterns_) {
    const std::string relation(pattern.pattern.head());
    patterns_[relation].add(pattern);
    ++watchers_[relation][watch.watcher_];
  }
  queues_[watch.watcher_].insert(&watch);
}

void WatchTable::forget(const WatchQueue& watch) {
  --size_;
  for (const WatchedPattern& pattern : watch.patterns_) {
    patterns_.find(pattern.pattern.head())->second.remove(pattern);
    Watchers& watchers = watchers_.find(pattern.pattern.head())->second;
    const auto watcher = watchers.find(watch.watcher_);
    if (--watcher->second == 0) watchers.erase(watcher);
  }
  const auto queues = queues_.find(watch.watcher_);
  queues->second.erase(&watch);
  if (queues->second.empty()) queues_.erase(queues);
}

void WatchTable::committed(const store::Commit& commit) {
  std::vector<WatchQueue*> touched = touched_by(commit);
  std::ranges::sort(touched, {}, &WatchQueue::number_);
  CommitLooks looks;
  for (WatchQueue* watch : touched) watch->committed(commit, looks);
}

// Most changes are of the relation of the change before them. Beyond what may be led to, a change touches all that
// watch its relation.
std::vector<WatchQueue*> WatchTable::touched_by(const store::Commit& commit) const {
  std::vector<WatchQueue*> touched;
  const Datum* relation = nullptr;
  auto concerned = patterns_.end();
  std::size_t led_to = 0;
  std::set<const PatternIndex*> touched_whole;
  for (const store::Commit::Entry& entry : commit.entries) {
    if (!store::adds(entry) && !store::removes(entry)) continue;
    if (relation == nullptr || *relation != entry.fact.datum[0]) {
      relation = &entry.fact.datum[0];
      concerned = patterns_.find(relation->text());
    }
    if (concerned == patterns_.end()) continue;
    const PatternIndex& patterns = concerned->second;
    if (led_to <= CommitLooks::most_led_to) {
      led_to += find_touched(patterns, entry.fact, commit.revision, touched);
    } else if (touched_whole.insert(&patterns).second) {
      patterns.visit_all([&](const WatchedPattern& pattern) { touch(*pattern.watch, commit.revision, touched); });
    }
  }
  return touched;
}

std::size_t WatchTable::find_touched(const PatternIndex& patterns, const Fact& fact, Revision revision,
                                     std::vector<WatchQueue*>& touched) {
  std::size_t led_to = 0;
  patterns.visit(fact.datum, [&](const WatchedPattern& pattern) {
    ++led_to;
    if (pattern.watch->touched_ != revision && pattern.may_fit(fact.datum)) touch(*pattern.watch, revision, touched);
  });
  return led_to;
}

void WatchTable::touch(WatchQueue& watch, Revision revision, std::vector<WatchQueue*>& touched) {
  if (std::exchange(watch.touched_, revision) != revision) touched.push_back(&watch);
}

const WatchTable::Watchers& WatchTable::watchers_of(std::string_view relation) const {
  static const Watchers none;
  const auto found = watchers_.find(relation);
  return found == watchers_.end() ? none : found->second;
}

std::size_t WatchTable::watches_of(std::string_view watcher) const {
  const auto queues = queues_.find(watcher);
  return queues == queues_.end() ? 0 : queues->second.size();
}

WatchTable::Load WatchTable::load_of(const Queues& queues) {
  Load load;
  for (const WatchQueue* watch : queues) {
    ++load.watches;
    load.changes += watch->deltas_.size();
    load.bytes += watch->waiting_.bytes();
  }
  return load;
}

}  // namespace pizarra::watch
