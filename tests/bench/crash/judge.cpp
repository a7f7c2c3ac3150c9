#include "tests/bench/crash/judge.hpp"

#include "blackboard/store/durable_facts.hpp"

namespace pizarra::bench {

namespace {

// A relation's facts, (NAME A B ...), by A and B: those too that somebody has taken and not settled.
std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> counted(const store::Store& store,
                                                                     std::string_view relation) {
  std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> counts;
  for (const auto& [fact, as] : store::durable_facts(store)) {
    if (fact.datum.head() == relation) ++counts[{fact.datum[1].integer(), fact.datum[2].integer()}];
  }
  return counts;
}

}  // namespace

void Judge::hear(const Report& report) {
  using Kind = Report::Kind;
  if (report.kind == Kind::told) told_.emplace(report.writer, report.n);
  if (report.kind == Kind::made) made_.emplace(report.writer, report.n);
  if (report.kind == Kind::got) ++got_[{report.writer, report.n}];
  if (report.kind == Kind::gap) ++gaps_;
  if (report.kind == Kind::called || report.kind == Kind::answered) {
    registers_[report.writer][report.n] = report.operation;
  }
}

std::size_t Judge::unmade() const {
  std::size_t unmade = 0;
  for (const Item& item : told_) unmade += made_.contains(item) ? 0 : 1;
  return unmade;
}

Verdict Judge::judge(const store::Store& end) const {
  const std::map<Item, std::size_t> effects = counted(end, "effect");
  const std::map<Item, std::size_t> items = counted(end, "item");
  const std::map<Item, std::size_t> tokens = counted(end, "token");
  Verdict verdict;
  verdict.acknowledged = told_.size() + made_.size() + got_.size();
  verdict.gaps = gaps_;
  for (const Item& item : told_) verdict.lost += effects.contains(item) || items.contains(item) ? 0 : 1;
  for (const Item& item : made_) verdict.lost += effects.contains(item) ? 0 : 1;
  for (const auto& [item, count] : effects) {
    verdict.duplicated_effects += count - 1 + (items.contains(item) ? 1 : 0);
  }
  for (const auto& [token, count] : got_) {
    verdict.duplicated_effects += count - 1 + (tokens.contains(token) ? 1 : 0);
  }
  judge_registers(end, verdict);
  return verdict;
}

void Judge::judge_registers(const store::Store& end, Verdict& verdict) const {
  std::map<std::int64_t, std::int64_t> last;
  for (const auto& [fact, count] : counted(end, "register")) last.insert(fact);
  for (const auto& [key, operations] : registers_) {
    std::vector<Operation> history;
    std::int64_t latest = 0;
    for (const auto& [n, operation] : operations) {
      history.push_back(operation);
      latest = std::max(latest, operation.called);
      if (operation.answered != Operation::never) latest = std::max(latest, operation.answered);
    }
    // Everybody has gone, and the journal is asked.
    history.push_back({.value = last.contains(key) ? last.at(key) : 0, .called = latest + 1, .answered = latest + 2});
    verdict.operations += operations.size();
    if (is_linearizable(history)) continue;
    ++verdict.not_linearizable;
    verdict.unexplained += "register " + std::to_string(key) + ":\n" + describe(history);
  }
}

}  // namespace pizarra::bench
