#include "blackboard/memory/statistics.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "blackboard/store/looking.hpp"
#include "blackboard/store/made_up.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/watch/watch_table.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::memory {

namespace {

// What can be asked for, and in which shape.
Relation about_relations() {
  return {.name = "relation-stats",
          .arguments = {{"name", ArgumentType::symbol},
                        {"facts", ArgumentType::integer},
                        {"told", ArgumentType::integer},
                        {"gone", ArgumentType::integer},
                        {"per-second", ArgumentType::integer},
                        {"tellers", ArgumentType::list},
                        {"watchers", ArgumentType::list}},
          .key = {0},
          .durable = false,
          .lease = {}};
}

Relation about_readers() {
  return {.name = "reader-stats",
          .arguments = {{"name", ArgumentType::symbol}, {"askers", ArgumentType::list}, {"takers", ArgumentType::list}},
          .key = {0},
          .durable = false,
          .lease = {}};
}

Relation about_journeys() {
  return {
      .name = "journey-stats",
      .arguments = {{"name", ArgumentType::symbol}, {"told", ArgumentType::list}, {"delivered", ArgumentType::list}},
      .key = {0},
      .durable = false,
      .lease = {}};
}

Relation about_watchers() {
  return {.name = "watcher-stats",
          .arguments = {{"watcher", ArgumentType::string},
                        {"watches", ArgumentType::integer},
                        {"queued", ArgumentType::integer},
                        {"bytes", ArgumentType::integer}},
          .key = {0},
          .durable = false,
          .lease = {}};
}

Relation about_clients() {
  return {.name = "client-stats",
          .arguments = {{"client", ArgumentType::string},
                        {"requests", ArgumentType::integer},
                        {"refused", ArgumentType::integer},
                        {"per-second", ArgumentType::integer}},
          .key = {0},
          .durable = false,
          .lease = {}};
}

constexpr std::array<Relation (*)(), 5> askable = {about_relations, about_readers, about_journeys, about_watchers,
                                                   about_clients};

// Which of them the query is about, first of all.
std::optional<Relation> relation_asked_for(const Query& query) {
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare || !clause.form.head().ends_with("-stats")) continue;
    for (const auto& make : askable) {
      Relation relation = make();
      if (relation.name == clause.form.head()) return relation;
    }
  }
  return std::nullopt;
}

// To say what is known of one.
constexpr std::size_t looks_a_relation = 16;

// The argument of the query's only pattern that names its subject.
std::optional<Datum> only_one_named(const Query& query) {
  const Datum* only = nullptr;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    if (only != nullptr || clause.kind == Query::Clause::Kind::absent) return std::nullopt;
    only = &clause.form;
  }
  const bool named = only != nullptr && only->size() > 1 && is_ground((*only)[1]);
  if (!named || !((*only)[1].is_symbol() || (*only)[1].is_string())) return std::nullopt;
  return (*only)[1];
}

template <class Map, class Visitor>
void visit_named(Map& map, const std::optional<Datum>& named, Visitor visitor) {
  if (!named) {
    for (auto& each : map) visitor(each);
    return;
  }
  const auto found = map.find(std::string(named->text()));
  if (found != map.end()) visitor(*found);
}

Datum summary_form(const Latencies::Summary& summary) {
  return list(summary.count, summary.p50.count(), summary.p90.count(), summary.p99.count());
}

// As many as there is room for.
template <class Names>
Datum counted(const Names& names, std::size_t room) {
  std::vector<Datum> items;
  for (const auto& [who, count] : names) {
    Datum item = list(who, count);
    const std::size_t bytes = weigh(item).bytes;
    if (bytes > room || items.size() == Statistics::max_names) break;
    room -= bytes;
    items.push_back(std::move(item));
  }
  return Datum::list(std::move(items));
}

}  // namespace

// Most commits are of the relation that changed before.
Statistics::Counts& Statistics::counts_of(std::string_view relation) {
  if (last_ == nullptr || last_->first != relation) {
    auto found = relations_.find(relation);
    if (found == relations_.end()) found = relations_.emplace(relation, Counts()).first;
    last_ = &*found;
  }
  return last_->second;
}

void Statistics::Did::again(Revision now) {
  ++count;
  newest = now;
  gone = false;
}

// Most changes are of the relation of the change before them, and all of one teller's.
void Statistics::committed(const store::Commit& commit) {
  const Datum* relation = nullptr;
  Counts* counts = nullptr;
  Did* told = nullptr;
  for (const store::Commit::Entry& entry : commit.entries) {
    if (!store::adds(entry) && !store::removes(entry)) continue;
    if (relation == nullptr || *relation != entry.fact.datum[0]) {
      relation = &entry.fact.datum[0];
      counts = &counts_of(relation->text());
      told = nullptr;
    }
    if (store::removes(entry)) {
      ++counts->gone;
      continue;
    }
    ++counts->told;
    counts->rate.count(commit.when);
    if (told == nullptr) told = &did_by(counts->tellers, commit.teller);
    told->again(commit.revision);
  }
}

void Statistics::asked(std::string_view asker, const Query& query, Revision revision) {
  if (asker.empty()) return;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    did_by(counts_of(clause.form.head()).askers, asker).again(revision);
  }
}

void Statistics::taken(std::string_view taker, const Datum& fact, Revision revision) {
  did_by(counts_of(fact.head()).takers, taker).again(revision);
}

Statistics::Did& Statistics::did_by(Clients& clients, std::string_view client) {
  const auto known = clients.find(client);
  if (known != clients.end()) return known->second;
  if (clients.size() >= max_names) {
    clients.erase(std::ranges::min_element(clients, sooner_forgotten, &Clients::value_type::second));
  }
  return clients[std::string(client)];
}

bool Statistics::sooner_forgotten(const Did& a, const Did& b) {
  return a.gone != b.gone ? a.gone : a.newest < b.newest;
}

void Statistics::left(std::string_view client) {
  for (auto& [relation, counts] : relations_) {
    for (Clients* clients : {&counts.tellers, &counts.askers, &counts.takers}) {
      const auto known = clients->find(client);
      if (known != clients->end()) known->second.gone = true;
    }
  }
}

// Those that would be forgotten first are left out first.
Datum Statistics::named(const Clients& clients, std::size_t room) {
  std::vector<const Clients::value_type*> lasting;
  for (const auto& client : clients) lasting.push_back(&client);
  std::ranges::sort(lasting, [](const auto* a, const auto* b) { return sooner_forgotten(b->second, a->second); });
  std::map<std::string, std::uint64_t> counts;
  for (const auto* client : lasting) {
    const std::size_t bytes = weigh(list(client->first, client->second.count)).bytes;
    if (bytes > room) break;
    room -= bytes;
    counts.emplace(client->first, client->second.count);
  }
  return counted(counts, std::numeric_limits<std::size_t>::max());
}

Statistics::Journeys* Statistics::journeys_of(std::string_view relation) {
  const auto found = relations_.find(relation);
  if (found == relations_.end()) return nullptr;
  std::unique_ptr<Journeys>& journeys = found->second.journeys;
  if (journeys == nullptr) journeys = std::make_unique<Journeys>();
  return journeys.get();
}

void Statistics::came(std::string_view relation, Time sent, Time now) {
  if (sent < now - longest_journey || sent > now + longest_journey) return;
  if (Journeys* journeys = journeys_of(relation)) journeys->to_board.add(now - sent, now);
}

void Statistics::delivered(std::string_view relation, Duration took, Time now) {
  if (took < -longest_journey || took > longest_journey) return;
  if (Journeys* journeys = journeys_of(relation)) journeys->to_watchers.add(took, now);
}

bool Statistics::is_about(const Query& query) { return relation_asked_for(query).has_value(); }

Result<Answers> Statistics::ask(const Query& query, const store::Store& store, const watch::WatchTable& watches,
                                Time now, std::size_t& examined) {
  const Relation about = *relation_asked_for(query);
  const Asked asked{about.name, only_one_named(query), store, watches, now};
  examined += looks_for(asked);
  const Result<void> cheap = check_examined(examined, query_to_datum(query));
  if (!cheap) return fail(cheap);
  return store::answer_from(about, facts_of(asked), query, {store.revision(), now}, examined);
}

std::size_t Statistics::looks_for(const Asked& asked) const {
  const auto& [about, named, store, watches, now] = asked;
  if (about == "client-stats") return requests_.size();
  if (about == "watcher-stats") return named ? watches.watches_of(named->text()) : watches.size();
  if (named) return looks_a_relation;
  const bool of_all_declared = about == "relation-stats" || about == "reader-stats";
  return looks_a_relation * (of_all_declared ? store.tables().size() : relations_.size());
}

std::vector<Datum> Statistics::facts_of(const Asked& asked) {
  const auto& [about, named, store, watches, now] = asked;
  std::vector<Datum> facts;
  if (about == "relation-stats") {
    visit_named(store.tables(), named, [&](const auto& table) { facts.push_back(relation_fact(table.second, asked)); });
  } else if (about == "reader-stats") {
    visit_named(store.tables(), named, [&](const auto& table) { facts.push_back(reader_fact(table.second, asked)); });
  } else if (about == "journey-stats") {
    visit_named(relations_, named, [&](auto& relation) {
      if (relation.second.journeys == nullptr) return;
      const Datum told = summary_form(relation.second.journeys->to_board.summary(asked.now));
      const Datum delivered = summary_form(relation.second.journeys->to_watchers.summary(asked.now));
      facts.push_back(list("journey-stats"_sym, Datum::symbol(relation.first), told, delivered));
    });
  } else if (about == "client-stats") {
    visit_named(requests_.clients(now), named, [&](const auto& client) {
      const ClientRequests::Asked& did = client.second;
      facts.push_back(list("client-stats"_sym, client.first, did.requests, did.refused, did.rate.last_second()));
    });
  } else {
    visit_named(watches.watchers(), named, [&](const auto& watcher) {
      const watch::WatchTable::Load load = watch::WatchTable::load_of(watcher.second);
      facts.push_back(list("watcher-stats"_sym, watcher.first, load.watches, load.changes, load.bytes));
    });
  }
  return facts;
}

Datum Statistics::relation_fact(const store::FactTable& table, const Asked& asked) {
  const std::string& relation = table.relation().name;
  Counts& counts = counts_of(relation);
  counts.rate.pass_to(asked.now);
  const std::size_t room = names_bytes / asked.store.tables().size() / 2;
  const Datum watchers = counted(asked.watches.watchers_of(relation), room);
  return list("relation-stats"_sym, Datum::symbol(relation), table.size(), counts.told, counts.gone,
              counts.rate.last_second(), named(counts.tellers, room), watchers);
}

Datum Statistics::reader_fact(const store::FactTable& table, const Asked& asked) {
  const std::string& relation = table.relation().name;
  const Counts& counts = counts_of(relation);
  const std::size_t room = names_bytes / asked.store.tables().size() / 2;
  return list("reader-stats"_sym, Datum::symbol(relation), named(counts.askers, room), named(counts.takers, room));
}

}  // namespace pizarra::memory
