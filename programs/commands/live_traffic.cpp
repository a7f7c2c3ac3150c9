#include "programs/commands/live_traffic.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/runtime/contract.hpp"
#include "agents/runtime/declared.hpp"
#include "blackboard/streams/remote_streams.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::programs {

namespace {

constexpr std::size_t sampled = 20;  // facts of a relation, for their size
constexpr int probes_each = 30;
constexpr Duration images_look = 1s;
const Datum whatever = "?"_sym;

Relation probe_relation() {
  return relation_from_datum(read_one("(relation method-probe ((who symbol) (n integer)) (key who))").value()).value();
}

// Of (relation-stats NAME FACTS TOLD GONE PER-SECOND TELLERS WATCHERS) and (reader-stats NAME ASKERS TAKERS).
enum Part : std::size_t { relation_name = 1, its_tellers = 6, its_watchers = 7, its_askers = 2, its_takers = 3 };

// Of ((CLIENT COUNT) ...), by agent.
std::map<std::string, std::int64_t> counts_in(const Datum& clients) {
  std::map<std::string, std::int64_t> counts;
  for (const Datum& client : clients.items()) {
    counts[method::agent_of_teller(std::string(client[0].text()))] += client[1].integer();
  }
  return counts;
}

// What has come of one client since then. Who was forgotten meanwhile began anew.
std::int64_t more_than(const std::map<std::string, std::map<std::string, std::int64_t>>& before,
                       const std::string& relation, const std::string& client, std::int64_t count) {
  const auto known = before.find(relation);
  if (known == before.end()) return count;
  const auto earlier = known->second.find(client);
  return earlier == known->second.end() || earlier->second > count ? count : count - earlier->second;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

double ms_of(Duration duration) { return static_cast<double>(duration.count()) / 1000; }

}  // namespace

Task<void> LiveLook::collect(Query query) {
  const Result<std::unique_ptr<Watch>> watch = co_await board_.watch(std::move(query));
  while (watch) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    for (const Answer& answer : change->added) {
      if (!cut()) seen_.push_back(answer.facts.front());
    }
  }
}

// A board of an older version says nothing of who asks and takes.
Task<Result<LiveLook::SoFar>> LiveLook::so_far(method::Traffic* with_readers) {
  Datum pattern = list("relation-stats"_sym, whatever, whatever, whatever, whatever, whatever, whatever, whatever);
  const Result<std::vector<Fact>> statistics = co_await board_.facts(std::move(pattern));
  if (!statistics) co_return fail(statistics);
  Datum reading = list("reader-stats"_sym, whatever, whatever, whatever);
  const Result<std::vector<Fact>> readers = co_await board_.facts(std::move(reading));
  SoFar counts;
  for (const Fact& fact : *statistics) {
    const std::string relation(fact.datum[relation_name].text());
    counts.told[relation] = counts_in(fact.datum[its_tellers]);
    if (with_readers == nullptr) continue;
    for (const auto& [watcher, patterns] : counts_in(fact.datum[its_watchers])) {
      if (!watcher.starts_with(names_begin)) with_readers->flows[relation].watchers.insert(watcher);
    }
  }
  for (const Fact& fact : readers.value_or(std::vector<Fact>())) {
    const std::string relation(fact.datum[relation_name].text());
    counts.taken[relation] = counts_in(fact.datum[its_takers]);
    if (with_readers == nullptr) continue;
    for (const auto& [asker, questions] : counts_in(fact.datum[its_askers])) {
      if (!asker.starts_with(names_begin)) with_readers->flows[relation].askers.insert(asker);
    }
  }
  co_return counts;
}

Task<Result<void>> LiveLook::see_agents(method::Traffic& traffic) {
  const Datum agents = list("agent"_sym, whatever, whatever, whatever);
  const Datum contracts = list("contract"_sym, whatever, whatever);
  for (const Datum* pattern : {&agents, &contracts}) {
    const Result<std::vector<Fact>> facts = co_await runtime::facts_if_declared(board_, *pattern);
    if (!facts) co_return fail(facts);
    for (const Fact& fact : *facts) method::see_agent(traffic, fact.datum);
  }
  co_return Result<void>();
}

// Who may not read this sees the rest.
Task<void> LiveLook::see_journeys(method::Traffic& traffic) {
  Datum pattern = list("journey-stats"_sym, whatever, whatever, whatever);
  const Result<std::vector<Fact>> journeys = co_await board_.facts(std::move(pattern));
  if (!journeys) co_return;
  for (const Fact& fact : *journeys) {
    const auto flow = traffic.flows.find(std::string(fact.datum[1].text()));
    if (flow == traffic.flows.end() || fact.datum[3].size() != 4) continue;
    flow->second.delivered_p50_ms = static_cast<double>(fact.datum[3][1].integer()) / 1000;
    flow->second.delivered_p99_ms = static_cast<double>(fact.datum[3][3].integer()) / 1000;
  }
}

// By what stands of each relation that a contract describes.
Task<void> LiveLook::see_sizes(method::Traffic& traffic) {
  std::map<std::string, std::size_t> arguments;
  for (const auto& [name, agent] : traffic.agents) {
    for (const Datum& part : agent.contract.items()) {
      if (!part.is_form("posts")) continue;
      for (const Datum& form : part.items().subspan(1)) {
        const Result<Relation> relation = relation_from_datum(form);
        if (relation) arguments[relation->name] = relation->arguments.size();
      }
    }
  }
  for (auto& [relation, flow] : traffic.flows) {
    const auto known = arguments.find(relation);
    if (known == arguments.end()) continue;
    std::vector<Datum> items(known->second + 1, whatever);
    items.front() = Datum::symbol(relation);
    Query query = query_for(Datum::list(std::move(items)));
    query.limit = sampled;
    const Result<Answers> answers = co_await board_.ask(std::move(query));
    if (!answers || answers->answers.empty()) continue;
    double sum = 0;
    for (const Answer& answer : answers->answers) {
      sum += static_cast<double>(write(answer.facts.front().datum).size());
    }
    flow.mean_bytes = sum / static_cast<double>(answers->answers.size());
  }
}

// Streams are announced on the board; what their images weigh, and how often they come, is seen by taking them.
Task<void> LiveLook::see_images(method::Traffic& traffic) {
  const Result<std::vector<Fact>> announced =
      co_await runtime::facts_if_declared(board_, list("stream"_sym, whatever, whatever, whatever));
  if (!announced || announced->empty()) co_return;
  const auto streams = streams::RemoteStreams::open(executor_, board_);
  if (!streams) co_return;
  std::vector<std::unique_ptr<Streams::Subscription>> subscriptions;
  for (const Fact& fact : *announced) {
    method::see_stream(traffic, fact);
    const std::string name(fact.datum[1].text());
    method::ImagesSeen& images = traffic.streams[name];
    subscriptions.push_back((*streams)->subscribe(name, [&images](const StreamFrame& frame) {
      images.bytes = static_cast<double>(frame.image->pixels.size());
      ++images.per_second;
    }));
  }
  co_await sleep(executor_, images_look);
  subscriptions.clear();
  for (auto& [name, images] : traffic.streams) images.per_second *= 1000 / ms_of(images_look);
}

// The median time until the last of so many has a fact; nothing where this client may not tell or watch it.
Task<std::optional<double>> LiveLook::time_to(std::size_t subscribers) {
  std::vector<std::unique_ptr<Board>> boards;
  std::vector<std::unique_ptr<Watch>> watches;
  const Datum who = Datum::symbol(name_);
  for (std::size_t i = 0; i < subscribers; ++i) {
    Result<std::unique_ptr<Board>> board = connect_(fmt::format("{}-{}", name_, i + 1));
    if (!board) co_return std::nullopt;
    const Query probes = query_for(list("method-probe"_sym, who, whatever));
    Result<std::unique_ptr<Watch>> watch = co_await (*board)->watch(probes);
    if (!watch) co_return std::nullopt;
    const Result<Change> standing = co_await (*watch)->next();
    if (!standing) co_return std::nullopt;
    boards.push_back(std::move(*board));
    watches.push_back(std::move(*watch));
  }
  std::vector<double> took_ms;
  for (int i = 0; i < probes_each; ++i) {
    const Time begun = executor_.now();
    const Datum probe = list("method-probe"_sym, who, ++probes_);
    const Result<Revision> told = co_await board_.tell(probe);
    if (!told) co_return std::nullopt;
    for (const std::unique_ptr<Watch>& watch : watches) {
      const Result<Change> come = co_await watch->next();
      if (!come) co_return std::nullopt;
      if (!come->added.empty()) board_time_ = come->added.front().facts.front().when;
    }
    took_ms.push_back(ms_of(executor_.now() - begun));
  }
  co_return median(std::move(took_ms));
}

Task<void> LiveLook::measure_scales(method::Traffic& traffic) {
  const std::vector<Relation> relations(1, probe_relation());
  const Result<void> declared = co_await board_.declare(relations);
  if (!declared) co_return;
  for (const std::size_t subscribers : {1, 2, 4, 8, 16}) {
    const std::optional<double> took = co_await time_to(subscribers);
    if (!took) break;
    traffic.scales.push_back({subscribers, *took});
  }
  const Datum all = list("method-probe"_sym, Datum::symbol(name_), whatever);
  [[maybe_unused]] const Result<Revision> retracted = co_await board_.retract(all);
}

Task<Result<method::Traffic>> LiveLook::at(Duration duration) {
  std::vector<Relation> shared = runtime::runtime_relations();
  const Result<void> declared = co_await board_.declare(std::move(shared));
  if (!declared) co_return fail(declared);
  const Result<SoFar> before = co_await so_far(nullptr);
  if (!before) co_return fail(before);
  const Time begun = executor_.now();
  const Query requests = query_for(list("request"_sym, whatever, whatever, whatever));
  const Query replies = query_for(list("reply"_sym, whatever, whatever));
  Job asking = executor_.spawn(collect(requests));
  Job answering = executor_.spawn(collect(replies));
  co_await sleep(executor_, duration);
  method::Traffic traffic;
  traffic.watches_seen = true;
  traffic.seconds = ms_of(executor_.now() - begun) / 1000;
  const Result<SoFar> after = co_await so_far(&traffic);
  if (!after) co_return fail(after);
  asking = Job();
  answering = Job();
  for (const auto& [relation, tellers] : after->told) {
    for (const auto& [teller, count] : tellers) {
      const std::int64_t more = more_than(before->told, relation, teller, count);
      if (more > 0) traffic.flows[relation].told[teller] = static_cast<std::size_t>(more);
    }
  }
  for (const auto& [relation, takers] : after->taken) {
    for (const auto& [taker, count] : takers) {
      const std::int64_t more = more_than(before->taken, relation, taker, count);
      if (more > 0) traffic.flows[relation].taken[taker] = static_cast<std::size_t>(more);
    }
  }
  const Result<void> agents = co_await see_agents(traffic);
  if (!agents) co_return fail(agents);
  co_await see_journeys(traffic);
  co_await see_sizes(traffic);
  co_await see_images(traffic);
  co_await measure_scales(traffic);
  std::ranges::stable_sort(seen_, {}, &Fact::revision);
  method::ExchangeCounter exchanges(traffic);
  for (const Fact& fact : seen_) {
    exchanges.see(fact);
    board_time_ = std::max(board_time_, fact.when);
  }
  exchanges.end(board_time_);
  co_return traffic;
}

}  // namespace pizarra::programs
