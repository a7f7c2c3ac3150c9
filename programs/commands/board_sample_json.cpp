#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lisp/json.hpp"
#include "programs/commands/board_sample.hpp"

namespace pizarra::programs {

namespace {

std::string spread_json(const Spread& spread) {
  if (spread.count == 0) return "null";
  return fmt::format("{{\"count\":{},\"p50\":{},\"p90\":{},\"p99\":{}}}", spread.count, spread.p50_us, spread.p90_us,
                     spread.p99_us);
}

std::string clients_json(const std::vector<ClientSample>& clients) {
  std::vector<std::string> objects;
  for (const ClientSample& client : clients) {
    objects.push_back(fmt::format("{{\"name\":{},\"requests_per_second\":{},\"refused\":{},\"newest_refusal\":{}}}",
                                  json_string(client.name), client.requests_per_second, client.refused,
                                  client.refused == 0 ? "null" : json_string(client.newest_refusal)));
  }
  return fmt::format("[{}]", fmt::join(objects, ","));
}

}  // namespace

std::string json_of(const BoardSample& sample) {
  std::vector<std::string> agents;
  for (const AgentSample& agent : sample.agents) {
    agents.push_back(
        fmt::format("{{\"name\":{},\"kind\":{},\"host\":{},\"told_per_second\":{:.1f},\"waiting\":{},"
                    "\"queued\":{}}}",
                    json_string(agent.name), json_string(agent.kind), json_string(agent.host), agent.told_per_second,
                    agent.waiting, agent.queued));
  }
  std::vector<std::string> relations;
  for (const RelationSample& relation : sample.relations) {
    std::vector<std::string> tellers;
    for (const std::string& teller : relation.tellers) tellers.push_back(json_string(teller));
    relations.push_back(
        fmt::format("{{\"name\":{},\"facts\":{},\"told_per_second\":{:.1f},\"watches\":{},\"tellers\":[{}],"
                    "\"told_us\":{},\"delivered_us\":{}}}",
                    json_string(relation.name), relation.facts, relation.told_per_second, relation.watches,
                    fmt::join(tellers, ","), spread_json(relation.told), spread_json(relation.delivered)));
  }
  const std::string journey =
      sample.journey
          ? fmt::format("{{\"committed_us\":{:.0f},\"acknowledged_us\":{:.0f},\"delivered_us\":{:.0f}}}",
                        sample.journey->committed_us, sample.journey->acknowledged_us, sample.journey->delivered_us)
          : "null";
  return fmt::format(
      "{{\"revision\":{},\"facts\":{},\"transactions_per_second\":{:.1f},\"journey\":{},\"agents\":{},"
      "\"relations\":[{}],\"clients\":{}}}",
      sample.revision, sample.facts, sample.transactions_per_second, journey,
      sample.agents_unknown ? "null" : fmt::format("[{}]", fmt::join(agents, ",")), fmt::join(relations, ","),
      clients_json(sample.clients));
}

}  // namespace pizarra::programs
