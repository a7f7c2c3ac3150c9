#include "programs/method/faults.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace pizarra::method {

namespace {

// A question so close to the end of the look may still be answered.
constexpr double open_for_s = 10;

std::string times(std::size_t count) { return count == 1 ? "once" : fmt::format("{} times", count); }

bool is_named_by_any(const Traffic& traffic, std::string_view part, const std::string& relation) {
  return std::ranges::any_of(
      traffic.agents, [&](const auto& agent) { return names_in(agent.second.contract, part).contains(relation); });
}

// A relation for people to look at is named among a contract's monitors.
bool is_read_by_any(const Traffic& traffic, const std::string& relation) {
  return std::ranges::any_of(std::array{"reads", "takes", "monitors"},
                             [&](const char* part) { return is_named_by_any(traffic, part, relation); });
}

void find_false_contracts(const Traffic& traffic, std::vector<Fault>& faults) {
  for (const auto& [relation, flow] : traffic.flows) {
    if (is_of_every_agent(relation)) continue;
    for (const auto& [teller, count] : flow.told) {
      const auto agent = traffic.agents.find(teller);
      if (count == 0 || agent == traffic.agents.end()) continue;
      if (names_in(agent->second.contract, "posts").contains(relation)) continue;
      faults.push_back(
          {"false-contract", teller,
           fmt::format("{} told {} {}, and its contract does not post it", teller, relation, times(count))});
    }
    for (const std::string& watcher : flow.watchers) {
      const auto agent = traffic.agents.find(watcher);
      if (agent == traffic.agents.end()) continue;
      // A contract need not say that an agent reads a relation that it posts itself.
      const bool own = names_in(agent->second.contract, "posts").contains(relation);
      if (own || names_in(agent->second.contract, "reads").contains(relation)) continue;
      faults.push_back({"false-contract", watcher,
                        fmt::format("{} watches {}, and its contract does not read it", watcher, relation)});
    }
    for (const auto& [taker, count] : flow.taken) {
      const auto agent = traffic.agents.find(taker);
      if (agent == traffic.agents.end() || names_in(agent->second.contract, "takes").contains(relation)) continue;
      faults.push_back(
          {"false-contract", taker,
           fmt::format("{} took {} {}, and its contract does not take it", taker, relation, times(count))});
    }
  }
}

void find_never_read(const Traffic& traffic, std::vector<Fault>& faults) {
  for (const auto& [relation, flow] : traffic.flows) {
    std::size_t told = 0;
    for (const auto& [teller, count] : flow.told) told += traffic.agents.contains(teller) ? count : 0;
    const bool read = !flow.watchers.empty() || !flow.askers.empty() || !flow.taken.empty();
    if (read || is_read_by_any(traffic, relation) || is_of_every_agent(relation)) continue;
    // Before anything has run, contracts alone say what is told.
    const bool nothing_ran = !traffic.watches_seen && traffic.seconds == 0;
    if (told == 0 && nothing_ran) {
      faults.push_back(
          {"never-read", relation, fmt::format("{} is posted by a contract, and no contract here reads it", relation)});
    }
    if (told == 0) continue;
    faults.push_back(
        {"never-read", relation,
         fmt::format("{} was told {}, and nobody reads it: no agent, page or program", relation, times(told))});
  }
}

void find_unanswered(const Traffic& traffic, std::vector<Fault>& faults) {
  for (const auto& [key, exchange] : traffic.exchanges) {
    if (exchange.misfit > 0) {
      faults.push_back({"false-contract", key.server,
                        fmt::format("{} asked {} {} for {}, which it does not offer in that form", key.client,
                                    key.server, times(exchange.misfit), key.operation)});
    }
    const bool silent = key.waits && exchange.asked > exchange.answered;
    if (!silent || exchange.oldest_open_s < open_for_s) continue;
    const bool there = traffic.agents.contains(key.server);
    faults.push_back({"never-answered", key.server,
                      fmt::format("{} asked {} {} for {} and was not answered, the first time {:.0f} s ago{}",
                                  key.client, key.server, times(exchange.asked - exchange.answered), key.operation,
                                  exchange.oldest_open_s, there ? "" : fmt::format(": no {} is there", key.server))});
  }
}

// From the measured times: a subscriber's share, and the time that one more of them would add.
void find_slow_pushes(const Traffic& traffic, std::vector<Fault>& faults) {
  double each_ms = 0;
  if (traffic.scales.size() > 1) {
    const Scale &few = traffic.scales.front(), &many = traffic.scales.back();
    each_ms = std::max(0.0, many.p50_ms - few.p50_ms) / static_cast<double>(many.subscribers - few.subscribers);
  }
  for (const auto& [relation, flow] : traffic.flows) {
    std::size_t told = 0;
    for (const auto& [teller, count] : flow.told) told = std::max(told, count);
    if (told < 2 || traffic.seconds <= 0 || flow.watchers.empty()) continue;
    const double period_ms = traffic.seconds * 1000 / static_cast<double>(told);
    if (flow.delivered_p99_ms > period_ms) {
      faults.push_back({"does-not-scale", relation,
                        fmt::format("{} is told every {:.1f} ms, and takes {:.1f} ms to its readers (the 99th of 100)",
                                    relation, period_ms, flow.delivered_p99_ms)});
      continue;
    }
    if (each_ms <= 0) continue;
    const double room = (period_ms - flow.delivered_p50_ms) / each_ms;
    if (room >= static_cast<double>(flow.watchers.size())) continue;
    faults.push_back(
        {"does-not-scale", relation,
         fmt::format("{} is told every {:.1f} ms to {} readers, and each more costs {:.2f} ms: {:.0f} more "
                     "fill the time between two",
                     relation, period_ms, flow.watchers.size(), each_ms, room)});
  }
}

}  // namespace

std::vector<Fault> faults_of(const Traffic& traffic) {
  std::vector<Fault> faults;
  find_false_contracts(traffic, faults);
  find_never_read(traffic, faults);
  find_unanswered(traffic, faults);
  find_slow_pushes(traffic, faults);
  return faults;
}

}  // namespace pizarra::method
