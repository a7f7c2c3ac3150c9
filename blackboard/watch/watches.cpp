#include "blackboard/watch/watches.hpp"

#include <algorithm>
#include <cassert>

#include "blackboard/limits.hpp"
#include "blackboard/store/evaluate.hpp"
#include "lisp/pattern.hpp"

namespace pizarra {

namespace {

// Those that are about relations.
template <class Clauses, class Visitor>
void for_patterns(const Clauses& clauses, Visitor&& visitor) {
  for (const Query::Clause& clause : clauses) {
    if (clause.kind != Query::Clause::Kind::compare) visitor(clause.form);
  }
}

}  // namespace

WatchTable::~WatchTable() { assert(size_ == 0); }

Result<std::unique_ptr<WatchQueue>> WatchTable::add(const Query& query, std::function<void()> on_ready,
                                                    std::string watcher, std::shared_ptr<Backlog> backlog) {
  if (query.at) return fail("bad-query", "what was cannot be watched, only asked", query_to_datum(query));
  if (size_ >= limits::watches) return fail("too-large", "the board has too many watches");
  const Result<void> checked = check_query_on(query, store_.tables());
  if (!checked) return fail(checked);
  auto queue = std::make_unique<WatchQueue>(*this, store_, query, std::move(backlog));
  const Result<void> begun = queue->begin();
  if (!begun) return fail(begun);
  queue->on_ready_ = std::move(on_ready);
  queue->watcher_ = std::move(watcher);
  enter(*queue);
  return queue;
}

void WatchTable::enter(WatchQueue& watch) {
  watch.number_ = next_number_++;
  ++size_;
  for_patterns(watch.query_.clauses, [&](const Datum& pattern) {
    Concerned& relation = relations_[std::string(pattern.head())];
    file_for(relation, pattern).push_back({&watch, &pattern});
  });
}

WatchTable::File& WatchTable::file_for(Concerned& relation, const Datum& pattern) {
  std::size_t best = 0;
  std::size_t fewest = 0;
  for (std::size_t place = 1; place < pattern.size(); ++place) {
    if (!is_ground(pattern[place])) continue;
    const Files& files = relation.by_argument[place];
    const auto found = files.find(pattern[place]);
    const std::size_t others = found == files.end() ? 0 : found->second.size();
    if (best != 0 && others >= fewest) continue;
    best = place;
    fewest = others;
  }
  return best == 0 ? relation.all : relation.by_argument[best][pattern[best]];
}

void WatchTable::forget(const WatchQueue& watch) {
  --size_;
  const auto is_of_watch = [&](const Filed& filed) { return filed.watch == &watch; };
  for_patterns(watch.query_.clauses, [&](const Datum& pattern) {
    Concerned& relation = relations_.find(pattern.head())->second;
    std::erase_if(relation.all, is_of_watch);
    for (auto& [place, files] : relation.by_argument) {
      const auto found = files.find(pattern[place]);
      if (found == files.end()) continue;
      std::erase_if(found->second, is_of_watch);
      if (found->second.empty()) files.erase(found);
    }
    std::erase_if(relation.by_argument, [](const auto& files) { return files.second.empty(); });
  });
}

// Most changes are of the relation of the change before them.
void WatchTable::committed(const Commit& commit) {
  std::vector<WatchQueue*> touched;
  const Datum* relation = nullptr;
  auto concerned = relations_.end();
  for (const Commit::Entry& entry : commit.entries) {
    if (!adds(entry) && !removes(entry)) continue;
    if (relation == nullptr || *relation != entry.fact.datum[0]) {
      relation = &entry.fact.datum[0];
      concerned = relations_.find(relation->text());
    }
    if (concerned != relations_.end()) find_touched(concerned->second, entry.fact, commit.revision, touched);
  }
  std::ranges::sort(touched, {}, &WatchQueue::number_);
  for (WatchQueue* watch : touched) watch->committed(commit);
}

void WatchTable::find_touched(const Concerned& relation, const Fact& fact, Revision revision,
                              std::vector<WatchQueue*>& touched) {
  const auto look_through = [&](const File& file) {
    for (const Filed& filed : file) {
      if (filed.watch->touched_ == revision || !resembles(*filed.pattern, fact.datum)) continue;
      filed.watch->touched_ = revision;
      touched.push_back(filed.watch);
    }
  };
  look_through(relation.all);
  for (const auto& [place, files] : relation.by_argument) {
    const auto file = files.find(fact.datum[place]);
    if (file != files.end()) look_through(file->second);
  }
}

template <class Visitor>
void WatchTable::visit(const Concerned& relation, Visitor&& visitor) {
  for (const Filed& filed : relation.all) visitor(*filed.watch);
  for (const auto& [place, files] : relation.by_argument) {
    for (const auto& [value, file] : files) {
      for (const Filed& filed : file) visitor(*filed.watch);
    }
  }
}

std::map<std::string, std::size_t> WatchTable::watchers_of(std::string_view relation) const {
  std::map<std::string, std::size_t> watchers;
  const auto found = relations_.find(relation);
  if (found == relations_.end()) return watchers;
  visit(found->second, [&](const WatchQueue& watch) { ++watchers[watch.watcher_]; });
  return watchers;
}

std::map<std::string, WatchTable::Load> WatchTable::loads() const {
  // One watch may be filed under several patterns.
  std::map<std::uint64_t, const WatchQueue*> watches;
  for (const auto& [name, relation] : relations_) {
    visit(relation, [&](const WatchQueue& watch) { watches.emplace(watch.number_, &watch); });
  }
  std::map<std::string, Load> loads;
  for (const auto& [number, watch] : watches) {
    Load& load = loads[watch->watcher_];
    ++load.watches;
    load.changes += watch->deltas_.size();
    load.bytes += watch->waiting_.bytes();
  }
  return loads;
}

}  // namespace pizarra
