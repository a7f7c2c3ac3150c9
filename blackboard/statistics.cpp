#include "blackboard/statistics.hpp"

#include <algorithm>

#include "blackboard/evaluate.hpp"
#include "blackboard/store.hpp"
#include "blackboard/watches.hpp"

namespace pizarra {

namespace {

constexpr std::string_view name = "relation-stats";

Relation relation_stats() {
  Relation relation;
  relation.name = name;
  relation.arguments = {{"name", ArgumentType::symbol},        {"facts", ArgumentType::integer},
                        {"told", ArgumentType::integer},       {"gone", ArgumentType::integer},
                        {"per-second", ArgumentType::integer}, {"tellers", ArgumentType::list},
                        {"watchers", ArgumentType::list}};
  relation.key = {0};
  return relation;
}

template <class Names>
Datum counted(const Names& names) {
  std::vector<Datum> items;
  for (const auto& [who, count] : names) {
    if (items.size() < Statistics::max_names) items.push_back(list(who, count));
  }
  return Datum::list(std::move(items));
}

}  // namespace

void Statistics::Rate::pass_to(Time time) {
  const Time second = std::chrono::floor<std::chrono::seconds>(time);
  if (second == begun) return;
  before = second == begun + 1s ? now : 0;
  now = 0;
  begun = second;
}

// Most changes are of the relation that changed before.
Statistics::Counts& Statistics::counts_of(std::string_view relation) {
  if (last_ == nullptr || last_->first != relation) {
    auto found = relations_.find(relation);
    if (found == relations_.end()) found = relations_.emplace(relation, Counts()).first;
    last_ = &*found;
  }
  return last_->second;
}

void Statistics::committed(const Commit& commit) {
  for (const Commit::Entry& entry : commit.entries) {
    if (!adds(entry) && !removes(entry)) continue;
    Counts& counts = counts_of(entry.fact.datum.head());
    if (removes(entry)) {
      ++counts.gone;
      continue;
    }
    ++counts.told;
    counts.rate.pass_to(commit.when);
    ++counts.rate.now;
    auto teller = counts.tellers.find(commit.teller);
    if (teller == counts.tellers.end() && counts.tellers.size() < max_names) {
      teller = counts.tellers.emplace(commit.teller, 0).first;
    }
    if (teller != counts.tellers.end()) ++teller->second;
  }
}

bool Statistics::is_about(const Query& query) {
  return std::ranges::any_of(query.clauses, [](const Query::Clause& clause) {
    return clause.kind != Query::Clause::Kind::compare && clause.form.head() == name;
  });
}

Result<Answers> Statistics::ask(const Query& query, const Store& store, const WatchTable& watches, Time now) {
  Tables tables;
  FactTable& table = tables.try_emplace(std::string(name), relation_stats()).first->second;
  FactId id = 0;
  for (const auto& [relation, facts] : store.tables()) {
    Fact fact;
    fact.datum = fact_about(relation, facts.size(), watches, now);
    fact.id = ++id;
    fact.teller = "board";
    fact.when = now;
    fact.revision = store.revision();
    table.insert({std::move(fact)});
  }
  const Result<void> checked = check_query_on(query, tables);
  if (!checked && checked.error().symbol == "undeclared-relation") {
    return fail("bad-query", "relation-stats is asked for alone", query_to_datum(query));
  }
  if (!checked) return fail(checked);
  Result<std::vector<Answer>> answers = evaluate(query, tables);
  if (!answers) return fail(answers);
  return Answers{store.revision(), std::move(*answers)};
}

Datum Statistics::fact_about(const std::string& relation, std::size_t facts, const WatchTable& watches, Time now) {
  Counts& counts = counts_of(relation);
  counts.rate.pass_to(now);
  return list(Datum::symbol(name), Datum::symbol(relation), facts, counts.told, counts.gone, counts.rate.before,
              counted(counts.tellers), counted(watches.watchers_of(relation)));
}

}  // namespace pizarra
