#pragma once

// A client of a server under fuzz: says what it is given, and has a session again however that went.
//
//   FuzzedClient client(executor, "fuzz", address);
//   client.say("(ping " + client.session() + ")");
//   client.go_on();                                  // aborts unless the server answers

#include <cstdlib>
#include <string>
#include <string_view>

#include "blackboard/wire/wire.hpp"
#include "blackboard/wire/wire_socket.hpp"

namespace pizarra {

class FuzzedClient {
 public:
  FuzzedClient(Executor& executor, std::string name, const std::string& address, const wire::ClientKeys* keys = nullptr)
      : executor_(executor),
        name_(std::move(name)),
        socket_(executor, wire::WireSocket::Kind::dealer,
                [this](const std::string&, std::optional<std::string_view> frame) { receive(frame.value()); }) {
    if (!socket_.connect(address, keys)) std::abort();
    greet();
  }

  const std::string& session() const { return session_; }
  void say(const std::string& frame) { socket_.send({}, frame); }
  // The message may have ended the session and begun another.
  void go_on() {
    constexpr int most_sessions = 256;  // more than an input can end
    for (int i = 0; i < most_sessions; ++i) {
      is_alive_ = false;
      is_over_ = false;
      is_welcome_ = false;
      expect("(ping " + session_ + ")", [this] { return is_alive_ || is_over_ || is_welcome_; });
      if (is_alive_ && !is_over_) return;
      if (is_over_) greet();
    }
    std::abort();
  }

 private:
  void greet() {
    is_welcome_ = false;
    expect("(hello \"" + name_ + "\" 0)", [this] { return is_welcome_; });
  }
  template <class Condition>
  void expect(const std::string& frame, const Condition& heard) {
    const Time patience = executor_.now() + 10s;
    Time say_at{};
    while (!heard()) {
      if (executor_.now() > patience) std::abort();
      if (executor_.now() >= say_at && socket_.send({}, frame)) say_at = executor_.now() + 500ms;
      bool waited = false;
      const auto timer = executor_.call_at(executor_.now() + 5ms, [&] { waited = true; });
      executor_.run_until([&] { return waited || heard(); });
      executor_.cancel(timer);
    }
  }
  void receive(std::string_view frame) {
    const Result<std::vector<Datum>> messages = wire::read_messages(frame);
    if (!messages) std::abort();
    for (const Datum& message : *messages) hear(message);
  }
  void hear(const Datum& message) {
    if (message.is_form("pong")) is_alive_ = true;
    if (message.is_form("unknown-session")) is_over_ = is_over_ || is_own(message[1]);
    if (!message.is_form("welcome")) return;
    session_ = std::to_string(message[1].integer());
    is_welcome_ = true;
    is_over_ = false;
  }
  bool is_own(const Datum& session) const { return std::to_string(session.integer()) == session_; }

  Executor& executor_;
  const std::string name_;
  std::string session_ = "0";
  bool is_alive_ = false;
  bool is_over_ = false;
  bool is_welcome_ = false;
  wire::WireSocket socket_;
};

}  // namespace pizarra
