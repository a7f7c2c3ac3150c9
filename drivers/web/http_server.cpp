#include "drivers/web/http_server.hpp"

#include <arpa/inet.h>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <optional>

#include "lisp/outside_text.hpp"

namespace pizarra::web {

namespace {

constexpr unsigned max_connections = 160;
constexpr unsigned unanswered = 16;  // connections of an address that has its share
constexpr unsigned silence_seconds = 10;
constexpr std::size_t head_bytes = 16 << 10;
constexpr const char* tls_versions = "SECURE128:-VERS-TLS-ALL:+VERS-TLS1.3:+VERS-TLS1.2";

std::string value_of(MHD_Connection* connection, MHD_ValueKind kind, const char* name) {
  const char* value = MHD_lookup_connection_value(connection, kind, name);
  return value == nullptr ? std::string() : std::string(value);
}

std::string header_of(MHD_Connection* connection, const char* name) {
  return value_of(connection, MHD_HEADER_KIND, name);
}

// Small messages are sent without waiting until the browser has acknowledged those before them.
void hasten(int file) {
  constexpr int on = 1;
  setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

// As bytes, without the port.
std::string client_of(MHD_Connection* connection) {
  const sockaddr* at = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS)->client_addr;
  if (at->sa_family == AF_INET6) {
    const in6_addr& six = reinterpret_cast<const sockaddr_in6*>(at)->sin6_addr;
    return {reinterpret_cast<const char*>(&six), sizeof six};
  }
  const in_addr& four = reinterpret_cast<const sockaddr_in*>(at)->sin_addr;
  return {reinterpret_cast<const char*>(&four), sizeof four};
}

// Of IPv4 or IPv6; nothing for a name.
std::optional<sockaddr_storage> address_in_figures(const std::string& text, std::uint16_t port) {
  sockaddr_storage storage{};
  auto* four = reinterpret_cast<sockaddr_in*>(&storage);
  auto* six = reinterpret_cast<sockaddr_in6*>(&storage);
  if (inet_pton(AF_INET, text.c_str(), &four->sin_addr) == 1) {
    four->sin_family = AF_INET;
    four->sin_port = htons(port);
    return storage;
  }
  if (inet_pton(AF_INET6, text.c_str(), &six->sin6_addr) != 1) return std::nullopt;
  six->sin6_family = AF_INET6;
  six->sin6_port = htons(port);
  return storage;
}

bool has_body(MHD_Connection* connection) {
  const std::string length = header_of(connection, "Content-Length");
  return (!length.empty() && length != "0") || !header_of(connection, "Transfer-Encoding").empty();
}

HttpRequest request_of(MHD_Connection* connection, const char* method, const char* path) {
  return {.method = method,
          .path = path,
          .host = header_of(connection, "Host"),
          .origin = header_of(connection, "Origin"),
          .cookies = header_of(connection, "Cookie"),
          .authorization = header_of(connection, "Authorization"),
          .upgrade = header_of(connection, "Upgrade"),
          .web_socket_key = header_of(connection, "Sec-WebSocket-Key"),
          .web_socket_version = header_of(connection, "Sec-WebSocket-Version"),
          .web_socket_protocols = header_of(connection, "Sec-WebSocket-Protocol"),
          .token = value_of(connection, MHD_GET_ARGUMENT_KIND, "token")};
}

}  // namespace

bool is_ip_address(const std::string& text) { return address_in_figures(text, 0).has_value(); }

UpgradedSocket::~UpgradedSocket() {
  if (handle_ != nullptr) MHD_upgrade_action(handle_, MHD_UPGRADE_ACTION_CLOSE);
}

// What libmicrohttpd calls; all from within MHD_run.
struct HttpServer::Callbacks {
  // One request, from its head to its end.
  struct Exchange {
    std::function<void(UpgradedSocket)> upgraded;
    bool begun = false;
  };

  static MHD_Result handle(void* server, MHD_Connection* connection, const char* path, const char* method, const char*,
                           const char*, std::size_t*, void** exchange) {
    if (*exchange == nullptr) *exchange = new Exchange;
    auto& here = *static_cast<Exchange*>(*exchange);
    const bool refused = has_body(connection);
    // The head alone is there; what is to be answered is so the next time.
    if (!here.begun && !refused) {
      here.begun = true;
      return MHD_YES;
    }
    HttpAnswer answer{.status = MHD_HTTP_CONTENT_TOO_LARGE};
    if (!refused) answer = answer_to(*static_cast<HttpServer*>(server), connection, method, path);
    here.upgraded = std::move(answer.upgraded);
    return queue(connection, answer, here.upgraded != nullptr);
  }

  static HttpAnswer answer_to(const HttpServer& server, MHD_Connection* connection, const char* method,
                              const char* path) {
    const unsigned most = server.max_of_address_;
    const auto own = server.open_.find(client_of(connection));
    if (most == 0 || own == server.open_.end() || own->second <= most) {
      return server.handler_(request_of(connection, method, path));
    }
    return {.status = MHD_HTTP_SERVICE_UNAVAILABLE,
            .type = "text/plain; charset=utf-8",
            .body = fmt::format("your address has {} connections open already: close a page\n", most),
            .headers = {{"Connection", "close"}}};
  }

  static void connected(void* server, MHD_Connection* connection, void**, MHD_ConnectionNotificationCode what) {
    auto& open = static_cast<HttpServer*>(server)->open_;
    const std::string client = client_of(connection);
    if (what == MHD_CONNECTION_NOTIFY_STARTED) {
      ++open[client];
    } else if (--open[client] == 0) {
      open.erase(client);
    }
  }

  static MHD_Result queue(MHD_Connection* connection, HttpAnswer& answer, bool upgrades) {
    MHD_Response* response =
        upgrades ? MHD_create_response_for_upgrade(&upgrade, nullptr)
                 : MHD_create_response_from_buffer(answer.body.size(), answer.body.data(), MHD_RESPMEM_MUST_COPY);
    if (response == nullptr) return MHD_NO;
    if (!answer.type.empty()) MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, answer.type.c_str());
    for (const auto& [name, value] : answer.headers) MHD_add_response_header(response, name.c_str(), value.c_str());
    const MHD_Result queued = MHD_queue_response(connection, answer.status, response);
    MHD_destroy_response(response);
    return queued;
  }

  static void upgrade(void*, MHD_Connection* connection, void* exchange, const char* first, std::size_t size,
                      MHD_socket file, MHD_UpgradeResponseHandle* handle) {
    // With TLS `file` is a pipe to the library, which has the connection.
    hasten(MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD)->connect_fd);
    static_cast<Exchange*>(exchange)->upgraded(UpgradedSocket(handle, file, std::string(first, size)));
  }

  static void completed(void*, MHD_Connection*, void** exchange, MHD_RequestTerminationCode) {
    delete static_cast<Exchange*>(*exchange);
    *exchange = nullptr;
  }

  // What a client does wrong is no news here.
  static void log(void*, const char*, va_list) {}
};

Result<std::unique_ptr<HttpServer>> HttpServer::listen(Executor& executor, const Place& place, Handler handler) {
  std::unique_ptr<HttpServer> server(new HttpServer(executor, std::move(handler), place.max_of_address));
  const auto port = static_cast<std::uint16_t>(place.port);
  const std::optional<sockaddr_storage> address = address_in_figures(place.address, port);
  if (!address) return fail("cannot-listen", fmt::format("{} is no IP address", text_of_bytes(place.address)));
  const bool secure = !place.certificate.empty();
  std::vector<MHD_OptionItem> options;
  if (secure) {
    options = {{MHD_OPTION_HTTPS_MEM_CERT, 0, const_cast<char*>(place.certificate.c_str())},
               {MHD_OPTION_HTTPS_MEM_KEY, 0, const_cast<char*>(place.certificate_key.c_str())},
               {MHD_OPTION_HTTPS_PRIORITIES, 0, const_cast<char*>(tls_versions)}};
  }
  if (place.max_of_address != 0) {
    options.push_back({MHD_OPTION_PER_IP_CONNECTION_LIMIT, place.max_of_address + unanswered, nullptr});
  }
  options.push_back({MHD_OPTION_END, 0, nullptr});
  const unsigned flags = MHD_USE_EPOLL | MHD_ALLOW_UPGRADE | MHD_USE_ERROR_LOG | (secure ? MHD_USE_TLS : MHD_NO_FLAG) |
                         (address->ss_family == AF_INET6 ? MHD_USE_IPv6 : MHD_NO_FLAG);
  errno = 0;
  server->daemon_ = MHD_start_daemon(
      flags, port, nullptr, nullptr, &Callbacks::handle, server.get(), MHD_OPTION_EXTERNAL_LOGGER, &Callbacks::log,
      nullptr, MHD_OPTION_SOCK_ADDR, &*address, MHD_OPTION_NOTIFY_COMPLETED, &Callbacks::completed, nullptr,
      MHD_OPTION_CONNECTION_LIMIT, max_connections, MHD_OPTION_CONNECTION_TIMEOUT, silence_seconds,
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, head_bytes, MHD_OPTION_STRICT_FOR_CLIENT, 1, MHD_OPTION_NOTIFY_CONNECTION,
      &Callbacks::connected, server.get(), MHD_OPTION_ARRAY, options.data(), MHD_OPTION_END);
  if (server->daemon_ == nullptr) {
    const char* refused = secure ? "it is refused, or the certificate and its key are no such pair" : "it is refused";
    const std::string why = errno == 0 ? refused : std::strerror(errno);
    return fail("cannot-listen", fmt::format("cannot listen on port {} of {}: {}", port, place.address, why));
  }
  server->port_ = MHD_get_daemon_info(server->daemon_, MHD_DAEMON_INFO_BIND_PORT)->port;
  server->file_ = MHD_get_daemon_info(server->daemon_, MHD_DAEMON_INFO_EPOLL_FD)->epoll_fd;
  executor.watch_readable(server->file_, [self = server.get()] { self->run(); });
  return server;
}

HttpServer::~HttpServer() {
  if (daemon_ == nullptr) return;
  executor_.cancel(timer_);
  executor_.unwatch_readable(file_);
  // Lets go of the sockets that have been closed since.
  MHD_run(daemon_);
  MHD_stop_daemon(daemon_);
}

// Does what can be done now, and comes again when the next connection has been silent for too long.
void HttpServer::run() {
  MHD_run(daemon_);
  executor_.cancel(timer_);
  timer_ = 0;
  MHD_UNSIGNED_LONG_LONG milliseconds = 0;
  if (MHD_get_timeout(daemon_, &milliseconds) != MHD_YES) return;
  timer_ = executor_.call_at(executor_.now() + std::chrono::milliseconds(milliseconds), [this] { run(); });
}

}  // namespace pizarra::web
