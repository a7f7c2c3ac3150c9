#include "tests/bench/blackboard/redis.hpp"

#include <arpa/inet.h>
#include <filesystem>
#include <netinet/tcp.h>
#include <stdexcept>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace pizarra::bench {

namespace {

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

// One that nobody listens at just now.
int free_port() {
  const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof address;
  bind(file, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(file, reinterpret_cast<sockaddr*>(&address), &size);
  close(file);
  return ntohs(address.sin_port);
}

}  // namespace

std::optional<RedisServer> RedisServer::start(const std::vector<std::string>& options) {
  const std::optional<std::string> program = find_program("redis-server");
  if (!program) return std::nullopt;
  std::string folder = std::filesystem::temp_directory_path() / "pizarra-bench-redis-XXXXXX";
  if (mkdtemp(folder.data()) == nullptr) throw std::system_error(errno, std::generic_category(), "mkdtemp");
  const int port = free_port();
  std::vector<std::string> command = {*program, "--port", std::to_string(port), "--bind", "127.0.0.1", "--dir", folder,
                                      "--save", ""};
  command.insert(command.end(), options.begin(), options.end());
  Child process = Child::program(command);
  while (process.pipe().hear_line().find("Ready to accept connections") == std::string::npos) {
  }
  return RedisServer(std::move(process), std::move(folder), port);
}

RedisServer::~RedisServer() {
  if (!folder_.empty()) std::filesystem::remove_all(folder_);
}

RedisClient::RedisClient(int port) : file_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_in address = loopback(port);
  const int yes = 1;
  setsockopt(file_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  if (connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::system_error(errno, std::generic_category(), "redis does not answer");
  }
}

RedisClient::~RedisClient() { close(file_); }

std::string RedisClient::command(std::initializer_list<std::string_view> words) {
  std::string text = "*" + std::to_string(words.size()) + "\r\n";
  for (const std::string_view word : words) {
    text += "$" + std::to_string(word.size()) + "\r\n";
    text += word;
    text += "\r\n";
  }
  return text;
}

void RedisClient::send(std::string_view commands) const {
  while (!commands.empty()) {
    const ssize_t sent = ::send(file_, commands.data(), commands.size(), MSG_NOSIGNAL);
    if (sent <= 0) throw std::runtime_error("redis is gone");
    commands.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void RedisClient::receive(int replies) {
  for (int i = 0; i < replies; ++i) {
    const std::string first = line();
    if (first.starts_with("-")) throw std::runtime_error("redis refuses: " + first);
    if (first.starts_with("$")) line();
  }
}

std::string RedisClient::message() {
  // *3, then length and text of each.
  std::string last;
  for (int lines = 0; lines < 7; ++lines) last = line();
  return last;
}

std::string RedisClient::line() {
  std::size_t end = buffer_.find("\r\n");
  while (end == std::string::npos) {
    char more[65536];
    const ssize_t got = recv(file_, more, sizeof more, 0);
    if (got <= 0) throw std::runtime_error("redis is gone");
    buffer_.append(more, static_cast<std::size_t>(got));
    end = buffer_.find("\r\n");
  }
  std::string out = buffer_.substr(0, end);
  buffer_.erase(0, end + 2);
  return out;
}

}  // namespace pizarra::bench
