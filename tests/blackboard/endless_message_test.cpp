// A message of part after part that never ends: ZeroMQ keeps the parts and tells nobody, so that the board must end it.

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

// Says the protocol's bytes itself: ZeroMQ would keep the parts until the last.
class RawClient {
 public:
  explicit RawClient(int port) : file_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const std::string signature = std::string("\xff") + std::string(8, '\0') + "\x7f";
    const std::string mechanism = "NULL" + std::string(16, '\0');
    send(signature + std::string("\x03\x00", 2) + mechanism + std::string(32, '\0'));
    receive(64);
    const std::string ready = std::string("\x05READY\x0bSocket-Type") + std::string("\0\0\0\x06", 4) + "DEALER";
    send(std::string("\x04") + static_cast<char>(ready.size()) + ready);
    receive(static_cast<std::size_t>(receive(2)[1]));
  }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  ~RawClient() { close(file_); }

  // As much as the network takes; false when the connection is ended.
  bool send(const std::string& bytes) {
    const ssize_t sent = ::send(file_, bytes.data() + at_, bytes.size() - at_, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0) return errno == EAGAIN;
    sent_ += static_cast<std::size_t>(sent);
    at_ = (at_ + static_cast<std::size_t>(sent)) % bytes.size();
    return true;
  }
  std::size_t sent() const { return sent_; }

 private:
  std::string receive(std::size_t bytes) const {
    std::string received(bytes, '\0');
    EXPECT_EQ(recv(file_, received.data(), bytes, MSG_WAITALL), static_cast<ssize_t>(bytes));
    return received;
  }

  const int file_;
  std::size_t at_ = 0;  // of what is being sent
  std::size_t sent_ = 0;
};

class EndlessMessage : public ServerTest {
 protected:
  int port() const {
    const std::string& address = server->addresses().front();
    return std::stoi(address.substr(address.rfind(':') + 1));
  }
  // How much was sent of it before the connection was ended, or until patience did.
  std::size_t send_without_end(RawClient& raw, std::size_t part) {
    const std::string more = part < 256 ? std::string("\x01") + static_cast<char>(part)
                                        : std::string("\x03\0\0\0\0\0", 6) + static_cast<char>(part >> 16 & 0xff) +
                                              static_cast<char>(part >> 8 & 0xff) + static_cast<char>(part & 0xff);
    std::string parts;
    while (parts.size() < 65536) parts += more + std::string(part, 'x');
    for (int patience = 3000; patience > 0 && raw.send(parts); --patience) pass(executor, 1ms);
    return raw.sent();
  }
};

TEST_F(EndlessMessage, EndsItsConnectionAndIsTold) {
  Client other = client();
  const std::string session = other.join("alice");
  for (const std::size_t part : {std::size_t{1}, std::size_t{60'000}}) {
    RawClient raw(port());
    EXPECT_LT(send_without_end(raw, part), 100U << 20);
    EXPECT_FALSE(raw.send("x")) << part;
    EXPECT_TRUE(other.ask("(ping " + session + ")").is_form("pong"));
  }
  EXPECT_EQ(write(Datum::list(refusals(""))), "((bad-frame 2))");
}

TEST_F(EndlessMessage, IsNotWhatComesInManyWholeMessages) {
  Client busy = client();
  const std::string session = busy.join("alice");
  const std::string long_ping = "(ping " + session + std::string(900'000, ' ') + ")";
  for (int round = 0; round < 8; ++round) {
    for (int n = 0; n < 8; ++n) busy.send(long_ping);
    for (int n = 0; n < 8; ++n) EXPECT_TRUE(busy.receive().is_form("pong"));
    pass(executor, 60ms);
  }
  EXPECT_EQ(server->sessions(), 1U);
  EXPECT_TRUE(refusals("alice").empty());
  EXPECT_TRUE(refusals("").empty());
}

}  // namespace
}  // namespace pizarra
