#include "tests/bench/blackboard/brokers.hpp"

#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

#include "tests/bench/blackboard/tcp_client.hpp"

namespace pizarra::bench {

namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

constexpr std::string_view topic = "seen";

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
    link_.send(fmt::format("SUB {} 1\r\nPING\r\n", topic));
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
    return fmt::format("PUB {} {}\r\n{}\r\n", topic, payload.size(), payload);
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

class MqttClient : public BrokerClient {
 public:
  explicit MqttClient(int port) : link_(port, "mosquitto") {
    // A clean session of MQTT 3.1.1, kept alive for ever, under no name.
    link_.send(packet(0x10, "\0\4MQTT\4\2\0\0\0\0"sv));
    expect(0x20);
  }
  void publish_acknowledged(std::string_view payload) override {
    // At least once, as message 1: none other is under way.
    link_.send(packet(0x32, named(topic) + "\0\1"s + std::string(payload)));
    expect(0x40);
  }
  void publish(std::string_view payload) override { pending_ += packet(0x30, named(topic) + std::string(payload)); }
  void flush() override { link_.send(std::exchange(pending_, {})); }
  void watch() override {
    link_.send(packet(0x82, "\0\1"s + named(topic) + "\0"s));
    expect(0x90);
  }
  std::string message() override {
    const std::string body = expect(0x30);
    return body.substr(2 + topic.size());
  }

 private:
  static std::string named(std::string_view text) {
    return std::string(1, '\0') + static_cast<char>(text.size()) + std::string(text);
  }
  static std::string packet(int kind, std::string_view body) {
    std::string text(1, static_cast<char>(kind));
    std::size_t left = body.size();
    do {
      const std::size_t digit = left % 128;
      left /= 128;
      text += static_cast<char>(left > 0 ? digit | 128 : digit);
    } while (left > 0);
    return text.append(body);
  }
  std::string expect(int kind) {
    const auto byte = [this] { return static_cast<unsigned char>(link_.bytes(1).front()); };
    const int said = byte();
    std::size_t size = 0;
    for (int shift = 0;; shift += 7) {
      const unsigned char digit = byte();
      size |= std::size_t{digit & 127U} << shift;
      if ((digit & 128U) == 0) break;
    }
    if (said != kind) throw std::runtime_error(fmt::format("mosquitto sends a packet {:#x}", said));
    return std::string(link_.bytes(size));
  }
  TcpClient link_;
  std::string pending_;
};

}  // namespace

Broker::Broker(Kind kind) : kind_(kind) {
  const std::string program_name = kind == Kind::nats ? "nats-server" : "mosquitto";
  const std::optional<std::string> program = find_program(program_name);
  if (!program) return;
  port_ = free_port();
  if (kind == Kind::nats) {
    const std::string log = folder_.path() + "/log";
    process_.emplace(Child::program({*program, "-a", "127.0.0.1", "-p", std::to_string(port_), "-l", log}));
  } else {
    const std::string settings = folder_.path() + "/mosquitto.conf";
    std::ofstream(settings) << fmt::format(
        "listener {} 127.0.0.1\nallow_anonymous true\nset_tcp_nodelay true\nmax_queued_messages 0\nlog_type none\n",
        port_);
    process_.emplace(Child::program({*program, "-c", settings}));
  }
  wait_for_server(port_, program_name);
}

std::unique_ptr<BrokerClient> Broker::connect(bool acknowledging) const {
  if (!runs()) return nullptr;
  if (kind_ == Kind::nats) return std::make_unique<NatsClient>(port_, acknowledging);
  return std::make_unique<MqttClient>(port_);
}

std::vector<Broker> start_brokers() {
  std::vector<Broker> brokers;
  brokers.emplace_back(Broker::Kind::nats);
  brokers.emplace_back(Broker::Kind::mqtt);
  return brokers;
}

}  // namespace pizarra::bench
