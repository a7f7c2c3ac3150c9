#pragma once

// HTTP on loopback, or with TLS where it is told to, and the sockets of connections that leave HTTP: libmicrohttpd on
// the executor, by its epoll descriptor.
//
//   auto server = HttpServer::listen(executor, {}, [](const HttpRequest& request) {
//     return HttpAnswer{.status = 200, .type = "text/plain", .body = "hello"};
//   });
//   (*server)->port();
//
// No request has a body: one that says it has is refused, as is one whose head does not fit into 16 kB. A connection
// that says nothing for ten seconds ends; 160 are open at once at most. Where an address of clients has a bound, it is
// told so beyond that (503), and beyond 16 more its connections end unanswered.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"

struct MHD_Daemon;
struct MHD_UpgradeResponseHandle;

namespace pizarra::web {

// In figures, of IPv4 or IPv6.
bool is_ip_address(const std::string& text);

// The socket of a connection that left HTTP. Destroying it closes the connection; the server outlives it.
class UpgradedSocket {
 public:
  UpgradedSocket(MHD_UpgradeResponseHandle* handle, int file, std::string first_bytes)
      : handle_(handle), file_(file), first_bytes_(std::move(first_bytes)) {}
  UpgradedSocket(UpgradedSocket&& other) noexcept
      : handle_(std::exchange(other.handle_, nullptr)),
        file_(other.file_),
        first_bytes_(std::move(other.first_bytes_)) {}
  UpgradedSocket& operator=(UpgradedSocket&&) = delete;
  ~UpgradedSocket();

  int file() const { return file_; }
  // What had come behind the request's head already.
  std::string take_first_bytes() { return std::exchange(first_bytes_, {}); }

 private:
  MHD_UpgradeResponseHandle* handle_;
  int file_;
  std::string first_bytes_;
};

// Headers that were not sent are empty.
struct HttpRequest {
  std::string method;
  std::string path;
  std::string host;
  std::string origin;
  std::string cookies;
  std::string authorization;
  std::string upgrade;
  std::string web_socket_key;
  std::string web_socket_version;
  std::string web_socket_protocols;
  std::string token;  // `?token=...`
};

struct HttpAnswer {
  unsigned status = 200;
  std::string type = {};
  std::string body = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
  // Of status 101: who gets the socket.
  std::function<void(UpgradedSocket)> upgraded = nullptr;
};

class HttpServer {
 public:
  using Handler = std::function<HttpAnswer(const HttpRequest&)>;

  // With a certificate and its key, both as PEM, it speaks TLS and nothing else.
  struct Place {
    std::string address = "127.0.0.1";  // in figures
    int port = 0;                       // 0: any that is free
    std::string certificate = {};
    std::string certificate_key = {};
    unsigned max_of_address = 0;  // connections of one client's address; 0: as many as there are
  };

  // Failure: cannot-listen.
  static Result<std::unique_ptr<HttpServer>> listen(Executor& executor, const Place& place, Handler handler);
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  int port() const { return port_; }

 private:
  struct Callbacks;
  HttpServer(Executor& executor, Handler handler, unsigned max_of_address)
      : executor_(executor), handler_(std::move(handler)), max_of_address_(max_of_address) {}
  void run();

  Executor& executor_;
  Handler handler_;
  const unsigned max_of_address_;
  std::map<std::string, unsigned> open_;  // connections of each client's address
  MHD_Daemon* daemon_ = nullptr;
  int port_ = 0;
  int file_ = -1;
  Executor::TimerId timer_ = 0;
};

}  // namespace pizarra::web
