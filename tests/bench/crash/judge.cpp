#include "tests/bench/crash/judge.hpp"

#include <map>

#include "blackboard/journal_file.hpp"

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
  Store store;
  const Result<PlayedBack> read = read_journal(journal, store);
  if (!read) return fail(read);
  std::map<Item, std::size_t> effects;
  std::set<Item> items;
  const auto item_of = [](const FactTable::Entry& entry) {
    return Item(entry.fact.datum[1].integer(), entry.fact.datum[2].integer());
  };
  for (const auto& [id, entry] : store.tables().at("effect").entries()) ++effects[item_of(entry)];
  for (const auto& [id, entry] : store.tables().at("item").entries()) items.insert(item_of(entry));
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
