// What goes together in one frame: requests that a client makes at once, and replies that may be given at once.

#include <filesystem>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/python_wall.hpp"
#include "tests/blackboard/server_fixture.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

std::string request(const std::string& session, int number, const std::string& body) {
  return "(request " + session + " " + std::to_string(number) + " " + body + ")";
}
std::string telling(const std::string& session, int number) {
  return request(session, number, "(transact () ((tell (note " + std::to_string(number) + " a) 0)))");
}

using ServerTogether = ServerTest;

TEST_F(ServerTogether, TheMessagesOfAFrameAreHeardOneAfterAnother) {
  Client client = this->client();
  const std::string session = client.join("alice");
  client.send(telling(session, 1) + telling(session, 2) + " ; and then\n(ping " + session + ")");
  EXPECT_EQ(client.receive(), read("(reply 1 (ok 1))"));
  EXPECT_EQ(client.receive(), read("(reply 2 (ok 2))"));
  EXPECT_EQ(client.receive().head(), "pong");
}

TEST_F(ServerTogether, AFrameOfTooManyMessagesIsRefusedToItsFirstRequestAndChangesNothing) {
  Client client = this->client();
  const std::string session = client.join("alice");
  std::string frame;
  for (std::size_t number = 1; number <= wire::most_messages + 1; ++number) {
    frame += telling(session, static_cast<int>(number));
  }
  const Datum refused = client.ask(frame);
  ASSERT_EQ(refused[1], to_datum(1)) << write(refused);
  EXPECT_EQ(refused[2][1], "bad-frame"_sym);
  EXPECT_EQ(refused[2][2], to_datum("a frame holds at most 64 messages"));
  EXPECT_EQ(client.ask("(ping " + session + ")").head(), "pong") << "it is told once";
  EXPECT_EQ(board.store().size(), 0U);
}

TEST_F(ServerTogether, AFrameThatCannotBeReadIsRefusedWhole) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const Datum refused = client.ask(telling(session, 1) + request(session, 2, "'word"));
  ASSERT_EQ(refused[1], to_datum(1)) << write(refused);
  EXPECT_EQ(refused[2][1], "bad-frame"_sym);
  EXPECT_EQ(board.store().size(), 0U);
}

TEST_F(ServerTogether, WhatIsDurableAtOnceIsAnsweredInOneFrame) {
  const std::string path = scratch_folder() + "together.journal";
  journal::JournalWriter writer(executor, journal::JournalFile::open(path, {}).value());
  board.set_journal([&](std::string_view line) { writer.append(line); });
  ASSERT_TRUE(board.declare("test", {relation("(relation kept ((n integer)) (durable))")}).has_value());
  server.reset();
  server::BoardServerOptions options{.addresses = {"tcp://127.0.0.1:*"}};
  options.journal = &writer;
  server = server::BoardServer::open(executor, board, options).value();
  Client client = this->client();
  const std::string session = client.join("alice");
  std::string frame;
  for (int number = 1; number <= 3; ++number) {
    frame += request(session, number, "(transact () ((tell (kept " + std::to_string(number) + ") 0)))");
  }
  client.send(frame);
  const std::vector<Datum> replies = client.receive_frame();
  ASSERT_EQ(replies.size(), 3U);
  for (int number = 1; number <= 3; ++number) {
    EXPECT_EQ(replies[static_cast<std::size_t>(number - 1)][1], to_datum(number));
  }
  server.reset();
  board.set_journal(nullptr);
}

TEST_F(ServerTogether, TransactionsOfAFrameAreAnsweredInOneAfterTheirChangesInAnother) {
  Client client = this->client();
  const std::string session = client.join("alice");
  client.send(request(session, 1, "(watch 1 (query (note ?n ?)) kept)"));
  EXPECT_EQ(client.receive(), read("(reply 1 (ok ()))"));
  EXPECT_EQ(client.receive().head(), "change");
  client.send(telling(session, 2) + telling(session, 3) + telling(session, 4));
  const std::vector<Datum> changes = client.receive_frame();
  ASSERT_EQ(changes.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const Datum& change = changes[static_cast<std::size_t>(i)];
    EXPECT_EQ(change.head(), "change");
    EXPECT_EQ(change[2], to_datum(i + 2)) << "numbered on";
    EXPECT_EQ(change[3], to_datum(i + 1)) << "each at its revision";
  }
  const std::vector<Datum> replies = client.receive_frame();
  EXPECT_EQ(replies,
            (std::vector<Datum>{read("(reply 2 (ok 1))"), read("(reply 3 (ok 2))"), read("(reply 4 (ok 3))")}));
}

TEST_F(ServerTogether, ChangesThatAreLongGoInFramesOfTheirOwn) {
  Client client = this->client();
  const std::string session = client.join("alice");
  client.send(request(session, 1, "(watch 1 (query (note ?n ?)) kept)"));
  EXPECT_EQ(client.receive(), read("(reply 1 (ok ()))"));
  EXPECT_EQ(client.receive().head(), "change");
  const std::string long_text(wire::bytes_together - 1000, 'x');
  std::string frame = telling(session, 2);
  for (int number = 3; number <= 4; ++number) {
    frame +=
        request(session, number, "(transact () ((tell (note " + std::to_string(number) + " " + long_text + ") 0)))");
  }
  client.send(frame);
  std::vector<std::size_t> changes;
  for (int i = 0; i < 2; ++i) changes.push_back(client.receive_frame().size());
  EXPECT_EQ(changes, (std::vector<std::size_t>{2, 1}));
}

TEST_F(ServerTogether, ManyTransactionsOfAFrameAreAnsweredSomeAtATime) {
  Client client = this->client();
  const std::string session = client.join("alice");
  std::string frame;
  for (int number = 1; number <= 10; ++number) frame += telling(session, number);
  client.send(frame);
  std::vector<std::size_t> replies;
  for (int i = 0; i < 3; ++i) replies.push_back(client.receive_frame().size());
  EXPECT_EQ(replies, (std::vector<std::size_t>{4, 4, 2}));
}

TEST_F(ServerTogether, ATransactionThatComesAgainInItsFrameIsAnsweredAfterItsChange) {
  Client client = this->client();
  const std::string session = client.join("alice");
  client.send(request(session, 1, "(watch 1 (query (note ?n ?)) kept)"));
  EXPECT_EQ(client.receive(), read("(reply 1 (ok ()))"));
  EXPECT_EQ(client.receive().head(), "change");
  client.send(telling(session, 2) + telling(session, 2));
  EXPECT_EQ(client.receive().head(), "change");
  EXPECT_EQ(client.receive(), read("(reply 2 (ok 1))"));
  EXPECT_EQ(client.receive(), read("(reply 2 (ok 1))"));
  EXPECT_EQ(board.store().size(), 1U);
}

// A server that answers all that came in a frame in one, which begins with something else.
class ClientTogether : public testing::TestWithParam<const char*>, public Wall {
 protected:
  ClientTogether() { EXPECT_TRUE(server_.bind(address_).has_value()); }

  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    const std::string client = GetParam();
    if (client == "remote") return client::RemoteBoard::connect(executor_, address_, teller).value();
    if (!python_) python_.emplace(executor_, python_kind(client));
    return python_->view(address_, teller);
  }
  void receive(const std::string& client, std::string_view frame) {
    std::string answer = "(pong 5)";
    int requests = 0;
    const std::vector<Datum> messages = wire::read_messages(frame).value();
    for (const Datum& message : messages) {
      if (message.is_form("hello")) answer = "(welcome 7 1)";
      if (!message.is_form("request")) continue;
      answer += " " + write(list("reply"_sym, message[2], list("ok"_sym, to_datum(++told_))));
      ++requests;
    }
    if (requests > 0) requests_of_frames_.push_back(requests);
    server_.send(client, answer);
  }

  const std::string address_ = ipc_address();
  int told_ = 0;
  std::vector<int> requests_of_frames_;
  RealExecutor executor_;
  wire::WireSocket server_{
      executor_, wire::WireSocket::Kind::router,
      [this](const std::string& client, std::optional<std::string_view> frame) { receive(client, frame.value()); }};
  std::optional<PythonProcess> python_;
};

TEST_P(ClientTogether, AReplyIsFoundWhereverInAFrameItStands) {
  const std::unique_ptr<Board> board = view("alice");
  for (Revision n = 1; n <= 3; ++n) EXPECT_EQ(run(board->tell(read("(on a b)"))), n);
}

INSTANTIATE_TEST_SUITE_P(Clients, ClientTogether, testing::Values("remote", "python", "asyncio"),
                         [](const auto& tested) { return std::string(tested.param); });

class RemoteTogether : public ClientTogether {
 protected:
  // Of so many tasks at once, each of which tells twice.
  void tell_from(int tasks, const std::string& text) {
    const std::unique_ptr<Board> board = view("alice");
    ASSERT_TRUE(run(board->tell(read("(on a b)"))).has_value());
    requests_of_frames_.clear();
    std::vector<Job> jobs;
    for (int i = 0; i < tasks; ++i) jobs.push_back(executor_.spawn(tell_twice(*board, to_datum(text))));
    ASSERT_TRUE(comes([&] { return std::ranges::all_of(jobs, &Job::done); }));
  }
  static Task<void> tell_twice(Board& board, Datum text) {
    for (int i = 0; i < 2; ++i) {
      const Result<Revision> told = co_await board.tell(list("says"_sym, i, text));
      EXPECT_TRUE(told.has_value());
    }
  }
};

TEST_P(RemoteTogether, WhatIsAskedAtOnceGoesInOneFrame) {
  tell_from(40, "short");
  EXPECT_EQ(requests_of_frames_, (std::vector<int>{40, 40}));
}

TEST_P(RemoteTogether, AFrameTakesNoMoreMessagesThanAServerHears) {
  tell_from(100, "short");
  EXPECT_EQ(*std::ranges::max_element(requests_of_frames_), int{wire::most_messages});
}

TEST_P(RemoteTogether, WhatIsLongGoesAlone) {
  tell_from(4, std::string(wire::bytes_together, 'x'));
  EXPECT_EQ(requests_of_frames_, std::vector<int>(8, 1));
}

INSTANTIATE_TEST_SUITE_P(Clients, RemoteTogether, testing::Values("remote"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace pizarra
