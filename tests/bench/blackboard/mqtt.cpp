// MQTT 3.1.1, by mosquitto.

#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "tests/bench/blackboard/brokers.hpp"
#include "tests/bench/blackboard/tcp_client.hpp"

namespace pizarra::bench {

namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

class MqttClient : public BrokerClient {
 public:
  explicit MqttClient(int port) : link_(port, "mosquitto") {
    // A clean session of MQTT 3.1.1, kept alive for ever, under no name.
    link_.send(packet(0x10, "\0\4MQTT\4\2\0\0\0\0"sv));
    expect(0x20);
  }
  void publish_acknowledged(std::string_view payload) override {
    // At least once, as message 1: none other is under way.
    link_.send(packet(0x32, named(broker_topic) + "\0\1"s + std::string(payload)));
    expect(0x40);
  }
  void publish(std::string_view payload) override {
    pending_ += packet(0x30, named(broker_topic) + std::string(payload));
  }
  void flush() override { link_.send(std::exchange(pending_, {})); }
  void watch() override {
    link_.send(packet(0x82, "\0\1"s + named(broker_topic) + "\0"s));
    expect(0x90);
  }
  std::string message() override {
    const std::string body = expect(0x30);
    return body.substr(2 + broker_topic.size());
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

std::vector<std::string> command_line(const std::string& program, int port, const std::string& folder) {
  const std::string settings = folder + "/mosquitto.conf";
  std::ofstream(settings) << fmt::format(
      "listener {} 127.0.0.1\nallow_anonymous true\nset_tcp_nodelay true\nmax_queued_messages 0\nlog_type none\n",
      port);
  return {program, "-c", settings};
}

std::unique_ptr<BrokerClient> connect(int port, bool) { return std::make_unique<MqttClient>(port); }

}  // namespace

BrokerKind mqtt() { return {"mqtt", "mosquitto", command_line, {}, connect}; }

}  // namespace pizarra::bench
