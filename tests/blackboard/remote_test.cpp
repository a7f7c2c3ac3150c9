#include <gtest/gtest.h>
#include <set>
#include <thread>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/python_wall.hpp"

namespace pizarra {
namespace {

// A client whose server comes and goes.
class RemoteTest : public testing::Test, public Wall {
 protected:
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return client::RemoteBoard::connect(executor_, address_, teller, timeout_).value();
  }
  void start_server() {
    auto store = std::make_unique<store::Store>(static_cast<LeaseId>(executor_.now().time_since_epoch().count()));
    board_ = std::make_unique<memory::MemoryBoard>(executor_, std::move(store));
    server_ = server::BoardServer::open(executor_, *board_, {.addresses = {address_}}).value();
  }
  void stop_server() {
    server_.reset();
    board_.reset();
  }
  Result<Revision> tell(Board& board, const std::string& fact) { return run(board.tell(read(fact))); }

  const std::vector<Relation> relations_ = {relation("(relation on ((a symbol) (b symbol)))")};
  const std::string address_ = ipc_address();
  Duration timeout_ = client::RemoteBoard::default_timeout;
  RealExecutor executor_;
  std::unique_ptr<memory::MemoryBoard> board_;
  std::unique_ptr<server::BoardServer> server_;
};

// The same of every client: this process' own, and Python's two.
class ClientTest : public RemoteTest, public testing::WithParamInterface<const char*> {
 protected:
  std::unique_ptr<Board> view(const std::string& teller) override {
    const std::string client = GetParam();
    if (client == "remote") return RemoteTest::view(teller);
    if (!python_) python_.emplace(executor_, python_kind(client));
    return python_->view(address_, teller, timeout_);
  }
  std::optional<PythonProcess> python_;
};

TEST_P(ClientTest, WithoutAServerEverythingIsUnreachableAfterTheTimeout) {
  timeout_ = 500ms;
  const auto board = view("alice");
  const Time before = executor_.now();
  EXPECT_EQ(symbol_of(tell(*board, "(on a b)")), "unreachable");
  EXPECT_GE(executor_.now() - before, 500ms);
  EXPECT_LT(executor_.now() - before, 4s);
}

TEST_P(ClientTest, AServerThatComesLateIsFound) {
  const auto board = view("alice");
  executor_.call_at(executor_.now() + 200ms, [&] { start_server(); });
  EXPECT_EQ(symbol_of(run(board->declare(relations_))), "ok");
  EXPECT_EQ(symbol_of(tell(*board, "(on a b)")), "ok");
}

TEST_F(RemoteTest, AClientGreetsAsSoonAsItIsLetIn) {
  start_server();
  Duration best = 1s;
  // A client that waits for a beat to greet at waits for it every time.
  for (int tries = 0; tries < 20; ++tries) {
    const Time before = executor_.now();
    const auto board = view("alice");
    ASSERT_EQ(symbol_of(run(board->declare(relations_))), "ok");
    best = std::min(best, executor_.now() - before);
  }
  EXPECT_LT(best, 8ms);
}

TEST_F(RemoteTest, AClientThatDidNotRunDoesNotLeaveItsBoardForAnother) {
  board_ = std::make_unique<memory::MemoryBoard>(executor_);
  server_ = server::BoardServer::open(executor_, *board_, {.addresses = {"tcp://127.0.0.1:*"}}).value();
  const std::string both = server_->addresses().front() + ",tcp://127.0.0.1:1";
  const auto alice = client::RemoteBoard::connect(executor_, both, "alice").value();
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  // As long as a program is stopped, or computes.
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  bool is_with_it = true;
  executor_.run_until([&] {
    is_with_it = is_with_it && alice->connected();
    return !is_with_it || alice->silence() < 100ms;
  });
  EXPECT_TRUE(is_with_it);
  EXPECT_EQ(symbol_of(tell(*alice, "(on a b)")), "ok");
}

TEST_P(ClientTest, AfterTheServerWasLostAgentsGoOnAndTheirLeasesAreGone) {
  start_server();
  const auto alice = view("alice");
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  const LeaseId lease = run(alice->lease(60s)).value();
  ASSERT_EQ(symbol_of(tell(*alice, "(on a b)")), "ok");
  const std::unique_ptr<Watch> watch = run(alice->watch(query("(on ?x ?y)"))).value();
  EXPECT_EQ(run(watch->next())->added.size(), 1U);

  stop_server();
  pass(50ms);
  start_server();
  const Change anew = run(watch->next()).value();
  EXPECT_TRUE(anew.resynchronised);
  EXPECT_TRUE(anew.added.empty());
  EXPECT_EQ(symbol_of(tell(*alice, "(on c d)")), "ok") << "the relation is declared again";
  const Change change = run(watch->next()).value();
  EXPECT_FALSE(change.resynchronised);
  EXPECT_EQ(values(change.added, "?x"), std::vector<Datum>{"c"_sym});
  EXPECT_EQ(symbol_of(run(alice->renew(lease))), "unknown-lease");
}

TEST_F(RemoteTest, AServerThatEndsSaysGoodbyeAndTheNextIsFollowed) {
  start_server();
  const auto alice = client::RemoteBoard::connect(executor_, address_, "alice").value();
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  EXPECT_FALSE(alice->said_goodbye());
  server_->say_goodbye();
  pass(server::BoardServer::goodbye_length);
  stop_server();
  EXPECT_TRUE(comes([&] { return alice->said_goodbye().has_value(); }));
  EXPECT_FALSE(alice->connected());
  start_server();
  EXPECT_EQ(symbol_of(tell(*alice, "(on a b)")), "ok");
  EXPECT_FALSE(alice->said_goodbye());
}

TEST_F(RemoteTest, ClientsSayHowLongFactsAreUnderWay) {
  start_server();
  const auto alice = client::RemoteBoard::connect(executor_, address_, "alice").value();
  const auto bob = client::RemoteBoard::connect(executor_, address_, "bob").value();
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  const std::unique_ptr<Watch> watch = run(bob->watch(query("(on ?x ?y)"))).value();
  run(watch->next()).value();
  ASSERT_TRUE(comes([&] { return alice->board_time() && bob->board_time(); }));
  EXPECT_LT(std::chrono::abs(*alice->board_time() - executor_.now()), 100ms) << "it is the same clock";
  constexpr int told = 5;
  for (int i = 0; i < told; ++i) {
    pass(12ms);
    const Time before = executor_.now();
    ASSERT_EQ(symbol_of(tell(*alice, "(on a b" + std::to_string(i) + ")")), "ok");
    const Fact arrived = run(watch->next())->added.front().facts.front();
    const Duration took = *bob->board_time() - arrived.when;
    EXPECT_LE(took, executor_.now() - before + 100ms);
  }
  const auto journeys = [&] { return board_->ask(query("(journey-stats on ?told ?delivered)")); };
  const auto count = [&](const char* of) {
    const Result<Answers> answers = journeys();
    return answers->answers.empty() ? 0 : (*answers->answers.front().bindings.find(of))[0].integer();
  };
  ASSERT_TRUE(comes([&] { return count("?delivered") >= told - 1; })) << count("?delivered");
  EXPECT_GE(count("?told"), told - 1);
  for (const char* of : {"?told", "?delivered"}) {
    const Result<Answers> answers = journeys();
    const Datum spread = *answers->answers.front().bindings.find(of);
    ASSERT_EQ(spread.size(), 4U);
    EXPECT_LE(spread[1].integer(), spread[2].integer());
    EXPECT_LE(spread[2].integer(), spread[3].integer());
    EXPECT_LT(spread[1].integer(), 5'000'000) << write(spread);
  }
}

TEST_P(ClientTest, AClientThatWasForgottenComesBack) {
  auto store = std::make_unique<store::Store>();
  board_ = std::make_unique<memory::MemoryBoard>(executor_, std::move(store));
  server::BoardServerOptions options;
  options.addresses = {address_};
  // Shorter than the time between two signs of life.
  options.session_length = 100ms;
  server_ = server::BoardServer::open(executor_, *board_, options).value();
  const auto alice = view("alice");
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  const std::unique_ptr<Watch> watch = run(alice->watch(query("(on ?x ?y)"))).value();
  run(watch->next()).value();
  ASSERT_TRUE(comes([&] { return server_->sessions() == 0; }));
  Transaction transaction;
  transaction.tell(read("(on a b)"));
  ASSERT_TRUE(board_->transact("bob", transaction).has_value());
  const Change change = run(watch->next()).value();
  EXPECT_TRUE(change.resynchronised);
  EXPECT_EQ(change.added.size(), 1U);
}

TEST_P(ClientTest, AClientThatEndsIsForgottenAtOnce) {
  start_server();
  auto alice = view("alice");
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  EXPECT_EQ(server_->sessions(), 1U);
  alice.reset();
  const Time said_bye = executor_.now();
  ASSERT_TRUE(comes([&] { return server_->sessions() == 0; }));
  EXPECT_LT(executor_.now() - said_bye, 5s) << "not only when its session lapses";
}

TEST_F(RemoteTest, RequestsOfManyTasksAreAnsweredToTheirOwn) {
  start_server();
  const auto alice = view("alice");
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  int right = 0;
  const auto work = [](Board& board, int number, int& done) -> Task<void> {
    const std::string name = "x" + std::to_string(number);
    Datum fact = list("on"_sym, Datum::symbol(name), "y"_sym);
    const Result<Revision> told = co_await board.tell(fact);
    const Result<std::vector<Fact>> facts = co_await board.facts(fact);
    if (told && facts && facts->size() == 1 && facts->front().datum == fact) ++done;
  };
  std::vector<Job> jobs;
  constexpr int most = 1000;
  for (int i = 0; i < most; ++i) jobs.push_back(executor_.spawn(work(*alice, i, right)));
  ASSERT_TRUE(comes([&] { return std::ranges::all_of(jobs, [](const Job& job) { return job.done(); }); }));
  EXPECT_EQ(right, most);
}

// A number of replies is remembered, and no more of them wait for a client that does not read.
TEST_F(RemoteTest, NoRequestGoesFarAheadOfTheOldestThatWaits) {
  std::set<std::string> heard;  // the numbers; one that waits for long is sent again
  std::string client;
  wire::WireSocket router(executor_, wire::WireSocket::Kind::router,
                          [&](const std::string& peer, std::optional<std::string_view> frame) {
                            client = peer;
                            const std::vector<Datum> messages = wire::read_messages(frame.value()).value();
                            for (const Datum& message : messages) {
                              if (message.is_form("request")) heard.insert(write(message[2]));
                            }
                          });
  ASSERT_TRUE(router.bind(address_).has_value());
  const std::unique_ptr<Board> board = view("alice");
  const auto tell = [](Board& b, int number, int& done) -> Task<void> {
    Datum fact = list("on"_sym, Datum::symbol("x" + std::to_string(number)), "y"_sym);
    const Result<Revision> told = co_await b.tell(fact);
    if (told) ++done;
  };
  int done = 0;
  std::vector<Job> jobs;
  for (int i = 0; i < 300; ++i) jobs.push_back(executor_.spawn(tell(*board, i, done)));
  ASSERT_TRUE(comes([&] { return !client.empty(); }));
  router.send(client, "(welcome 7 1)");
  ASSERT_TRUE(comes([&] { return heard.size() >= client::RemoteRequests::most_ahead; }));
  pass(100ms);
  EXPECT_EQ(heard.size(), client::RemoteRequests::most_ahead);
  router.send(client, "(reply 2 (ok 5))");
  pass(100ms);
  EXPECT_EQ(heard.size(), client::RemoteRequests::most_ahead) << "the first waits still";
  router.send(client, "(reply 1 (ok 5))");
  EXPECT_TRUE(comes([&] { return heard.size() == client::RemoteRequests::most_ahead + 2; }));
  for (int number = 3; number <= 300; ++number) {
    ASSERT_TRUE(comes([&] { return heard.contains(std::to_string(number)); })) << number;
    router.send(client, "(reply " + std::to_string(number) + " (ok 5))");
  }
  EXPECT_TRUE(comes([&] { return done == 300; }));
}

// A server of the test's own, that answers as the test says.
TEST_F(RemoteTest, WhetherATransactionHappenedOnALostBoardIsUnknownButAQuestionIsAskedAgain) {
  std::vector<std::string> heard;
  wire::WireSocket* answer_with = nullptr;
  int life = 100;
  const auto answer = [&](const std::string& peer, const Datum& message) {
    const auto send = [&](const Datum& d) { answer_with->send(peer, write(d)); };
    if (message.is_form("hello")) return send(list("welcome"_sym, life));
    if (message[1] != to_datum(life)) return send(list("unknown-session"_sym, message[1]));
    if (!message.is_form("request")) return;
    heard.emplace_back(message[3].head());
    if (life == 101) send(list("reply"_sym, message[2], list("ok"_sym, list(5))));
  };
  wire::WireSocket router(executor_, wire::WireSocket::Kind::router,
                          [&](const std::string& peer, std::optional<std::string_view> frame) {
                            const std::vector<Datum> messages = wire::read_messages(frame.value()).value();
                            for (const Datum& message : messages) answer(peer, message);
                          });
  answer_with = &router;
  ASSERT_TRUE(router.bind(address_).has_value());
  const std::unique_ptr<Board> board = client::RemoteBoard::connect(executor_, address_, "alice", 5s).value();
  executor_.call_at(executor_.now() + 300ms, [&] { life = 101; });
  std::string asked;
  const auto ask = [](Board& b, std::string& out) -> Task<void> {
    Query question = query("(on ?x ?y)");
    const Result<Answers> answers = co_await b.ask(question);
    out = symbol_of(answers);
  };
  const Job asking = executor_.spawn(ask(*board, asked));
  const Result<Revision> told = tell(*board, "(on a b)");
  ASSERT_EQ(symbol_of(told), "unreachable");
  EXPECT_NE(told.error().sentence.find("not known"), std::string::npos);
  ASSERT_TRUE(comes([&] { return asking.done(); }));
  EXPECT_EQ(asked, "ok");
  EXPECT_EQ(std::ranges::count(heard, "transact"), 1);
  EXPECT_EQ(std::ranges::count(heard, "ask"), 2);
}

TEST_F(RemoteTest, AnAddressOrANameThatIsNoneIsRefused) {
  EXPECT_EQ(symbol_of(client::RemoteBoard::connect(executor_, address_, "my script")), "bad-name");
  EXPECT_EQ(symbol_of(client::RemoteBoard::connect(executor_, address_, "\xff")), "bad-name");
  EXPECT_EQ(symbol_of(client::RemoteBoard::connect(executor_, "nowhere", "alice")), "bad-address");
  EXPECT_EQ(symbol_of(client::RemoteBoard::connect(executor_, "tcp://\xff:1", "alice")), "bad-address");
}

INSTANTIATE_TEST_SUITE_P(Clients, ClientTest, testing::Values("remote", "python", "asyncio"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace pizarra
