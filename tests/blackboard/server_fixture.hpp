#pragma once

// A server, and clients that say just what a test has them say.
//
//   Client client = this->client();
//   const std::string session = client.join("alice");
//   const Datum reply = client.ask("(request " + session + " 1 (ask (note ?n ?)))");

#include <deque>
#include <gtest/gtest.h>
#include <zmq.hpp>

#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {

class ServerTest : public testing::Test {
 protected:
  class Client {
   public:
    // It reads `room` messages ahead, and its network `bytes`; as many as usual where nothing is said.
    Client(Executor& executor, const std::string& address, int room = 1000, int bytes = -1)
        : executor_(executor), socket_(context_, zmq::socket_type::dealer) {
      socket_.set(zmq::sockopt::linger, 0);
      socket_.set(zmq::sockopt::rcvhwm, room);
      socket_.set(zmq::sockopt::rcvbuf, bytes);
      socket_.connect(address);
    }
    void send(const std::string& text) { ASSERT_TRUE(socket_.send(zmq::buffer(text)).has_value()); }
    void send_parts(const std::vector<std::string>& parts) {
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto flags = i + 1 < parts.size() ? zmq::send_flags::sndmore : zmq::send_flags::none;
        ASSERT_TRUE(socket_.send(zmq::buffer(parts[i]), flags).has_value());
      }
    }
    // The messages of the next frame; none when patience ends.
    std::vector<Datum> receive_frame(Duration patience = 5s) {
      zmq::message_t frame;
      const Time deadline = executor_.now() + patience;
      bool over = false;
      while (!socket_.recv(frame, zmq::recv_flags::dontwait)) {
        if (over) return {};
        pass(executor_, 1ms);
        over = executor_.now() >= deadline;
      }
      return wire::read_messages(frame.to_string_view()).value();
    }
    // The next message, or an empty list when patience ends.
    Datum receive(Duration patience = 5s) {
      if (heard_.empty()) std::ranges::copy(receive_frame(patience), std::back_inserter(heard_));
      if (heard_.empty()) return {};
      Datum message = std::move(heard_.front());
      heard_.pop_front();
      return message;
    }
    Datum ask(const std::string& text) {
      send(text);
      return receive();
    }
    std::string join(const std::string& teller) {
      const Datum welcome = ask("(hello \"" + teller + "\" 0)");
      EXPECT_TRUE(welcome.is_form("welcome"));
      return welcome.size() == 3 ? write(welcome[1]) : "0";
    }

   private:
    Executor& executor_;
    zmq::context_t context_{1};
    zmq::socket_t socket_;
    std::deque<Datum> heard_;
  };

  ServerTest() {
    EXPECT_TRUE(board.declare("test", {relation("(relation note ((n integer) (text datum)) (key n))")}).has_value());
    serve(10s);
  }
  void serve(Duration session_length, memory::ClientRequests::Limit requests = {}) {
    server::BoardServerOptions options;
    options.addresses = {"tcp://127.0.0.1:*"};
    options.session_length = session_length;
    options.requests = requests;
    server = server::BoardServer::open(executor, board, options).value();
  }
  static void pass(Executor& executor, Duration time) {
    bool passed = false;
    executor.call_at(executor.now() + time, [&] { passed = true; });
    executor.run_until([&] { return passed; });
  }
  Client client() { return {executor, server->addresses().front()}; }
  // (SYMBOL COUNT) of what the server refused this client, once it is told.
  std::vector<Datum> refusals(const std::string& teller) {
    pass(executor, 2 * server::Refusals::pause);
    const Query asked = query_for(list("board-refusal"_sym, teller, "?symbol"_sym, "?count"_sym, "?"_sym));
    std::vector<Datum> counts;
    const Result<Answers> told = board.ask(asked);
    for (const Answer& answer : told->answers) {
      counts.push_back(list(*answer.bindings.find("?symbol"), *answer.bindings.find("?count")));
    }
    return counts;
  }

  RealExecutor executor;
  memory::MemoryBoard board{executor};
  std::unique_ptr<server::BoardServer> server;
};

}  // namespace pizarra
