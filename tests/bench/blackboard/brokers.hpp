#pragma once

// Message brokers as peers, each a server of the bench's own: NATS, MQTT (mosquitto), CORBA's events (omniEvents). What
// is published goes to whoever watches.
//
//   for (const Broker& broker : start({nats(), mqtt()})) ...       // those that are not installed do not run
//   const std::unique_ptr<BrokerClient> client = broker.connect(true);
//   client->publish_acknowledged("payload");

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/child.hpp"
#include "tests/bench/figures.hpp"

namespace pizarra::bench {

constexpr std::string_view broker_topic = "seen";

class BrokerClient {
 public:
  virtual ~BrokerClient() = default;
  // One message, until the broker has said that it has it.
  virtual void publish_acknowledged(std::string_view payload) = 0;
  // As the broker takes it, without a word.
  virtual void publish(std::string_view payload) = 0;
  // What publish() was called for since, in one go.
  virtual void flush() = 0;
  virtual void watch() = 0;
  virtual std::string message() = 0;
};

struct BrokerKind {
  std::string name;
  std::string program;
  std::function<std::vector<std::string>(const std::string& program, int port, const std::string& folder)> command_line;
  // Once it listens, if there is something to do.
  std::function<void(int port)> prepare;
  // None: its client was not built.
  std::function<std::unique_ptr<BrokerClient>(int port, bool acknowledging)> connect;
};

BrokerKind nats();
BrokerKind mqtt();
BrokerKind omni_events();

class Broker {
 public:
  // Not running where the program is not installed.
  explicit Broker(BrokerKind kind);

  bool runs() const { return process_.has_value(); }
  // With `acknowledging`, each message that is published is answered.
  std::unique_ptr<BrokerClient> connect(bool acknowledging) const;
  // What was measured of it, where it runs.
  Peer peer(double value) const { return {kind_.name, runs() ? std::optional(value) : std::nullopt}; }

 private:
  const BrokerKind kind_;
  int port_ = 0;
  TemporaryFolder folder_;
  std::optional<Child> process_;
};

std::vector<Broker> start(const std::vector<BrokerKind>& kinds);
// One value a broker.
void add_peers(std::vector<Peer>& peers, const std::vector<Broker>& brokers, std::span<const double> values);

}  // namespace pizarra::bench
