#pragma once

// A console on a board of this process, and what a browser does to get in. The client runs on a thread of its own while
// the console serves.

#include <fmt/format.h>
#include <future>
#include <gtest/gtest.h>

#include "agents/console/console.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/agents/console/raw_client.hpp"
#include "tests/run_task.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::console {

inline testing::AssertionResult has(const std::string& text, std::string_view part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess() << text << " has " << part;
  return testing::AssertionFailure() << text << " has no " << part;
}

inline testing::AssertionResult begins(const std::string& text, std::string_view part) {
  if (text.starts_with(part)) return testing::AssertionSuccess() << text << " begins with " << part;
  return testing::AssertionFailure() << text << " does not begin with " << part;
}

class ConsoleTest : public testing::Test {
 protected:
  ConsoleTest() : board_(executor_), here_(board_.view("test")) {
    reopen([](Console::Setup&) {});
  }

  // A console that is set up otherwise takes the place of the one before.
  void reopen(const std::function<void(Console::Setup&)>& change) {
    console_.reset();
    const Console::BoardMaker maker = [this](const std::string& name,
                                             const std::string&) -> Result<std::unique_ptr<Board>> {
      return board_.view(name);
    };
    Console::Setup setup{executor_, streams_, maker, cell_, "console", source_dir() + "/agents/console/page/built"};
    setup.foxglove = Console::Foxglove{{"https://viewer.example"}};
    change(setup);
    console_ = Console::open(std::move(setup)).value();
    const std::string address = console_->address();
    const std::size_t colon = address.rfind(':');
    port_ = std::stoi(address.substr(colon + 1));
    token_ = address.substr(address.find('#') + 1);
  }

  // Serves until what the client does is done.
  template <class Client>
  auto serve(Client client) {
    auto done = std::async(std::launch::async, std::move(client));
    executor_.run_until([&] { return done.wait_for(std::chrono::seconds(0)) == std::future_status::ready || tick(); });
    return done.get();
  }

  // The client's thread wakes nobody here.
  bool tick() {
    if (ticking_) return false;
    ticking_ = true;
    executor_.call_at(executor_.now() + 2ms, [this] { ticking_ = false; });
    return false;
  }

  std::string head(const std::string& method, const std::string& path, const Headers& headers = {}) {
    return serve([=, port = port_] {
      RawClient client(port);
      client.send(request_text(port, method, path, headers));
      return client.read_head();
    });
  }

  // `NAME=VALUE`, in exchange for the token.
  std::string cookie() {
    const std::string answer = head("POST", "/session", {{"Authorization", "Bearer " + token_}});
    const std::size_t begin = answer.find("Set-Cookie: ") + 12;
    return answer.substr(begin, answer.find(';', begin) - begin);
  }

  // What a page is told first.
  std::string hello() {
    return serve([port = port_, own = cookie()] {
      RawClient client(port);
      client.send(request_text(port, "GET", "/socket", upgrade_headers(own)));
      client.read_head();
      const auto frame = client.read_frame();
      return frame ? frame->payload : std::string("nothing");
    });
  }

  // Said hello to.
  std::unique_ptr<RawClient> page(const std::string& cookie, int receive_bytes = 0) {
    return serve([=, port = port_] {
      auto client = std::make_unique<RawClient>(port, receive_bytes);
      client->send(request_text(port, "GET", "/socket", upgrade_headers(cookie)));
      client->read_head();
      const auto hello = client->read_frame();
      EXPECT_TRUE(hello && hello->payload.starts_with("{\"hello\"")) << (hello ? hello->payload : "nothing");
      return client;
    });
  }

  // One more connection of the page `number`, for its images.
  std::unique_ptr<RawClient> lane(const std::string& cookie, int number = 1) {
    return serve([=, port = port_] {
      auto client = std::make_unique<RawClient>(port);
      client->send(request_text(port, "GET", fmt::format("/socket/{}", number), upgrade_headers(cookie)));
      EXPECT_TRUE(begins(client->read_head(), "HTTP/1.1 101"));
      return client;
    });
  }

  // What the page is told next.
  std::string said(RawClient& client, const std::string& form) {
    return serve([&] {
      client.send_frame(RawClient::text, form);
      const auto frame = client.read_frame();
      return frame ? frame->payload : std::string("nothing");
    });
  }

  void declare(const std::string& relation) {
    const std::vector<Relation> relations{relation_from_datum(read_one(relation).value()).value()};
    ASSERT_TRUE(run(executor_, here_->declare(relations)));
  }

  RealExecutor executor_;
  const CellView cell_;
  LocalStreams streams_;
  memory::MemoryBoard board_;
  std::unique_ptr<Board> here_;
  std::unique_ptr<Console> console_;
  int port_ = 0;
  std::string token_;
  bool ticking_ = false;
};

}  // namespace pizarra::console
