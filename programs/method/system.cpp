#include "programs/method/system.hpp"

#include <algorithm>
#include <array>

#include "programs/method/connect.hpp"

namespace pizarra::method {

namespace {

double part_of(std::vector<double>& values, double part) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

// The relation by which streams of images are found.
const std::string announcement = "stream";

using Place = std::array<std::string, 3>;  // from, to, pattern

void add_exchanges(const Traffic& traffic, std::map<Place, Connection>& matrix) {
  std::map<Place, std::vector<double>> took;
  for (const auto& [key, exchange] : traffic.exchanges) {
    if (!traffic.agents.contains(key.client) || !traffic.agents.contains(key.server)) continue;
    const std::string pattern = key.waits ? "QUERY" : "SEND";
    const Place place{key.client, key.server, pattern};
    Connection& connection = matrix[place];
    connection.about.insert(key.operation);
    connection.count += exchange.asked;
    connection.bytes += exchange.bytes;
    connection.bytes_back += exchange.bytes_back;
    took[place].insert(took[place].end(), exchange.took_ms.begin(), exchange.took_ms.end());
  }
  for (auto& [place, connection] : matrix) {
    const auto asked = static_cast<double>(std::max<std::size_t>(connection.count, 1));
    connection.bytes /= asked;
    connection.bytes_back /= asked;
    connection.p50_ms = part_of(took[place], 0.5);
    connection.p99_ms = part_of(took[place], 0.99);
  }
}

// So many messages more.
void carry(Connection& connection, std::size_t count, double bytes) {
  const auto before = static_cast<double>(connection.count), more = static_cast<double>(count);
  if (before + more > 0) connection.bytes = (connection.bytes * before + bytes * more) / (before + more);
  connection.count += count;
}

void add_pushes(const Traffic& traffic, std::map<Place, Connection>& matrix) {
  for (const auto& [relation, flow] : traffic.flows) {
    if (is_of_every_agent(relation) || relation == announcement) continue;
    // Who takes a fact waits for it by watching.
    std::set<std::string> readers = readers_of(traffic, relation);
    for (const std::string& taker : takers_of(traffic, relation)) readers.erase(taker);
    for (const auto& [teller, count] : flow.told) {
      if (!traffic.agents.contains(teller)) continue;
      const std::size_t others = readers.size() - (readers.contains(teller) ? 1 : 0);
      for (const std::string& reader : readers) {
        if (reader == teller || !traffic.agents.contains(reader)) continue;
        Connection& connection = matrix[{teller, reader, "PUSH"}];
        carry(connection, count, flow.mean_bytes);
        connection.about.insert(relation);
        connection.addressees = std::max(connection.addressees, others);
        connection.p50_ms = std::max(connection.p50_ms, flow.delivered_p50_ms);
        connection.p99_ms = std::max(connection.p99_ms, flow.delivered_p99_ms);
      }
    }
  }
}

// Of a relation with several tellers, what is taken counts for each by how much it told.
void add_events(const Traffic& traffic, std::map<Place, Connection>& matrix) {
  for (const auto& [relation, flow] : traffic.flows) {
    if (is_of_every_agent(relation)) continue;
    const std::set<std::string> takers = takers_of(traffic, relation);
    std::size_t all = 0;
    for (const auto& [teller, count] : flow.told) all += count;
    for (const auto& [teller, count] : flow.told) {
      if (!traffic.agents.contains(teller)) continue;
      for (const std::string& taker : takers) {
        if (taker == teller || !traffic.agents.contains(taker)) continue;
        const auto taken = flow.taken.find(taker);
        const std::size_t took = taken == flow.taken.end() || all == 0 ? 0 : taken->second * count / all;
        Connection& connection = matrix[{teller, taker, "EVENT"}];
        carry(connection, took, flow.mean_bytes);
        connection.about.insert(relation);
        connection.addressees = std::max(connection.addressees, takers.size());
      }
    }
  }
}

void add_streams(const Traffic& traffic, std::map<Place, Connection>& matrix) {
  const std::set<std::string> readers = readers_of(traffic, announcement);
  for (const auto& [name, images] : traffic.streams) {
    if (!traffic.agents.contains(images.teller)) continue;
    for (const std::string& reader : readers) {
      if (reader == images.teller || !traffic.agents.contains(reader)) continue;
      Connection& connection = matrix[{images.teller, reader, "STREAM"}];
      carry(connection, static_cast<std::size_t>(images.per_second * traffic.seconds), images.bytes);
      connection.about.insert(name);
      connection.addressees = readers.size();
    }
  }
}

}  // namespace

std::set<std::string> names_in(const Datum& contract, std::string_view part) {
  std::set<std::string> names;
  for (const Datum& each : contract.items()) {
    if (!each.is_form(part)) continue;
    for (const Datum& item : each.items().subspan(1)) {
      if (item.is_symbol()) names.emplace(item.text());
      // Some write the names of a part in a list of their own.
      if (item.is_list() && item.size() > 0 && !item.is_form("relation") && part != "offers") {
        for (const Datum& name : item.items()) {
          if (name.is_symbol()) names.emplace(name.text());
        }
      }
      if (part == "offers" && !item.head().empty()) names.emplace(item.head());
      if (item.is_form("relation") && item.size() > 1) names.emplace(item[1].text());
    }
  }
  return names;
}

bool is_of_every_agent(const std::string& relation) {
  constexpr std::array names = {"agent",  "board-probe", "bound",   "context", "contract",
                                "holder", "reply",       "request", "wired"};
  return std::ranges::find(names, relation) != names.end();
}

bool is_visitor(const std::string& kind) {
  constexpr std::array kinds = {"prompt", "director", "replay", "method"};
  return std::ranges::find(kinds, kind) != kinds.end();
}

std::set<std::string> readers_of(const Traffic& traffic, const std::string& relation) {
  if (traffic.watches_seen) {
    const auto flow = traffic.flows.find(relation);
    if (flow == traffic.flows.end()) return {};
    std::set<std::string> readers = flow->second.watchers;
    readers.insert(flow->second.askers.begin(), flow->second.askers.end());
    return readers;
  }
  std::set<std::string> readers;
  for (const auto& [name, agent] : traffic.agents) {
    if (names_in(agent.contract, "reads").contains(relation)) readers.insert(name);
  }
  return readers;
}

std::set<std::string> takers_of(const Traffic& traffic, const std::string& relation) {
  std::set<std::string> takers;
  const auto flow = traffic.flows.find(relation);
  if (flow != traffic.flows.end()) {
    for (const auto& [taker, count] : flow->second.taken) takers.insert(taker);
  }
  for (const auto& [name, agent] : traffic.agents) {
    if (names_in(agent.contract, "takes").contains(relation)) takers.insert(name);
  }
  return takers;
}

System system_of(const Traffic& traffic, const std::map<std::string, Component>& kinds) {
  System system{.name = traffic.name, .seconds = traffic.seconds, .components = {}, .connections = {}};
  std::map<Place, Connection> matrix;
  add_exchanges(traffic, matrix);
  add_pushes(traffic, matrix);
  add_events(traffic, matrix);
  add_streams(traffic, matrix);
  std::map<std::string, int> beginning;
  for (auto& [place, connection] : matrix) {
    connection.from = place[0];
    connection.to = place[1];
    connection.pattern = place[2];
    ++beginning[connection.from];
    advise(connection, traffic.seconds);
    system.connections.push_back(std::move(connection));
  }
  for (const auto& [name, agent] : traffic.agents) {
    const auto known = kinds.find(agent.kind);
    Component component = known == kinds.end() ? Component() : known->second;
    component.name = name;
    component.kind = agent.kind;
    component.connections = beginning[name];
    system.components.push_back(std::move(component));
  }
  return system;
}

}  // namespace pizarra::method
