#pragma once

// Redis as a peer: a server of the bench's own, on a socket in a temporary folder, and the little of its protocol that
// is measured.
//
//   std::optional<RedisServer> server = RedisServer::start();      // nothing where it is not installed
//   RedisClient client(*server);
//   client.set("name", "value");

#include <optional>
#include <string>
#include <string_view>

#include "tests/bench/blackboard/tcp_client.hpp"
#include "tests/bench/child.hpp"

namespace pizarra::bench {

class RedisServer {
 public:
  // With options of redis-server's command line.
  static std::optional<RedisServer> start(const std::vector<std::string>& options = {});
  int port() const { return port_; }

 private:
  RedisServer(TemporaryFolder folder, Child process, int port)
      : folder_(std::move(folder)), process_(std::move(process)), port_(port) {}
  TemporaryFolder folder_;  // outlives the process, which would go on writing there
  Child process_;
  int port_;
};

class RedisClient {
 public:
  explicit RedisClient(int port) : link_(port, "redis") {}

  static std::string command(std::initializer_list<std::string_view> words);
  void send(std::string_view commands) const { link_.send(commands); }
  // Reads until `replies` of them have come that are one line, or a string of at most a line.
  void receive(int replies);
  void call(std::initializer_list<std::string_view> words) {
    send(command(words));
    receive(1);
  }
  // The last element of the next message of a subscription.
  std::string message();

 private:
  TcpClient link_;
};

}  // namespace pizarra::bench
