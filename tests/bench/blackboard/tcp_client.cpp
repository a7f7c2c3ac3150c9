#include "tests/bench/blackboard/tcp_client.hpp"

#include <arpa/inet.h>
#include <array>
#include <netinet/tcp.h>
#include <stdexcept>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "tests/free_port.hpp"

namespace pizarra::bench {

namespace {

bool connects(int file, int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

int new_socket() { return socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0); }

}  // namespace

void wait_for_server(int port, const std::string& name) {
  constexpr int tries = 1000;
  constexpr useconds_t pause_us = 10'000;
  for (int n = 0; n < tries; ++n) {
    if (can_connect(port)) return;
    usleep(pause_us);
  }
  throw std::runtime_error(name + " does not begin");
}

TcpClient::TcpClient(int port, std::string server) : server_(std::move(server)), file_(new_socket()) {
  const int yes = 1;
  setsockopt(file_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  if (!connects(file_, port)) throw std::system_error(errno, std::generic_category(), server_ + " does not answer");
}

TcpClient::~TcpClient() { close(file_); }

void TcpClient::send(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t sent = ::send(file_, text.data(), text.size(), MSG_NOSIGNAL);
    if (sent <= 0) throw std::runtime_error(server_ + " is gone");
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
}

std::string_view TcpClient::line() {
  std::size_t end = buffer_.find('\n', read_);
  while (end == std::string::npos) {
    read_more();
    end = buffer_.find('\n', read_);
  }
  std::string_view line = std::string_view(buffer_).substr(read_, end - read_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  read_ = end + 1;
  return line;
}

std::string_view TcpClient::bytes(std::size_t count) {
  while (buffer_.size() - read_ < count) read_more();
  const std::string_view bytes = std::string_view(buffer_).substr(read_, count);
  read_ += count;
  return bytes;
}

void TcpClient::read_more() {
  buffer_.erase(0, std::exchange(read_, 0));
  std::array<char, 65536> more;
  const ssize_t got = recv(file_, more.data(), more.size(), 0);
  if (got <= 0) throw std::runtime_error(server_ + " is gone");
  buffer_.append(more.data(), static_cast<std::size_t>(got));
}

}  // namespace pizarra::bench
