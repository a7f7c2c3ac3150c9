#include "tests/bench/crash/judge.hpp"

#include <map>

#include "blackboard/journal/journal_file.hpp"

namespace pizarra::bench {

void Judge::hear(const Report& report) {
  if (report.kind == Report::Kind::told) told_.emplace(report.writer, report.n);
  if (report.kind == Report::Kind::made) made_.emplace(report.writer, report.n);
  if (report.kind == Report::Kind::gap) ++gaps_;
}

std::size_t Judge::unmade() const {
  std::size_t unmade = 0;
  for (const Item& item : told_) unmade += made_.contains(item) ? 0 : 1;
  return unmade;
}

Result<Verdict> Judge::judge(const std::string& journal) const {
  store::Store store;
  const Result<journal::PlayedBack> read = journal::read_journal(journal, store);
  if (!read) return fail(read);
  std::map<Item, std::size_t> effects;
  std::set<Item> items;
  const auto item_of = [](const store::StandingFact& standing) {
    return Item(standing.fact.datum[1].integer(), standing.fact.datum[2].integer());
  };
  for (const store::StandingFact& standing : store.tables().at("effect").facts()) ++effects[item_of(standing)];
  for (const store::StandingFact& standing : store.tables().at("item").facts()) items.insert(item_of(standing));
  Verdict verdict;
  verdict.acknowledged = told_.size() + made_.size();
  verdict.gaps = gaps_;
  for (const Item& item : told_) verdict.lost += effects.contains(item) || items.contains(item) ? 0 : 1;
  for (const Item& item : made_) verdict.lost += effects.contains(item) ? 0 : 1;
  for (const auto& [item, count] : effects) {
    verdict.duplicated_effects += count - 1 + (items.contains(item) ? 1 : 0);
  }
  return verdict;
}

}  // namespace pizarra::bench
