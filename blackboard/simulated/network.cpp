#include "blackboard/simulated/network.hpp"

#include <algorithm>
#include <deque>

#include "blackboard/simulated/simulated_socket.hpp"

namespace pizarra::simulated {

struct Network::Direction {
  std::deque<std::pair<Time, std::string>> under_way;
  std::size_t bytes = 0;
  Time last{};
};

struct Network::Connection {
  std::string peer;  // what the router calls it
  SimulatedSocket* router = nullptr;
  SimulatedSocket* dealer = nullptr;
  Direction to_router;
  Direction to_dealer;
  bool stands = true;
  bool loses_next_reply = false;
};

namespace {

class Plug : public wire::Transport {
 public:
  Plug(Network& network, std::string name, Process& process)
      : network_(network), name_(std::move(name)), process_(process) {}
  std::unique_ptr<wire::FrameSocket> open(Executor&, wire::FrameSocket::Kind kind,
                                          wire::FrameSocket::Receiver receiver) override {
    return std::make_unique<SimulatedSocket>(network_, name_, process_, kind, std::move(receiver));
  }

 private:
  Network& network_;
  const std::string name_;
  Process& process_;
};

}  // namespace

Network::Network(Executor& time, Random random, Delay delay) : time_(time), random_(std::move(random)), delay_(delay) {}

Network::~Network() = default;

std::unique_ptr<wire::Transport> Network::plug(std::string name, Process& process) {
  return std::make_unique<Plug>(*this, std::move(name), process);
}

void Network::unplug(const std::string& name) {
  break_connections(name);
  for (const auto& [number, dealer] : dealers_[name]) dealer->cut_off_ = true;
  for (const auto& [address, router] : routers_) {
    if (router->name_ == name) router->cut_off_ = true;
  }
  std::erase_if(routers_, [&](const auto& entry) { return entry.second->name_ == name; });
}

void Network::open(SimulatedSocket& socket) {
  if (socket.kind_ == wire::FrameSocket::Kind::dealer) dealers_[socket.name_].emplace(socket.number_, &socket);
}

void Network::close(SimulatedSocket& socket) {
  dealers_[socket.name_].erase(socket.number_);
  const auto bound = routers_.find(socket.address_);
  if (bound != routers_.end() && bound->second == &socket) routers_.erase(bound);
  for (const auto& [peer, connection] : std::map(connections_)) {
    if (connection->router == &socket || connection->dealer == &socket) cut(connection);
  }
}

Result<std::string> Network::bind(SimulatedSocket& socket, const std::string& address) {
  if (!routers_.emplace(address, &socket).second) {
    return fail("address-in-use", "another board answers there", to_datum(address));
  }
  socket.address_ = address;
  return address;
}

void Network::connect_soon(SimulatedSocket& dealer, Duration after) {
  time_.call_at(time_.now() + after + draw_delay(), [this, name = dealer.name_, number = dealer.number_] {
    const auto& of_name = dealers_[name];
    const auto found = of_name.find(number);
    if (found != of_name.end()) connect(*found->second);
  });
}

void Network::connect(SimulatedSocket& dealer) {
  if (!dealer.connection_.empty() || dealer.cut_off_) return;
  const auto router = routers_.find(dealer.address_);
  if (router == routers_.end()) return connect_soon(dealer, connect_again_after);
  auto connection = std::make_shared<Connection>();
  connection->peer = "peer-" + std::to_string(next_++);
  connection->router = router->second;
  connection->dealer = &dealer;
  connections_.emplace(connection->peer, connection);
  dealer.connection_ = connection->peer;
  ++counts_.connections;
  dealer.hear_connected();
}

bool Network::send(SimulatedSocket& from, const std::string& peer, std::string_view frame) {
  const bool to_router = from.kind_ == wire::FrameSocket::Kind::dealer;
  const auto found = connections_.find(to_router ? from.connection_ : peer);
  if (found == connections_.end()) return false;
  const std::shared_ptr<Connection>& connection = found->second;
  Direction& way = to_router ? connection->to_router : connection->to_dealer;
  const bool fits = way.under_way.size() < most_under_way && way.bytes + frame.size() <= most_bytes_under_way;
  if (!fits) return false;
  ++counts_.frames;
  const bool is_reply = frame.starts_with("(reply ") && !to_router;
  if (is_reply && std::exchange(connection->loses_next_reply, false)) {
    ++counts_.lost_replies;
    // The sender learns of it as of any other, later.
    time_.post([this, connection] { cut(connection); });
    return true;
  }
  Time at = std::max(time_.now() + draw_delay(), way.last);
  const bool overtakes = overtake_ && way.under_way.size() > 1 && random_.below(4) == 0;
  const auto stalled = stalled_.find(connection->dealer->name_);
  if (stalled != stalled_.end()) at = std::max(at, stalled->second);
  way.last = at;
  way.bytes += frame.size();
  way.under_way.emplace_back(at, frame);
  if (overtakes) std::swap(way.under_way.back().second, way.under_way.front().second);
  time_.call_at(at, [this, connection, to_router] { arrive(connection, to_router); });
  return true;
}

void Network::arrive(const std::shared_ptr<Connection>& connection, bool to_router) {
  Direction& way = to_router ? connection->to_router : connection->to_dealer;
  if (!connection->stands) return;
  std::string frame = std::move(way.under_way.front().second);
  way.under_way.pop_front();
  way.bytes -= frame.size();
  SimulatedSocket& to = to_router ? *connection->router : *connection->dealer;
  to.take(to_router ? connection->peer : std::string(), std::move(frame));
}

void Network::cut(const std::shared_ptr<Connection>& connection) {
  if (!std::exchange(connection->stands, false)) return;
  counts_.lost += connection->to_router.under_way.size() + connection->to_dealer.under_way.size();
  connections_.erase(connection->peer);
  SimulatedSocket& dealer = *connection->dealer;
  dealer.connection_.clear();
  connect_soon(dealer, connect_again_after);
}

bool Network::has_room(const SimulatedSocket&, const std::string& peer) const {
  const auto found = connections_.find(peer);
  return found == connections_.end() || found->second->to_dealer.bytes <= most_bytes_under_way / 2;
}

void Network::break_connections(const std::string& name) {
  for (const auto& [peer, connection] : std::map(connections_)) {
    if (connection->dealer->name_ == name || connection->router->name_ == name) cut(connection);
  }
}

void Network::lose_next_reply(const std::string& name) {
  for (const auto& [peer, connection] : connections_) {
    if (connection->dealer->name_ == name) connection->loses_next_reply = true;
  }
}

void Network::stall(const std::string& name, Duration length) {
  Time& until = stalled_[name];
  until = std::max(until, time_.now() + length);
}

Duration Network::draw_delay() {
  const double us =
      random_.uniform(static_cast<double>(delay_.least.count()), static_cast<double>(delay_.most.count()));
  return Duration(static_cast<Duration::rep>(us));
}

}  // namespace pizarra::simulated
