// The rights and limits of a page that was let in.

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <fmt/format.h>
#include <set>
#include <sys/socket.h>
#include <unistd.h>

#include "agents/console/change_text.hpp"
#include "agents/console/numbered_requests.hpp"
#include "blackboard/boards_own.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/console/console_fixture.hpp"
#include "tests/blackboard/passing_board.hpp"

namespace pizarra::console {
namespace {

constexpr const char* number_relation = "(relation number ((n integer) (text string)) (key n))";

TEST_F(ConsoleTest, TellsWhatHoldsAndEveryChange) {
  declare(number_relation);
  ASSERT_TRUE(run(executor_, here_->tell(list("number"_sym, 1, "<script>\"1\"</script>"))));
  const auto client = page(cookie());
  const std::string first = said(*client, "(follow 7 (number ?n ?text))");
  EXPECT_TRUE(begins(first, "{\"watch\":7,"));
  EXPECT_TRUE(has(first, R"x("?text":"\"<script>\\\"1\\\"</script>\"")x"));
  EXPECT_TRUE(has(first, "\"teller\":\"test\""));
  ASSERT_TRUE(run(executor_, here_->retract(list("number"_sym, 1, "?"_sym))));
  const auto gone = serve([&] { return client->read_frame(); });
  ASSERT_TRUE(gone);
  EXPECT_TRUE(has(gone->payload, "\"added\":[]"));
}

// A client's kernel acknowledges what it has nothing to answer to after 40 ms.
TEST_F(ConsoleTest, SendsAnAnswerWithoutWaitingForAnAcknowledgement) {
  declare(number_relation);
  const auto client = page(cookie());
  std::vector<std::chrono::duration<double, std::milli>> took;
  for (int i = 0; i < 41; ++i) {
    const auto asked = std::chrono::steady_clock::now();
    ASSERT_TRUE(begins(said(*client, fmt::format("(ask {} (number ?n ?text))", i)), "{\"watch\":"));
    took.push_back(std::chrono::steady_clock::now() - asked);
  }
  std::ranges::nth_element(took, took.begin() + 20);
  EXPECT_LT(took[20].count(), 30);
}

// All that a page can have told and watched is in its contract.
TEST_F(ConsoleTest, ThePagesContractHasWhatItTellsAndWatches) {
  for (const char* relation : {"(relation commander ((robot symbol) (client symbol)) (key robot client))",
                               "(relation hold ((robot symbol) (client symbol) (count integer)) (key robot client))",
                               "(relation arm-joints ((robot symbol) (joints list)) (key robot))"}) {
    declare(relation);
  }
  const auto client = page(cookie());
  for (const char* form : {"(command 1 robot)", "(ask-for 2 robot)", "(stop 3 \"a hand\")"}) {
    EXPECT_TRUE(has(said(*client, form), "values")) << form;
  }
  const std::int64_t stamp = serve([&] { return client->read_stamp(); });
  EXPECT_TRUE(has(said(*client, fmt::format("(jog 4 robot left {})", stamp)), "absent")) << "it was told before";
  const Datum page_1 = "console-1"_sym;
  const Result<std::vector<Fact>> told = run(executor_, here_->facts(list("contract"_sym, page_1, "?form"_sym)));
  ASSERT_TRUE(told && told->size() == 1);
  std::set<std::string> named;
  for (const Datum& part : told->front().datum[2].items()) {
    if (!part.is_list()) continue;
    for (const Datum& relation : part.items().subspan(1)) named.emplace(relation.text());
  }
  std::set<std::string> used;
  const Result<std::vector<Fact>> statistics =
      run(executor_, here_->facts(read_one("(relation-stats ?name ? ? ? ? ?tellers ?watchers)").value()));
  for (const Fact& relation : *statistics) {
    const bool by_page = write(relation.datum).find("(\"console-1\" ") != std::string::npos;
    if (by_page) used.emplace(relation.datum[1].text());
  }
  for (const char* of_every_agent : {"agent", "contract", "request", "reply", "context", "bound"}) {
    used.erase(of_every_agent);
  }
  EXPECT_EQ(used, (std::set<std::string>{"arm-joints", "commander", "commander-wanted", "hold", "stop"}));
  for (const std::string& relation : used) EXPECT_TRUE(named.contains(relation)) << relation;
}

// As a board is for a key that may not tell that it is there.
class Mute : public PassingBoard {
 public:
  using PassingBoard::PassingBoard;
  Task<Result<Revision>> transact(Transaction) override {
    co_return fail("not-permitted", "the key mute may not tell facts of agent" + std::string(200, '!'));
  }
};

TEST_F(ConsoleTest, SaysToAPageThatTheBoardRefusesWhichRightItLacks) {
  const Console::BoardMaker mute = [this](const std::string& name,
                                          const std::string&) -> Result<std::unique_ptr<Board>> {
    return std::make_unique<Mute>(board_.view(name));
  };
  reopen([&](Console::Setup& setup) { setup.board = mute; });
  const auto refused = serve([port = port_, own = cookie()] {
    RawClient client(port);
    client.send(request_text(port, "GET", "/socket", upgrade_headers(own)));
    client.read_head();
    return client.read_frame();
  });
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->close_code(), 1011);
  EXPECT_TRUE(has(refused->payload, "your key may not open a page (the key mute may not tell facts of agent!"));
}

// As a board is for a key that may stop the arm and look at everything.
class Guest : public PassingBoard {
 public:
  using PassingBoard::PassingBoard;
  Task<Result<Answers>> ask(Query query) override {
    const bool about_itself = query.clauses.front().form.is_form(own_permission);
    if (about_itself) co_return permissions();
    Result<Answers> answers = co_await PassingBoard::ask(std::move(query));
    co_return answers;
  }

 private:
  static Answers permissions() {
    Answers answers;
    for (const char* text : {"(own-permission tell agent)", "(own-permission tell stop)", "(own-permission read *)"}) {
      Fact fact;
      fact.datum = read_one(text).value();
      answers.answers.push_back(Answer{.bindings = {}, .facts = {fact}});
    }
    return answers;
  }
};

TEST_F(ConsoleTest, SaysInItsHelloWhichVersionOfThePageItServes) {
  const std::string built = source_dir() + "/agents/console/page/built";
  const std::string version = PageFiles::read(built)->version();
  EXPECT_TRUE(has(PageFiles::read(built)->find("/console.js")->text, version));
  EXPECT_TRUE(has(hello(), fmt::format("\"version\":\"{}\"", version)));
}

TEST_F(ConsoleTest, SaysInItsHelloWhatTheKeyOfThePageDoesNotPermit) {
  EXPECT_TRUE(has(hello(), "\"mayNot\":{}")) << "no key is asked for";
  const Console::BoardMaker guest = [this](const std::string& name,
                                           const std::string&) -> Result<std::unique_ptr<Board>> {
    return std::make_unique<Guest>(board_.view(name));
  };
  reopen([&](Console::Setup& setup) { setup.board = guest; });
  const std::string said = hello();
  EXPECT_TRUE(has(said, "\"goal\":\"your key may not give goals (it lacks: tell request)\""));
  EXPECT_TRUE(has(said, "\"command\":\"your key may not take the arm in hand (it lacks: tell commander)\""));
  EXPECT_TRUE(has(said, "\"jog\":\"your key may not move the arm (it lacks: tell hold)\""));
  EXPECT_EQ(said.find("\"stop\":"), std::string::npos) << said;
}

TEST_F(ConsoleTest, AnswersWhyAFactStandsInOneQuestion) {
  declare(number_relation);
  ASSERT_TRUE(run(executor_, here_->tell(list("number"_sym, 1, "first"))));
  const auto id_of = [&](int number) { return run(executor_, here_->facts(list("number"_sym, number, "?"_sym))); };
  const std::vector<FactId> because(1, id_of(1)->front().id);
  ASSERT_TRUE(run(executor_, here_->tell(list("number"_sym, 2, "second"), because)));
  const FactId root = id_of(2)->front().id;
  const auto client = page(cookie());
  const std::string why = said(*client, fmt::format("(ask 1 (provenance {} ?id ?fact ?teller ?when ?because))", root));
  EXPECT_TRUE(has(why, R"x("?fact":"(number 2 \"second\")")x"));
  EXPECT_TRUE(has(why, R"x("?fact":"(number 1 \"first\")")x"));
}

TEST_F(ConsoleTest, SaysOfATypedQuestionWhatIsWrongWithItAndWhere) {
  const auto client = page(cookie());
  EXPECT_TRUE(has(said(*client, "(watch 1 \"(on ?x\")"), "query:1:1"));
  EXPECT_TRUE(has(said(*client, "(watch 2 \"(onn ?x ?y)\")"), "undeclared-relation"));
}

TEST_F(ConsoleTest, EndsAPageThatSaysMoreThanFitsOrWhatNoPageOfItsSays) {
  const std::string own = cookie();
  const auto end_after = [&](const std::string& message) {
    const auto client = page(own);
    return serve([&] {
      client->send_frame(RawClient::text, message);
      const auto frame = client->read_frame();
      return frame ? frame->close_code() : 0;
    });
  };
  EXPECT_EQ(end_after("(stop 1 \"" + std::string(20'000, 'x') + "\")"), 1009);
  EXPECT_EQ(end_after("(tell (number 1 \"x\"))"), 1008);
  EXPECT_EQ(end_after("(stop one \"x\")"), 1008);
  EXPECT_EQ(end_after("(stop 1 \"x\""), 1008);
}

TEST_F(ConsoleTest, EndsAPageThatSaysTooMuchASecond) {
  const auto client = page(cookie());
  const int code = serve([&] {
    for (int i = 0; i < 2000; ++i) client->send_frame(RawClient::text, "(unwatch 1)");
    while (const auto frame = client->read_frame()) {
      if (frame->kind == RawClient::closing) return frame->close_code();
    }
    return 0;
  });
  EXPECT_EQ(code, 1008);
}

// As where the usual one died, and another stands in for it.
TEST_F(ConsoleTest, AsksTheCoordinatorThatPlaysTheRole) {
  const std::unique_ptr<Board> view = board_.view("coordinator-2");
  runtime::AgentContext context{"coordinator-2", "localhost", executor_, *view, Random(1)};
  runtime::Service service(
      context, runtime::contract_from_text("(contract coordinator (offers (why)) (posts) (reads))").value());
  const Job served = executor_.spawn([](runtime::Service& reasons) -> Task<void> {
    const Result<void> started = co_await reasons.start();
    EXPECT_TRUE(started);
    runtime::Handler handler = [](Datum) -> Task<Result<Datum>> { co_return list("nothing is wanted"); };
    const Result<void> ended = co_await reasons.serve(std::move(handler));
    EXPECT_TRUE(ended);
  }(service));
  const Datum bound = list("bound"_sym, "?"_sym, "coordinator-2"_sym, "coordinator"_sym, "coordinator-2"_sym);
  executor_.run_until([&] { return board_.ask(query_for(bound)).has_value(); });
  const auto client = page(cookie());
  EXPECT_TRUE(has(said(*client, "(request 3 coordinator (why))"), "nothing is wanted"));
}

TEST_F(ConsoleTest, IsServedInItsRolesByWhoeverIsWired) {
  const std::unique_ptr<Board> view = board_.view("vision-2");
  runtime::AgentContext context{"vision-2", "localhost", executor_, *view, Random(1)};
  runtime::Service service(
      context, runtime::contract_from_text("(contract vision (offers (end-track)) (posts) (reads))").value());
  const Job served = executor_.spawn([](runtime::Service& eyes) -> Task<void> {
    const Result<void> started = co_await eyes.start();
    EXPECT_TRUE(started);
  }(service));
  const auto holds = [&](const Datum& fact) {
    const Result<Answers> answers = board_.ask(query_for(fact));
    return answers && !answers->answers.empty();
  };
  executor_.run_until(
      [&] { return holds(list("holder"_sym, "console"_sym, "eyes"_sym, "vision-2"_sym, "stands-in"_sym)); });
  ASSERT_TRUE(run(executor_, here_->tell(list("wired"_sym, "console"_sym, "eyes"_sym, "vision-2"_sym))));
  executor_.run_until(
      [&] { return holds(list("holder"_sym, "console"_sym, "eyes"_sym, "vision-2"_sym, "wired"_sym)); });
  const Job closing = executor_.spawn(console_->close());
  executor_.run_until([&] { return closing.done(); });
  EXPECT_FALSE(holds(list("holder"_sym, "console"_sym, "eyes"_sym, "?"_sym, "?"_sym)));
}

TEST_F(ConsoleTest, TellsAStopWhateverElseIsInHand) {
  declare("(relation agent ((name symbol) (kind symbol) (host string)) (key name))");
  ASSERT_TRUE(run(executor_, here_->tell(list("agent"_sym, "robot"_sym, "robot"_sym, "localhost"))));
  const auto client = page(cookie());
  const std::string answer = serve([&] {
    for (std::size_t i = 0; i < NumberedRequests::most; ++i) {
      client->send_frame(RawClient::text, fmt::format("(request {} robot (home))", i + 100));
    }
    client->send_frame(RawClient::text, "(stop 1 \"a hand\")");
    const auto frame = client->read_frame();
    return frame ? frame->payload : std::string();
  });
  EXPECT_EQ(answer, "{\"reply\":1,\"values\":[]}");
  const auto stops = run(executor_, here_->facts(list("stop"_sym, "?"_sym, "?"_sym)));
  ASSERT_TRUE(stops && stops->size() == 1);
  EXPECT_EQ(stops->front().datum, list("stop"_sym, "console-1"_sym, "a hand"));
  EXPECT_EQ(stops->front().teller, "console-1");
}

TEST_F(ConsoleTest, GivesTheArmToOneOperatorAtATimeAndClearsAStopForThatOneAlone) {
  declare("(relation commander ((robot symbol) (client symbol)) (key robot client))");
  const std::string own = cookie();
  const auto first = page(own);
  auto second = page(own);
  const std::string done = "{\"reply\":1,\"values\":[]}";
  EXPECT_EQ(said(*first, "(command 1 robot)"), done);
  EXPECT_TRUE(has(said(*second, "(command 1 robot)"), "in-other-hands"));
  EXPECT_EQ(said(*second, "(stop 1 \"mine\")"), done);
  EXPECT_TRUE(has(said(*second, "(clear-stops 1)"), "not-commander"));
  EXPECT_EQ(said(*second, "(take-over 1 robot)"), done);
  EXPECT_EQ(said(*second, "(clear-stops 1)"), done);
  const auto holders = [&] { return run(executor_, here_->facts(list("commander"_sym, "robot"_sym, "?"_sym))); };
  ASSERT_EQ(holders()->size(), 1u);
  EXPECT_EQ(holders()->front().datum[2], "console-2"_sym);
  // Who goes lets go.
  second.reset();
  executor_.run_until([&] { return console_->pages() == 1 || tick(); });
  EXPECT_TRUE(holders()->empty());
}

struct ReadToLast {
  std::size_t bytes = 0;
  int resynchronised = 0;
};

// Of a message, the largest number behind a text of `bulk`; 0 where there is none.
int newest_in(std::string_view message, const std::string& bulk) {
  int newest = 0;
  for (std::size_t at = message.find(bulk); at != std::string_view::npos; at = message.find(bulk, at)) {
    at += bulk.size();
    int number = 0;
    std::from_chars(message.data() + at, message.data() + message.size(), number);
    newest = std::max(newest, number);
  }
  return newest;
}

// Says what it has taken in as the page does; the first change was told when it was asked for. `read` is the number
// that it has come to.
ReadToLast read_until(RawClient& client, const std::string& bulk, int last, std::atomic<int>& read) {
  ReadToLast seen;
  std::size_t unsaid_bytes = 0;
  int unsaid = 1;
  while (const auto frame = client.read_frame()) {
    ++unsaid;
    unsaid_bytes += frame->payload.size();
    seen.bytes += frame->payload.size();
    seen.resynchronised += frame->payload.find("\"resynchronised\":true") != std::string::npos ? 1 : 0;
    read = std::max<int>(read, newest_in(frame->payload, bulk));
    if (read == last) break;
    if (unsaid_bytes < 100'000) continue;
    client.send_frame(RawClient::text, fmt::format("(heard {})", unsaid));
    unsaid = 0;
    unsaid_bytes = 0;
  }
  return seen;
}

// No further ahead of who reads than a page may be behind.
Task<void> tell_numbers(Executor& executor, Board& board, std::string bulk, int rounds, const std::atomic<int>& read) {
  constexpr int most_ahead = 64;
  for (int i = 0; i < rounds; ++i) {
    while (i > read + most_ahead) co_await sleep(executor, 1ms);
    const Datum fact = list("number"_sym, i % 10, bulk + std::to_string(i));
    const Result<Revision> told = co_await board.tell(fact);
    EXPECT_TRUE(told);
  }
}

// A page that reads nothing has its own changes wait, on the board, and nobody else's.
TEST_F(ConsoleTest, ASlowReaderSlowsNobodyAndIsResynchronised) {
  declare(number_relation);
  const std::string own = cookie();
  const auto slow = page(own, 4096);
  const auto quick = page(own);
  EXPECT_TRUE(has(said(*slow, "(follow 1 (number ?n ?text))"), "\"resynchronised\":true"));
  EXPECT_TRUE(has(said(*quick, "(follow 1 (number ?n ?text))"), "\"resynchronised\":true"));
  constexpr int rounds = 3000;
  const std::string bulk(2000, 'x');
  constexpr int last = rounds - 1;
  std::atomic<int> quick_read = 0;
  std::atomic<int> slow_read = 0;
  const Job telling = executor_.spawn(tell_numbers(executor_, *here_, bulk, rounds, quick_read));
  const ReadToLast of_quick = serve([&] { return read_until(*quick, bulk, last, quick_read); });
  EXPECT_EQ(of_quick.resynchronised, 0);
  EXPECT_GT(of_quick.bytes, rounds * bulk.size()) << "it is told every change";
  const ReadToLast of_slow = serve([&] { return read_until(*slow, bulk, last, slow_read); });
  EXPECT_GT(of_slow.resynchronised, 0);
  EXPECT_LT(of_slow.bytes, rounds * bulk.size() / 2) << "what had become void was not kept for it";
}

TEST_F(ConsoleTest, SaysWhatIsWrongWithALongQuestionInShort) {
  const auto client = page(cookie());
  const std::string answer = said(*client, "(watch 1 \"(" + std::string(15'000, 'x') + " ?y)\")");
  EXPECT_TRUE(has(answer, "{\"watch\":1,\"error\":{"));
  EXPECT_LT(answer.size(), 3000u);
  const std::string all(15'000, 'x');
  EXPECT_LT(refusal_text(1, Failure{"malformed", all, Datum::string(all), all}).size(), 3000u);
}

// A page and a viewer alike.
TEST_F(ConsoleTest, ClosesWhoLeavesItsAnswersUnread) {
  int ends[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  {
    web::WebSocket socket(executor_, web::UpgradedSocket(nullptr, ends[0], ""),
                          {.text = [](std::string_view) {}, .room = [] {}, .ended = [] {}});
    const std::string answer(100'000, 'x');
    for (int i = 0; i < 10; ++i) socket.send(web::WebSocket::Class::control, answer);
    EXPECT_EQ(socket.waiting(), 10 * answer.size()) << "so much may wait";
    for (int i = 0; i < 1000; ++i) socket.send(web::WebSocket::Class::control, answer);
    EXPECT_EQ(socket.waiting(), 0u) << "nothing of it is kept";
    std::string got(200, '\0');
    ssize_t size = 0;
    executor_.run_until([&] {
      size = ::recv(ends[1], got.data(), got.size(), MSG_DONTWAIT);
      return size > 0 || tick();
    });
    got.resize(static_cast<std::size_t>(size));
    EXPECT_TRUE(begins(got, "\x88")) << "a close frame comes first";
    EXPECT_TRUE(has(got, "\x03\xf0too many answers are left unread")) << "1008";
  }
  for (const int end : ends) ::close(end);
}

TEST_F(ConsoleTest, OpensSoManyPagesAndNoMore) {
  const std::string own = cookie();
  std::vector<std::unique_ptr<RawClient>> clients;
  for (std::size_t i = 0; i < Console::max_pages; ++i) clients.push_back(page(own));
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade_headers(own)), "HTTP/1.1 503"));
  EXPECT_TRUE(begins(head("GET", "/socket", {{"Cookie", own}}), "HTTP/1.1 503")) << "a page that asks why is told";
  clients.pop_back();
  executor_.run_until([&] { return console_->pages() < Console::max_pages || tick(); });
  EXPECT_TRUE(begins(head("GET", "/socket", upgrade_headers(own)), "HTTP/1.1 101"));
}

TEST_F(ConsoleTest, ClosesWithEveryPageGoneFromTheBoard) {
  const auto client = page(cookie());
  const auto here = [&](const Datum& name) {
    return run(executor_, here_->facts(list("agent"_sym, name, "console"_sym, "?"_sym)));
  };
  ASSERT_EQ(here("console-1"_sym)->size(), 1u);
  const Job closing = executor_.spawn(console_->close());
  executor_.run_until([&] { return closing.done(); });
  EXPECT_TRUE(here("?"_sym)->empty());
  EXPECT_EQ(console_->pages(), 0u);
}

}  // namespace
}  // namespace pizarra::console
