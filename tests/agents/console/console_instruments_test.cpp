// A page's truth overlay and its measurements of the board.

#include <fmt/format.h>

#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/tokens.hpp"
#include "tests/agents/console/console_fixture.hpp"
#include "tests/scratch.hpp"

namespace pizarra::console {
namespace {

Task<Result<Datum>> answered(int& asked) {
  ++asked;
  Datum truth = list(list("cube"_sym, "circle"_sym, 911.5, 2, 30));
  co_return truth;
}

TEST_F(ConsoleTest, TheTruthGoesToThePageThatLooksAndToNoBoard) {
  std::string journal;
  board_.set_journal([&journal](std::string_view line) { journal.append(line).append("\n"); });
  int asked = 0;
  reopen([&asked](Console::Setup& setup) { setup.truth = [&asked] { return answered(asked); }; });
  const auto client = page(cookie());
  EXPECT_EQ(asked, 0) << "nobody looks";
  EXPECT_EQ(said(*client, "(truth)"), "{\"truth\":\"((cube circle 911.5 2 30))\"}");
  EXPECT_TRUE(serve([&] { return client->read_frame(); })) << "and again";
  client->send_frame(RawClient::text, "(truth-no-more)");
  // A request that is sent after it is answered after it has ended.
  const std::string stopped = serve([&] {
    client->send_frame(RawClient::text, "(stop 1 \"over\")");
    while (const auto frame = client->read_frame()) {
      if (frame->payload.starts_with("{\"reply\":1")) return frame->payload;
    }
    return std::string();
  });
  EXPECT_TRUE(has(stopped, "\"values\":[]"));
  const int until_then = asked;
  run(executor_, [](Executor& executor) -> Task<bool> {
    co_await sleep(executor, 3 * TruthFeed::pause);
    co_return true;
  }(executor_));
  EXPECT_LE(asked, until_then + 1) << "nobody looks any more";
  EXPECT_TRUE(has(journal, "stop"));
  EXPECT_EQ(journal.find("911.5"), std::string::npos);
}

TEST_F(ConsoleTest, TheTruthIsOfferedToNoPageOfAnotherMachine) {
  const std::string keys = scratch_folder() + "keys";
  ASSERT_TRUE(wire::make_keys(keys, "anna", {}));
  int asked = 0;
  reopen([&](Console::Setup& setup) {
    setup.truth = [&asked] { return answered(asked); };
    setup.abroad = Console::Abroad{"127.0.0.1", {"127.0.0.1"}, {}, {}, keys};
  });
  const std::string token = wire::make_token(keys, "anna").value();
  const Headers from_there{{"Origin", fmt::format("https://127.0.0.1:{}", port_)}};
  Headers log_in = from_there;
  log_in["Authorization"] = "Bearer " + token;
  const std::string answer = head("POST", "/session", log_in);
  const std::size_t begin = answer.find("Set-Cookie: ") + 12;
  Headers upgrade = upgrade_headers(answer.substr(begin, answer.find(';', begin) - begin));
  upgrade.insert(from_there.begin(), from_there.end());
  RawClient client(port_);
  const auto hello = serve([&] {
    client.send(request_text(port_, "GET", "/socket", upgrade));
    client.read_head();
    return client.read_frame();
  });
  ASSERT_TRUE(hello);
  EXPECT_TRUE(has(hello->payload, "\"truth\":false"));
  client.send_frame(RawClient::text, "(truth)");
  EXPECT_TRUE(has(said(client, "(watch 1 \"(on ?x\")"), "query:1:1"));
  EXPECT_EQ(asked, 0);
}

TEST_F(ConsoleTest, AsksOnceWhatHoldsAndNothingOfWhatNobodyHasDeclared) {
  declare("(relation number ((n integer) (text string)) (key n))");
  ASSERT_TRUE(run(executor_, here_->tell(list("number"_sym, 1, "one"))));
  const auto client = page(cookie());
  EXPECT_TRUE(has(said(*client, "(ask 1 (number ?n ?text))"), R"("?text":"\"one\"")"));
  EXPECT_TRUE(has(said(*client, "(ask 2 (nobody-declared ?n))"), R"({"watch":2,"revision")"));
}

Task<Result<std::string>> refused() { co_return fail("not-permitted", "this key may not"); }

TEST_F(ConsoleTest, MeasuresWithTheRightsOfItsPage) {
  std::string of;
  reopen([&of](Console::Setup& setup) {
    setup.instruments.method = [&of](Board&, const std::string& name, const Instruments::Connect& connect,
                                     Duration length) {
      of = fmt::format("{} {} {}", name, length / 1s, connect(name + "-1").has_value());
      return refused();
    };
  });
  const auto client = page(cookie());
  EXPECT_TRUE(has(said(*client, "(method 5 4000)"), "this key may not"));
  EXPECT_EQ(of, "console-1-method 60 true");
}

Task<Result<std::string>> seen_when(Event* may) {
  co_await may->wait();
  co_return R"({"cells":[],"more":false})";
}

TEST_F(ConsoleTest, LooksAtTheCellsOfAHallOnceAtATime) {
  Event may(executor_);
  reopen([&may](Console::Setup& setup) {
    setup.instruments.cells = [&may](const std::string&) { return seen_when(&may); };
  });
  const auto client = page(cookie());
  serve([&] {
    client->send_frame(RawClient::text, "(cells 5)");
    return true;
  });
  EXPECT_TRUE(has(said(*client, "(cells 6)"), R"({"reply":6,"error":{"symbol":"too-many")"));
  may.set();
  EXPECT_TRUE(begins(serve([&] { return client->read_frame()->payload; }), R"({"reply":5,"values")"));
  EXPECT_TRUE(begins(said(*client, "(cells 7)"), R"({"reply":7,"values")")) << "and again";
}

TEST_F(ConsoleTest, ACellWithoutInstrumentsSaysSo) {
  const auto client = page(cookie());
  EXPECT_TRUE(has(said(*client, "(cells 4)"), "unknown-operation"));
  EXPECT_TRUE(has(said(*client, "(method 5 10)"), "unknown-operation"));
}

}  // namespace
}  // namespace pizarra::console
