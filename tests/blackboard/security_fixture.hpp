#pragma once

// A board that asks for keys, and clients that come with them.
//
//   TEST_F(SecurityTest, ...) {
//     serve();
//     const auto robot = view("robot");                // comes with the key of its name
//     EXPECT_EQ(tell(*robot, "(arm idle)"), "ok");

#include <filesystem>
#include <gtest/gtest.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {

class SecurityTest : public testing::Test, public Wall {
 protected:
  SecurityTest() {
    std::filesystem::remove_all(folder_);
    EXPECT_TRUE(wire::make_keys(folder_, "board", {}).has_value());
    EXPECT_TRUE(wire::make_keys(folder_, "boss", {{"*"}, {"*"}, {"*"}, {}}).has_value());
    EXPECT_TRUE(wire::make_keys(folder_, "robot", {{"arm", "agent"}, {"job"}, {"arm*", "job"}, {}}).has_value());
  }
  ~SecurityTest() override { std::filesystem::remove_all(folder_); }

  void serve(Duration session_length = 800ms) {
    server::BoardServerOptions options;
    options.addresses = {"tcp://127.0.0.1:*", ipc_};
    options.keys = folder_;
    options.session_length = session_length;
    server_ = server::BoardServer::open(executor_, board_, options).value();
    const std::unique_ptr<Board> boss = view("boss");
    EXPECT_EQ(
        symbol_of(run(boss->declare(
            {relation("(relation arm ((state symbol)) (key))"), relation("(relation arm-pose ((x number)) (key))"),
             relation("(relation agent ((name symbol)) (key name))"), relation("(relation job ((n integer)) (key n))"),
             relation("(relation goal ((n integer)) (key n))")}))),
        "ok");
  }
  std::string tcp() const { return server_->addresses().front(); }
  std::string secret_of(const std::string& name) const { return folder_ + "/" + name + ".secret"; }

  Executor& executor() override { return executor_; }
  // Comes with the key of its name.
  std::unique_ptr<Board> view(const std::string& name) override { return view(name, name); }
  std::unique_ptr<Board> view(const std::string& key, const std::string& teller, Duration timeout = 5s) {
    return client::RemoteBoard::connect(executor_, tcp(), teller, timeout,
                                        wire::read_client_keys(secret_of(key)).value())
        .value();
  }
  std::string tell(Board& board, const std::string& fact, LeaseId lease = 0) {
    Transaction transaction;
    transaction.tell(read(fact), {}, lease);
    return symbol_of(run(board.transact(transaction)));
  }
  std::string retract(Board& board, const std::string& pattern) { return symbol_of(run(board.retract(read(pattern)))); }
  std::string ask(Board& board, const std::string& text) { return symbol_of(run(board.ask(query(text)))); }

  // The newest refusals of a client, once they are told.
  std::vector<Fact> refusals(const std::string& client) {
    pass(2 * server::Refusals::pause);
    const auto answers = board_.ask(query_for(list("board-refusal"_sym, client, "?"_sym, "?"_sym, "?"_sym)));
    std::vector<Fact> facts;
    for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front());
    return facts;
  }

  const std::string ipc_ = ipc_address();
  const std::string folder_ = ipc_.substr(6) + ".keys";
  RealExecutor executor_;
  memory::MemoryBoard board_{executor_};
  std::unique_ptr<server::BoardServer> server_;
};

}  // namespace pizarra
