#pragma once

// A server in virtual time, and clients that say just what a test has them say: what arrives between two turns of the
// server does not depend on how busy the machine is.
//
//   Client client(*this, "alice");
//   const std::string session = client.join();
//   const Datum reply = client.ask("(request " + session + " 1 (ask (note ?n ?)))");

#include <deque>
#include <gtest/gtest.h>

#include "blackboard/server/board_server.hpp"
#include "blackboard/simulated/network.hpp"
#include "blackboard/simulated/process.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra::simulated {

class SimulatedServer : public testing::Test {
 protected:
  class Client {
   public:
    Client(SimulatedServer& test, std::string name)
        : test_(test), name_(std::move(name)), wires_(test.network_.plug(name_, test.process_)) {
      socket_ = wires_->open(test.process_, wire::FrameSocket::Kind::dealer,
                             [this](const std::string&, std::optional<std::string_view> frame) {
                               const std::vector<Datum> messages = wire::read_messages(frame.value()).value();
                               heard_.insert(heard_.end(), messages.begin(), messages.end());
                             });
      EXPECT_TRUE(socket_->connect(address, nullptr, {}).has_value());
      test.pass(frame_delay);
    }
    void send(const std::string& frame) { ASSERT_TRUE(socket_->send("", frame)); }
    // The next message, or an empty list when patience ends.
    Datum receive(Duration patience = 5s) {
      const Time deadline = test_.time_.now() + patience;
      test_.time_.run_until([&] { return !heard_.empty() || test_.time_.now() > deadline; });
      if (heard_.empty()) return {};
      Datum message = std::move(heard_.front());
      heard_.pop_front();
      return message;
    }
    Datum ask(const std::string& frame) {
      send(frame);
      return receive();
    }
    std::string join() {
      const Datum welcome = ask("(hello \"" + name_ + "\" 0)");
      EXPECT_TRUE(welcome.is_form("welcome"));
      return welcome.size() == 3 ? write(welcome[1]) : "0";
    }

   private:
    SimulatedServer& test_;
    const std::string name_;
    const std::unique_ptr<wire::Transport> wires_;
    std::unique_ptr<wire::FrameSocket> socket_;
    std::deque<Datum> heard_;
  };

  SimulatedServer() {
    EXPECT_TRUE(board.declare("test", {relation("(relation note ((n integer) (text datum)) (key n))")}).has_value());
    serve();
  }
  void serve() {
    server::BoardServerOptions options;
    options.addresses = {address};
    options.transport = wires_.get();
    server = server::BoardServer::open(process_, board, options).value();
  }
  void pass(Duration time) { time_.run_for(time); }

  static constexpr const char* address = "tcp://127.0.0.1:7000";
  static constexpr Duration frame_delay = 10us;

  VirtualExecutor time_;
  Network network_{time_, Random(1), {.least = frame_delay, .most = frame_delay}};
  Process process_{time_, {}};
  const std::unique_ptr<wire::Transport> wires_ = network_.plug("board", process_);
  memory::MemoryBoard board{process_};
  std::unique_ptr<server::BoardServer> server;
};

}  // namespace pizarra::simulated
