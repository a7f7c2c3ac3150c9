// All clients' behaviour with a board that refuses their messages: it reaches whom it concerns, in the board's words.

#include <gtest/gtest.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/python_wall.hpp"

namespace pizarra {
namespace {

struct ClientKind {
  std::string name;
};
void PrintTo(const ClientKind& kind, std::ostream* out) { *out << kind.name; }

// A server of the test's own: it refuses transactions and answers questions.
class RefusedTest : public testing::TestWithParam<ClientKind>, public Wall {
 protected:
  RefusedTest() { EXPECT_TRUE(server_.bind(address_).has_value()); }

  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    if (GetParam().name == "remote") return client::RemoteBoard::connect(executor_, address_, teller).value();
    if (!python_) python_.emplace(executor_, python_kind(GetParam().name));
    return python_->view(address_, teller);
  }
  void receive(const std::string& client, std::string_view frame) {
    const Datum message = wire::read_frame(frame).value();
    const auto say = [&](const Datum& said) { server_.send(client, write(said)); };
    const Datum refusal = list("fail"_sym, "bad-frame"_sym, "not as a board likes it", list());
    if (message.is_form("hello")) {
      ++hellos_;
      const bool read = welcomes_ && message.size() <= longest_hello_;
      if (hellos_ <= unanswered_) return;
      for (; unanswered_ > 0; --unanswered_) say(list("refused"_sym, refusal));
      return say(read ? list("welcome"_sym, 7, 1) : list("refused"_sym, refusal));
    }
    if (!message.is_form("request")) return;
    if (message[3].is_form("transact")) return say(list("refused"_sym, refusal));
    if (message[3].is_form("take")) return say(list("reply"_sym, message[2], refusal));
    if (message[3].is_form("ask")) say(list("reply"_sym, message[2], list("ok"_sym, list(5))));
  }

  const std::string address_ = ipc_address();
  bool welcomes_ = true;
  std::size_t longest_hello_ = 5;  // that it can read
  int hellos_ = 0;
  int unanswered_ = 0;  // of them, until the next one comes
  RealExecutor executor_;
  wire::WireSocket server_{
      executor_, wire::WireSocket::Kind::router,
      [this](const std::string& client, std::optional<std::string_view> frame) { receive(client, frame.value()); }};
  std::optional<PythonProcess> python_;
};

TEST_P(RefusedTest, WhatIsRefusedOnceJoinedFailsAtOnceWithTheBoardsSentence) {
  const std::unique_ptr<Board> board = view("alice");
  EXPECT_EQ(symbol_of(run(board->ask(query("(on ?x ?y)")))), "ok");
  const Time before = executor_.now();
  const Result<Revision> told = run(board->tell(read("(on a b)")));
  ASSERT_EQ(symbol_of(told), "bad-frame");
  EXPECT_EQ(told.error().sentence, "not as a board likes it");
  const Result<std::optional<Fact>> taken = run(board->take(read("(on a ?)"), 0));
  ASSERT_EQ(symbol_of(taken), "bad-frame");
  EXPECT_EQ(taken.error().sentence, "not as a board likes it");
  EXPECT_LT(executor_.now() - before, 4s) << "not when its patience ends";
  EXPECT_EQ(symbol_of(run(board->ask(query("(on ?x ?y)")))), "ok") << "it goes on";
}

TEST_P(RefusedTest, AHelloThatIsRefusedFailsWhateverWaitsForIt) {
  welcomes_ = false;
  const std::unique_ptr<Board> board = view("alice");
  const Result<Answers> asked = run(board->ask(query("(on ?x ?y)")));
  ASSERT_EQ(symbol_of(asked), "bad-frame");
  EXPECT_EQ(asked.error().sentence, "not as a board likes it");
}

TEST_P(RefusedTest, ABoardOfTheFirstProtocolIsGreetedAsItKnowsIt) {
  longest_hello_ = 3;
  const std::unique_ptr<Board> board = view("alice");
  EXPECT_EQ(symbol_of(run(board->ask(query("(on ?x ?y)")))), "ok");
  EXPECT_EQ(hellos_, 2) << "in its own words first";
}

TEST_P(RefusedTest, ABoardOfTheFirstProtocolMayRefuseTwoHellosThatWereUnderWay) {
  longest_hello_ = 3;
  unanswered_ = 1;
  const std::unique_ptr<Board> board = view("alice");
  EXPECT_EQ(symbol_of(run(board->ask(query("(on ?x ?y)")))), "ok");
  EXPECT_EQ(hellos_, 3) << "two in its own words first";
}

INSTANTIATE_TEST_SUITE_P(Clients, RefusedTest,
                         testing::Values(ClientKind{"remote"}, ClientKind{"python"}, ClientKind{"asyncio"}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace pizarra
