#include "tests/bench/blackboard/brokers.hpp"

#include <utility>

#include "lisp/installed_program.hpp"
#include "tests/bench/blackboard/tcp_client.hpp"
#include "tests/free_port.hpp"

namespace pizarra::bench {

Broker::Broker(BrokerKind kind) : kind_(std::move(kind)) {
  if (!kind_.connect) return;
  const std::optional<std::string> program = installed_program(kind_.program);
  if (!program) return;
  port_ = free_port();
  process_.emplace(Child::program(kind_.command_line(*program, port_, folder_.path())));
  wait_for_server(port_, kind_.program);
  if (kind_.prepare) kind_.prepare(port_);
}

std::unique_ptr<BrokerClient> Broker::connect(bool acknowledging) const {
  return runs() ? kind_.connect(port_, acknowledging) : nullptr;
}

std::vector<Broker> start(const std::vector<BrokerKind>& kinds) {
  std::vector<Broker> brokers;
  for (const BrokerKind& kind : kinds) brokers.emplace_back(kind);
  return brokers;
}

void add_peers(std::vector<Peer>& peers, const std::vector<Broker>& brokers, std::span<const double> values) {
  for (std::size_t i = 0; i < brokers.size(); ++i) peers.push_back(brokers[i].peer(values[i]));
}

}  // namespace pizarra::bench
