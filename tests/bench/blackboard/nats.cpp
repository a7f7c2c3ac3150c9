// NATS, by its text protocol.

#include <fmt/format.h>
#include <stdexcept>
#include <utility>

#include "tests/bench/blackboard/brokers.hpp"
#include "tests/bench/blackboard/tcp_client.hpp"

namespace pizarra::bench {

namespace {

class NatsClient : public BrokerClient {
 public:
  NatsClient(int port, bool acknowledging) : link_(port, "nats-server") {
    link_.line();
    link_.send(fmt::format("CONNECT {{\"verbose\":{},\"pedantic\":false}}\r\n", acknowledging));
    if (acknowledging) expect("+OK");
  }
  void publish_acknowledged(std::string_view payload) override {
    link_.send(command(payload));
    expect("+OK");
  }
  void publish(std::string_view payload) override { pending_ += command(payload); }
  void flush() override { link_.send(std::exchange(pending_, {})); }
  void watch() override {
    link_.send(fmt::format("SUB {} 1\r\nPING\r\n", broker_topic));
    expect("PONG");
  }
  std::string message() override {
    const std::string_view head = line();
    const std::size_t size = std::stoul(std::string(head.substr(head.rfind(' ') + 1)));
    std::string payload(link_.bytes(size));
    link_.bytes(2);
    return payload;
  }

 private:
  static std::string command(std::string_view payload) {
    return fmt::format("PUB {} {}\r\n{}\r\n", broker_topic, payload.size(), payload);
  }
  // The broker wants to know at times whether its clients live.
  std::string_view line() {
    while (true) {
      const std::string_view line = link_.line();
      if (line != "PING") return line;
      link_.send("PONG\r\n");
    }
  }
  void expect(std::string_view wanted) {
    std::string_view said = line();
    if (wanted == "PONG" && said == "+OK") said = line();
    if (said != wanted) throw std::runtime_error("nats-server says " + std::string(said));
  }
  TcpClient link_;
  std::string pending_;
};

std::vector<std::string> command_line(const std::string& program, int port, const std::string& folder) {
  return {program, "-a", "127.0.0.1", "-p", std::to_string(port), "-l", folder + "/log"};
}

std::unique_ptr<BrokerClient> connect(int port, bool acknowledging) {
  return std::make_unique<NatsClient>(port, acknowledging);
}

}  // namespace

BrokerKind nats() { return {"nats", "nats-server", command_line, {}, connect}; }

}  // namespace pizarra::bench
