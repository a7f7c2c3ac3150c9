// Builds whose protocols are one apart work together, and those two apart are refused with a sentence: the shipped
// clients with the shipped board, over a link on which the hello says another protocol, and the bytes that a client of
// the first protocol sent.

#include <gtest/gtest.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/blackboard/python_wall.hpp"

namespace pizarra {
namespace {

// Between a board and one client.
class OtherProtocol {
 public:
  OtherProtocol(Executor& executor, const std::string& at, const std::string& board, std::uint64_t protocol)
      : protocol_(protocol),
        front_(executor, wire::WireSocket::Kind::router,
               [this](const std::string& client, std::optional<std::string_view> frame) {
                 client_ = client;
                 back_.send("", frame->starts_with("(hello ") ? hello(*frame) : std::string(*frame));
               }),
        back_(executor, wire::WireSocket::Kind::dealer,
              [this](const std::string&, std::optional<std::string_view> frame) { front_.send(client_, *frame); }) {
    EXPECT_TRUE(front_.bind(at).has_value());
    EXPECT_TRUE(back_.connect(board).has_value());
  }

 private:
  // As a build of that protocol says it. The first one had no word for it.
  std::string hello(std::string_view frame) const {
    const Datum said = wire::read_frame(frame).value();
    EXPECT_EQ(wire::count_at(said, 3), wire::protocol) << frame;
    if (protocol_ == 1) return write(list("hello"_sym, said[1], said[2]));
    return write(list("hello"_sym, said[1], said[2], protocol_, said[4]));
  }

  const std::uint64_t protocol_;
  std::string client_;
  wire::WireSocket front_;
  wire::WireSocket back_;
};

class ShippedBoard : public Wall {
 protected:
  ShippedBoard() { EXPECT_TRUE(program_.line().contains("ready on")); }
  Executor& executor() override { return executor_; }

  const std::string address_ = ipc_address();
  RealExecutor executor_;
  ChildProgram program_{{PIZARRA_BOARD_PROGRAM, "--listen", address_}};
};

// By the name of the client's kind.
class Neighbours : public ShippedBoard, public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Board> view(const std::string& teller) override {
    if (GetParam() == "remote") return client::RemoteBoard::connect(executor_, at_, teller).value();
    if (!python_) python_.emplace(executor_, python_kind(GetParam()));
    return python_->view(at_, teller);
  }
  void speak(std::uint64_t protocol) {
    at_ = ipc_address();
    link_.emplace(executor_, at_, address_, protocol);
  }

 private:
  std::string at_;
  std::optional<OtherProtocol> link_;
  std::optional<PythonProcess> python_;
};

TEST_P(Neighbours, OneProtocolApartDeclareTellAskWatchTakeAndLease) {
  for (const std::uint64_t protocol : {wire::protocol - 1, wire::protocol + 1}) {
    speak(protocol);
    const std::unique_ptr<Board> board = view("alice");
    ASSERT_EQ(symbol_of(run(board->declare({relation("(relation note ((n integer)) (key n))")}))), "ok") << protocol;
    const std::unique_ptr<Watch> watch = run(board->watch(query("(note ?n)"))).value();
    EXPECT_TRUE(run(watch->next())->added.empty());
    const LeaseId lease = run(board->lease(60s)).value();
    Transaction telling;
    telling.tell(read("(note 7)"), {}, lease);
    EXPECT_EQ(symbol_of(run(board->transact(std::move(telling)))), "ok");
    EXPECT_EQ(run(watch->next())->added.size(), 1u);
    EXPECT_EQ(run(board->ask(query("(note ?n)")))->answers.size(), 1u);
    EXPECT_TRUE(run(board->take(read("(note ?)"), 0))->has_value());
    EXPECT_EQ(run(watch->next())->removed.size(), 1u);
    EXPECT_EQ(symbol_of(run(board->renew(lease))), "ok");
    EXPECT_EQ(symbol_of(run(board->release(lease))), "ok");
  }
}

TEST_P(Neighbours, TwoProtocolsApartAreRefusedWithASentenceThatSaysWhichIsOld) {
  for (const std::uint64_t protocol : {wire::protocol - 2, wire::protocol + 2}) {
    speak(protocol);
    const std::unique_ptr<Board> board = view("alice");
    const Result<Answers> asked = run(board->ask(query("(note ?n)")));
    ASSERT_EQ(symbol_of(asked), "other-protocol") << protocol;
    const std::string older = protocol < wire::protocol ? "client" : "board";
    EXPECT_EQ(asked.error().sentence, "the client speaks protocol " + std::to_string(protocol) +
                                          " and the board protocol " + std::to_string(wire::protocol) +
                                          ", more than one apart: bring the " + older + " up to date");
  }
}

INSTANTIATE_TEST_SUITE_P(Clients, Neighbours, testing::Values("remote", "python", "asyncio"),
                         [](const auto& tested) { return tested.param; });

struct Line {
  bool is_said;  // by the client, else by the board
  std::string text;
};

// A client of the first protocol, Python's, and its board of the same build. S is the session, L the lease; every other
// number that is never the same twice is N.
const std::vector<Line> of_the_first_protocol = {
    {true, R"((hello "old" 0))"},
    {false, R"((welcome S N))"},
    {true, R"((request S 1 (declare (relation note ((n integer) (text string)) (key n)))))"},
    {false, R"((reply 1 (ok ())))"},
    {true, R"((ping S))"},
    {false, R"((pong N))"},
    {true, R"((request S 2 (watch 1 (note ?n ?))))"},
    {false, R"((reply 2 (ok ())))"},
    {false, R"((change 1 1 0 yes () ()))"},
    {true, R"((ack S 1 1))"},
    {true, R"((request S 3 (lease 60000000)))"},
    {false, R"((reply 3 (ok L)))"},
    {true, R"((request S 4 (transact () ((tell (note 1 "a") L)))))"},
    {false, R"((change 1 2 1 no (((1 1 N "old" (note 1 "a")))) ()))"},
    {false, R"((reply 4 (ok 1)))"},
    {true, R"((ack S 1 2))"},
    {true, R"((request S 5 (ask (note ?n ?text))))"},
    {false, R"((reply 5 (ok (1 ((1 1 N "old" (note 1 "a")))))))"},
    {true, R"((request S 6 (transact () ((retract (note 1 ?))))))"},
    {false, R"((change 1 3 2 no () (((1 1 N "old" (note 1 "a"))))))"},
    {false, R"((reply 6 (ok 2)))"},
    {true, R"((ack S 1 3))"},
    {true, R"((request S 7 (release L)))"},
    {false, R"((reply 7 (ok ())))"},
    {true, R"((unwatch S 1))"},
    {true, R"((bye S))"},
};

class OldClient : public ShippedBoard, public testing::Test {
 protected:
  OldClient() { EXPECT_TRUE(socket_.connect(address_).has_value()); }
  std::unique_ptr<Board> view(const std::string&) override { return nullptr; }
  std::string with_numbers(std::string text) const {
    for (const auto& [name, number] : numbers_) {
      for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) {
        text.replace(at + 1, 1, number);
      }
    }
    return text;
  }
  // The message with its long numbers named.
  std::string without_numbers(const Datum& message) {
    if (message.is_form("welcome")) numbers_[" S"] = write(message[1]);
    const bool gives_lease = message.is_form("reply") && message[2].size() == 2 && message[2][1].is_integer() &&
                             message[2][1].integer() > 1'000'000;
    if (gives_lease) numbers_[" L"] = write(message[2][1]);
    std::string text = write(message);
    for (const auto& [name, number] : numbers_) {
      const std::size_t at = text.find(" " + number);
      if (at != std::string::npos) text.replace(at, number.size() + 1, name);
    }
    std::string named;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
      const bool is_long = end - at > 9;
      named += is_long ? "N" : text.substr(at, std::max<std::size_t>(end - at, 1));
      at = std::max(end, at + 1);
    }
    return named;
  }
  bool hears(const std::string& text) {
    return comes([&] { return std::erase(heard_, text) > 0; });
  }

  std::map<std::string, std::string> numbers_;
  std::vector<std::string> heard_;
  wire::WireSocket socket_{executor_, wire::WireSocket::Kind::dealer,
                           [this](const std::string&, std::optional<std::string_view> frame) {
                             const std::vector<Datum> messages = wire::read_messages(frame.value()).value();
                             for (const Datum& message : messages) heard_.push_back(without_numbers(message));
                           }};
};

TEST_F(OldClient, OfTheFirstProtocolIsAnsweredAsItsOwnBoardAnsweredIt) {
  static_assert(wire::protocol == 2, "the first is no neighbour any more: record a client of this one's predecessor");
  for (const Line& line : of_the_first_protocol) {
    if (line.is_said) {
      // Nothing goes out before it is connected.
      ASSERT_TRUE(comes([&] { return socket_.send("", with_numbers(line.text)); }));
    } else {
      ASSERT_TRUE(hears(line.text)) << line.text << "\nbut " << testing::PrintToString(heard_);
    }
  }
  EXPECT_TRUE(heard_.empty()) << testing::PrintToString(heard_);
}

}  // namespace
}  // namespace pizarra
