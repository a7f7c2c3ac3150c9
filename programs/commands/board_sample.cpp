#include "programs/commands/board_sample.hpp"

#include <algorithm>

#include "agents/runtime/declared.hpp"
#include "blackboard/away.hpp"
#include "lisp/reader.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration probe_lease = 5s;
const std::string probe_name = "board-probe";

// Of (relation-stats NAME FACTS TOLD GONE PER-SECOND TELLERS WATCHERS).
enum Part : std::size_t { name = 1, facts, told, gone, per_second, tellers, watchers };

Relation probe_relation() {
  return relation_from_datum(
             read_one("(relation board-probe ((who symbol) (n integer) (sent number)) (key who))").value())
      .value();
}

// Since the look before. What counts less than then was counted anew: by a board that began again, or of a teller that
// had been forgotten.
std::int64_t grown(std::int64_t now, std::int64_t before) { return now < before ? now : now - before; }

double us_since(Time from, Time to) { return static_cast<double>((to - from).count()); }

// A key's teller is called KEY or KEY/NAME.
bool is_teller(const std::string& teller, const std::string& agent) {
  return teller == agent || teller.ends_with("/" + agent);
}

Spread spread_from(const Datum& form) {
  if (form.size() != 4) return {};
  return {form[0].integer(), form[1].integer(), form[2].integer(), form[3].integer()};
}

}  // namespace

Duration commit_time(const Probe& probe) {
  return std::clamp(probe.committed, probe.sent, probe.acknowledged) - probe.sent;
}

Task<Result<std::vector<Fact>>> BoardSampler::ask_about(Datum pattern) {
  Query query = query_for(std::move(pattern));
  const Result<Answers> answers = co_await board_.ask(std::move(query));
  if (!answers) co_return fail(answers);
  revision_ = answers->revision;
  std::vector<Fact> facts;
  for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front());
  co_return facts;
}

Task<Result<std::vector<Fact>>> BoardSampler::statistics() {
  const Datum any = "?"_sym;
  Datum pattern = list("relation-stats"_sym, any, any, any, any, any, any, any);
  co_return co_await ask_about(std::move(pattern));
}

// Who may not read this sees the rest.
Task<void> BoardSampler::add_journeys(BoardSample& sample) {
  const Datum any = "?"_sym;
  Datum pattern = list("journey-stats"_sym, any, any, any);
  const Result<std::vector<Fact>> journeys = co_await ask_about(std::move(pattern));
  if (!journeys) co_return;
  for (const Fact& fact : *journeys) {
    const auto relation = std::ranges::find(sample.relations, fact.datum[1].text(), &RelationSample::name);
    if (relation == sample.relations.end()) continue;
    relation->told = spread_from(fact.datum[2]);
    relation->delivered = spread_from(fact.datum[3]);
  }
}

Task<void> BoardSampler::add_queues(BoardSample& sample) {
  const Datum any = "?"_sym;
  Datum pattern = list("watcher-stats"_sym, any, any, any, any);
  const Result<std::vector<Fact>> watchers = co_await ask_about(std::move(pattern));
  if (!watchers) co_return;
  for (const Fact& fact : *watchers) {
    const std::string watcher(fact.datum[1].text());
    for (AgentSample& agent : sample.agents) {
      if (is_teller(watcher, agent.name)) agent.queued += fact.datum[3].integer();
    }
  }
}

Task<void> BoardSampler::add_clients(BoardSample& sample) {
  const Datum any = "?"_sym;
  Datum asked = list("client-stats"_sym, any, any, any, any);
  const Result<std::vector<Fact>> clients = co_await ask_about(std::move(asked));
  std::map<std::string, ClientSample> by_name;
  if (clients) {
    for (const Fact& fact : *clients) {
      by_name[std::string(fact.datum[1].text())].requests_per_second = fact.datum[4].integer();
    }
  }
  Datum refused = list("board-refusal"_sym, any, any, any, any);
  Result<std::vector<Fact>> refusals = co_await ask_about(std::move(refused));
  if (refusals) {
    std::ranges::sort(*refusals, {}, &Fact::revision);
    for (const Fact& fact : *refusals) {
      ClientSample& client = by_name[std::string(fact.datum[1].text())];
      client.refused += fact.datum[3].integer();
      client.newest_refusal = fact.datum[4].text();
    }
  }
  for (auto& [name, client] : by_name) {
    client.name = name;
    sample.clients.push_back(std::move(client));
  }
  std::ranges::stable_sort(sample.clients, std::ranges::greater(), &ClientSample::requests_per_second);
}

BoardSampler::Counts BoardSampler::count(const std::vector<Fact>& statistics, Revision revision) const {
  Counts counts{.when = executor_.now(), .revision = revision, .told = {}, .tells = {}};
  for (const Fact& fact : statistics) {
    const std::string relation(fact.datum[name].text());
    counts.told[relation] = fact.datum[told].integer();
    for (const Datum& teller : fact.datum[tellers].items()) {
      counts.tells[{relation, std::string(teller[0].text())}] = teller[1].integer();
    }
  }
  return counts;
}

double BoardSampler::rate(std::int64_t more, const Counts& now) const {
  const double seconds = us_since(before_.when, now.when) / 1e6;
  return seconds > 0 ? static_cast<double>(more) / seconds : 0;
}

std::int64_t BoardSampler::told_since(const std::string& relation, const Counts& now) const {
  const auto before = before_.told.find(relation);
  return grown(now.told.at(relation), before == before_.told.end() ? 0 : before->second);
}

// One who was not named before is new, or there was no room for its name: then it told at most what came in all.
double BoardSampler::rate_of(const std::string& agent, const Counts& now) const {
  std::int64_t more = 0;
  for (const auto& [who, tells] : now.tells) {
    if (!is_teller(who.second, agent)) continue;
    const auto before = before_.tells.find(who);
    const std::int64_t own = grown(tells, before == before_.tells.end() ? 0 : before->second);
    more += std::min(own, told_since(who.first, now));
  }
  return rate(more, now);
}

Task<Result<void>> BoardSampler::begin() {
  const Result<std::vector<Fact>> facts = co_await statistics();
  if (!facts) co_return fail(facts);
  before_ = count(*facts, revision_);
  co_return Result<void>();
}

Task<Result<BoardSample>> BoardSampler::next() {
  const Result<std::vector<Fact>> statistics_now = co_await statistics();
  if (!statistics_now) co_return fail(statistics_now);
  const Counts now = count(*statistics_now, revision_);
  BoardSample sample{
      .revision = now.revision, .agents = {}, .agents_unknown = {}, .relations = {}, .clients = {}, .journey = {}};
  const bool went_on = now.revision > before_.revision;
  if (went_on) sample.transactions_per_second = rate(static_cast<std::int64_t>(now.revision - before_.revision), now);
  for (const Fact& fact : *statistics_now) {
    const Datum& form = fact.datum;
    RelationSample relation{.name = std::string(form[name].text()), .facts = form[facts].integer(), .tellers = {}};
    if (relation.name == probe_name) continue;
    relation.told_per_second = rate(told_since(relation.name, now), now);
    for (const Datum& teller : form[tellers].items()) relation.tellers.emplace_back(teller[0].text());
    for (const Datum& watcher : form[watchers].items()) relation.watches += watcher[1].integer();
    sample.facts += relation.facts;
    sample.relations.push_back(std::move(relation));
  }
  std::ranges::stable_sort(sample.relations, std::ranges::greater(), &RelationSample::told_per_second);
  const Result<void> agents = co_await add_agents(sample, now);
  if (!agents) co_return fail(agents);
  co_await add_journeys(sample);
  co_await add_queues(sample);
  co_await add_clients(sample);
  const Result<Journey> journey = co_await travel();
  if (journey) sample.journey = *journey;
  // What the probe did counts for nobody's next rate.
  const Result<void> begun = co_await begin();
  if (!begun) co_return fail(begun);
  co_return sample;
}

// A relation that a client declared otherwise, or tells too much of, is no reason to hide the rest.
Result<void> BoardSampler::go_without(BoardSample& sample, const Failure& failure) {
  if (is_away(failure)) return fail(failure);
  sample.agents_unknown = failure;
  return {};
}

Task<Result<void>> BoardSampler::add_agents(BoardSample& sample, const Counts& now) {
  const Datum any = "?"_sym;
  const Datum present = list("agent"_sym, any, any, any);
  const Datum waiting = list("request"_sym, any, any, any);
  const Result<std::vector<Fact>> agents = co_await runtime::facts_if_declared(board_, present);
  if (!agents) co_return go_without(sample, agents.error());
  const Result<std::vector<Fact>> requests = co_await runtime::facts_if_declared(board_, waiting);
  if (!requests) co_return go_without(sample, requests.error());
  for (const Fact& fact : *agents) {
    AgentSample agent{.name = std::string(fact.datum[1].text()),
                      .kind = std::string(fact.datum[2].text()),
                      .host = std::string(fact.datum[3].text())};
    agent.told_per_second = rate_of(agent.name, now);
    agent.waiting = std::ranges::count_if(*requests, [&](const Fact& r) { return r.datum[2] == fact.datum[1]; });
    sample.agents.push_back(std::move(agent));
  }
  std::ranges::sort(sample.agents, {}, &AgentSample::name);
  co_return Result<void>();
}

Task<Result<Journey>> BoardSampler::travel() {
  const std::vector<Relation> relations{probe_relation()};
  const Result<void> declared = co_await board_.declare(relations);
  if (!declared) co_return fail(declared);
  const Query own = query_for(list("board-probe"_sym, Datum::symbol(who_), "?n"_sym, "?sent"_sym));
  const Result<std::unique_ptr<Watch>> watch = co_await board_.watch(own);
  if (!watch) co_return fail(watch);
  const Result<Change> first = co_await (*watch)->next();
  if (!first) co_return fail(first);
  const Result<LeaseId> lease = co_await board_.lease(probe_lease);
  if (!lease) co_return fail(lease);
  const Time sent = executor_.now();
  Transaction telling;
  telling.tell(list("board-probe"_sym, Datum::symbol(who_), ++looks_, sent.time_since_epoch().count()), {}, *lease);
  const Result<Revision> told_at = co_await board_.transact(std::move(telling));
  if (!told_at) co_return fail(told_at);
  const Time acknowledged = executor_.now();
  const Result<Change> change = co_await (*watch)->next();
  if (!change) co_return fail(change);
  const Time delivered = executor_.now();
  const Result<void> released = co_await board_.release(*lease);
  if (!released) co_return fail(released);
  if (change->added.empty()) co_return fail("no-journey", "the board did not show the fact that was told");
  const Probe probe{.sent = sent, .committed = change->added.front().facts.front().when, .acknowledged = acknowledged};
  const Time committed = sent + commit_time(probe);
  co_return Journey{us_since(sent, committed), us_since(sent, acknowledged), us_since(sent, delivered)};
}

}  // namespace pizarra::programs
