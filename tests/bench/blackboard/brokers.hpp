#pragma once

// Message brokers as peers: NATS (its text protocol) and MQTT 3.1.1 (mosquitto), each a server of the bench's own. What
// is published goes to whoever watches.
//
//   for (const Broker& broker : start_brokers()) ...           // those that are not installed have no port
//   const std::unique_ptr<BrokerClient> client = broker.connect();
//   client->publish_acknowledged("payload");

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/child.hpp"
#include "tests/bench/figures.hpp"

namespace pizarra::bench {

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

class Broker {
 public:
  enum class Kind { nats, mqtt };
  // Not running where the program is not installed.
  explicit Broker(Kind kind);

  std::string name() const { return kind_ == Kind::nats ? "nats" : "mqtt"; }
  bool runs() const { return process_.has_value(); }
  // With `acknowledging`, each message that is published is answered.
  std::unique_ptr<BrokerClient> connect(bool acknowledging) const;
  // What was measured of it, where it runs.
  Peer peer(double value) const { return {name(), runs() ? std::optional(value) : std::nullopt}; }

 private:
  const Kind kind_;
  int port_ = 0;
  TemporaryFolder folder_;
  std::optional<Child> process_;
};

std::vector<Broker> start_brokers();

}  // namespace pizarra::bench
