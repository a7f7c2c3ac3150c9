#include "tests/agents/console/raw_client.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra::console {

namespace {

constexpr std::chrono::seconds patience{10};
constexpr std::string_view stamp_head = "{\"pulse\":";

}  // namespace

int RawClient::Frame::close_code() const {
  if (kind != closing || payload.size() < 2) return 0;
  return static_cast<unsigned char>(payload[0]) << 8 | static_cast<unsigned char>(payload[1]);
}

RawClient::RawClient(int port, int receive_bytes) : file_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (receive_bytes > 0) setsockopt(file_, SOL_SOCKET, SO_RCVBUF, &receive_bytes, sizeof receive_bytes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error("the console does not listen");
  }
}

RawClient::~RawClient() { ::close(file_); }

// A connection that the other side has closed is no failure of a test.
void RawClient::send(const std::string& bytes) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t taken = ::send(file_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (taken <= 0) return;
    sent += static_cast<std::size_t>(taken);
  }
}

void RawClient::send_frame(int kind, const std::string& payload) { send(frame_of(kind, payload)); }

std::string RawClient::frame_of(int kind, const std::string& payload) {
  std::string frame(1, static_cast<char>(0x80 | kind));
  if (payload.size() < 126) {
    frame += static_cast<char>(0x80 | payload.size());
  } else {
    const bool short_enough = payload.size() < 65536;
    frame += static_cast<char>(0x80 | (short_enough ? 126 : 127));
    for (int shift = short_enough ? 8 : 56; shift >= 0; shift -= 8) frame += static_cast<char>(payload.size() >> shift);
  }
  // The mask of zeros leaves the payload as it is.
  return frame + std::string(4, '\0') + payload;
}

bool RawClient::fill(std::size_t size) {
  while (read_.size() < size) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - std::chrono::steady_clock::now());
    pollfd readable{.fd = file_, .events = POLLIN, .revents = 0};
    if (left.count() <= 0 || ::poll(&readable, 1, static_cast<int>(left.count())) <= 0) return false;
    char buffer[65536];
    const ssize_t got = ::recv(file_, buffer, sizeof buffer, 0);
    if (got <= 0) return false;
    read_.append(buffer, static_cast<std::size_t>(got));
  }
  return true;
}

std::string RawClient::read_head() {
  deadline_ = std::chrono::steady_clock::now() + patience;
  std::size_t end = read_.find("\r\n\r\n");
  while (end == std::string::npos) {
    if (!fill(read_.size() + 1)) return read_;
    end = read_.find("\r\n\r\n");
  }
  const std::string head = read_.substr(0, end);
  read_.erase(0, end + 4);
  return head;
}

std::optional<RawClient::Frame> RawClient::read_frame() {
  deadline_ = std::chrono::steady_clock::now() + patience;
  std::optional<Frame> frame = read_any_frame();
  while (frame && frame->payload.starts_with(stamp_head)) frame = read_any_frame();
  return frame;
}

std::int64_t RawClient::read_stamp() {
  deadline_ = std::chrono::steady_clock::now() + patience;
  std::optional<Frame> frame = read_any_frame();
  while (frame && !frame->payload.starts_with(stamp_head)) frame = read_any_frame();
  return frame ? std::stoll(frame->payload.substr(stamp_head.size())) : 0;
}

std::optional<RawClient::Frame> RawClient::read_any_frame() {
  if (!fill(2)) return std::nullopt;
  const auto byte = [this](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(read_[at])); };
  std::size_t size = byte(1) & 127;
  std::size_t head = 2;
  if (size >= 126) {
    const std::size_t bytes = size == 126 ? 2 : 8;
    if (!fill(2 + bytes)) return std::nullopt;
    size = 0;
    for (std::size_t i = 0; i < bytes; ++i) size = size << 8 | byte(2 + i);
    head += bytes;
  }
  if (!fill(head + size)) return std::nullopt;
  Frame frame{.kind = static_cast<int>(byte(0) & 15), .payload = read_.substr(head, size)};
  read_.erase(0, head + size);
  return frame;
}

std::string request_text(int port, const std::string& method, const std::string& path, const Headers& headers) {
  Headers all{{"Host", fmt::format("127.0.0.1:{}", port)}, {"Origin", fmt::format("http://127.0.0.1:{}", port)}};
  for (const auto& [name, value] : headers) all[name] = value;
  std::string text = fmt::format("{} {} HTTP/1.1\r\n", method, path);
  for (const auto& [name, value] : all) {
    if (!value.empty()) text += fmt::format("{}: {}\r\n", name, value);
  }
  return text + "\r\n";
}

Headers upgrade_headers(const std::string& cookie) {
  return {{"Upgrade", "websocket"},
          {"Connection", "Upgrade"},
          {"Sec-WebSocket-Version", "13"},
          {"Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ=="},
          {"Cookie", cookie}};
}

}  // namespace pizarra::console
