#include "programs/method/journal_traffic.hpp"

#include <algorithm>

#include "blackboard/journal/journal.hpp"
#include "lisp/writer.hpp"

namespace pizarra::method {

namespace {

double ms_between(Time from, Time to) { return static_cast<double>((to - from).count()) / 1000; }

bool is_misfit(const Datum& result) {
  return result.is_form("fail") && result.size() > 1 &&
         (result[1].is_symbol("unknown-operation") || result[1].is_symbol("wrong-shape"));
}

// Sums of bytes, by relation, until the journal is over.
using Bytes = std::map<std::string, std::pair<double, std::size_t>>;

void see_told(const Fact& fact, Traffic& traffic, ExchangeCounter& exchanges, Bytes& bytes) {
  if (see_agent(traffic, fact.datum)) return;
  see_stream(traffic, fact);
  exchanges.see(fact);
  const std::string relation(fact.datum.head());
  ++traffic.flows[relation].told[agent_of_teller(fact.teller)];
  auto& [sum, count] = bytes[relation];
  sum += static_cast<double>(write(fact.datum).size());
  ++count;
}

// By fact: of one that is taken a journal says the id alone.
using Relations = std::map<FactId, std::string>;

void see_taken(const store::Commit::Entry& entry, const std::string& teller, Traffic& traffic, Relations& relations) {
  using Kind = store::Commit::Entry::Kind;
  if (entry.kind == Kind::told) relations[entry.fact.id] = entry.fact.datum.head();
  if (entry.kind == Kind::returned) relations[entry.fact.id] = relations[entry.former];
  if (entry.kind == Kind::taken) ++traffic.flows[relations[entry.fact.id]].taken[agent_of_teller(teller)];
}

}  // namespace

std::string agent_of_teller(const std::string& teller) { return teller.substr(teller.rfind('/') + 1); }

bool see_agent(Traffic& traffic, const Datum& fact) {
  if (fact.is_form("agent") && fact.size() == 4 && !is_visitor(std::string(fact[2].text()))) {
    traffic.agents[std::string(fact[1].text())].kind = fact[2].text();
  }
  if (fact.is_form("contract") && fact.size() == 3 && fact[2].size() > 1 &&
      !is_visitor(std::string(fact[2][1].text()))) {
    traffic.agents[std::string(fact[1].text())].contract = fact[2];
  }
  return fact.is_form("agent") || fact.is_form("contract");
}

void see_stream(Traffic& traffic, const Fact& fact) {
  if (!fact.datum.is_form("stream") || fact.datum.size() != 4) return;
  traffic.streams[std::string(fact.datum[1].text())].teller = agent_of_teller(fact.teller);
}

void ExchangeCounter::see(const Fact& fact) {
  const Datum& datum = fact.datum;
  if (datum.is_form("request") && datum.size() == 4) {
    const Datum& operation = datum[3];
    const std::string name(operation.is_list() ? operation.head() : operation.text());
    const bool waits = datum[1].text().find("-send-") == std::string_view::npos;
    const ExchangeKey key{agent_of_teller(fact.teller), std::string(datum[2].text()), name, waits};
    // Told again, it is the same request.
    if (!open_.emplace(datum[1], Open{key, fact.when}).second) return;
    Exchange& exchange = traffic_.exchanges[key];
    ++exchange.asked;
    exchange.bytes += static_cast<double>(write(datum).size());
  }
  if (!datum.is_form("reply") || datum.size() != 3) return;
  const auto open = open_.find(datum[1]);
  if (open == open_.end()) return;
  Exchange& exchange = traffic_.exchanges[open->second.key];
  ++exchange.answered;
  exchange.misfit += is_misfit(datum[2]) ? 1 : 0;
  exchange.bytes_back += static_cast<double>(write(datum).size());
  exchange.took_ms.push_back(ms_between(open->second.when, fact.when));
  open_.erase(open);
}

void ExchangeCounter::end(Time now) {
  for (const auto& [id, open] : open_) {
    Exchange& exchange = traffic_.exchanges[open.key];
    exchange.oldest_open_s = std::max(exchange.oldest_open_s, ms_between(open.when, now) / 1000);
  }
}

Result<Traffic> traffic_of_journal(std::string_view text) {
  Traffic traffic;
  ExchangeCounter exchanges(traffic);
  Bytes bytes;
  Relations relations;
  Time first{}, last{};
  bool begun = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    const auto read = journal::read_journal_line(line);
    if (!read) return fail(read);
    const auto* commit = std::get_if<store::Commit>(&*read);
    if (commit == nullptr) continue;
    if (!begun) first = commit->when;
    begun = true;
    last = commit->when;
    for (const store::Commit::Entry& entry : commit->entries) {
      see_taken(entry, commit->teller, traffic, relations);
      if (entry.kind != store::Commit::Entry::Kind::told) continue;
      Fact fact = entry.fact;
      fact.teller = commit->teller;
      fact.when = commit->when;
      see_told(fact, traffic, exchanges, bytes);
    }
  }
  exchanges.end(last);
  for (const auto& [relation, sum] : bytes) {
    traffic.flows[relation].mean_bytes = sum.first / static_cast<double>(sum.second);
  }
  traffic.seconds = ms_between(first, last) / 1000;
  return traffic;
}

}  // namespace pizarra::method
