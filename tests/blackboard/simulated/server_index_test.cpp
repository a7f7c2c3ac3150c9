// An index that a request needs is made in parts, between which others are served; the request waits for it.

#include <algorithm>
#include <map>
#include <set>

#include "blackboard/wire/answer_form.hpp"
#include "tests/blackboard/simulated/simulated_server.hpp"

namespace pizarra::simulated {
namespace {

class ServerIndex : public SimulatedServer {
 protected:
  static constexpr int facts = 120'000;
  static constexpr int alike = facts / 6;

  ServerIndex() {
    constexpr int a_transaction = 5000;
    for (int n = 0; n < facts; n += a_transaction) {
      Transaction some;
      for (int i = n; i < n + a_transaction; ++i) some.tell(list("note"_sym, i, i % alike));
      EXPECT_TRUE(board.transact("test", some).has_value());
    }
  }
  static std::string request(const std::string& session, int number, const std::string& body) {
    return "(request " + session + " " + std::to_string(number) + " " + body + ")";
  }
  std::string ask_other(int number, const std::string& body) {
    const Datum reply = other.ask(request(others, number, body));
    return reply.is_form("reply") ? std::string(reply[2].head()) : write(reply);
  }
  // Asks what needs an index, and lets the making begin.
  void ask_oddly(int number = 1) {
    odd.send(request(odds, number, asked));
    pass(frame_delay);
    ASSERT_TRUE(is_making());
  }
  bool is_making() { return !board.store().index_maker().is_idle(); }
  // Of the notes that are answered.
  static std::vector<std::int64_t> numbers(const Datum& reply) {
    std::vector<std::int64_t> found;
    if (!reply.is_form("reply") || !reply[2].is_form("ok")) return found;
    for (const Datum& answer : reply[2][1].items().subspan(1)) {
      const std::string text = write(answer);
      const std::size_t at = text.find("(note ");
      found.push_back(std::stoll(text.substr(at + 6)));
    }
    return found;
  }
  // The notes of each answer.
  using Held = std::set<std::vector<std::int64_t>>;
  // The facts that the changes of this query's watch leave.
  Held hear_all(const std::string& asked_for, Held held = {}) {
    const Query watched = query(asked_for);
    for (Datum change = odd.receive(); change != Datum(); change = odd.receive(300ms)) {
      EXPECT_TRUE(change.is_form("change"));
      follow(held, wire::delta_from_datum(watched, false, change).value());
    }
    return held;
  }
  static void follow(Held& held, const Delta& delta) {
    if (delta.kind == Delta::Kind::all || delta.kind == Delta::Kind::first_part) held.clear();
    for (std::vector<std::int64_t>& answer : answers_of(delta.removed)) EXPECT_EQ(held.erase(answer), 1U);
    for (std::vector<std::int64_t>& answer : answers_of(delta.added)) EXPECT_TRUE(held.insert(answer).second);
  }
  static std::vector<std::vector<std::int64_t>> answers_of(const Delta::Side& side) {
    std::vector<std::vector<std::int64_t>> answers(side.answers);
    for (std::size_t i = 0; i < side.facts.size(); ++i) {
      answers[i * side.answers / side.facts.size()].push_back(side.facts[i].datum[1].integer());
    }
    return answers;
  }
  static constexpr const char* asked = "(ask (note ?n 7))";

  Client odd{*this, "odd"};
  Client other{*this, "other"};
  const std::string odds = odd.join();
  const std::string others = other.join();
};

TEST_F(ServerIndex, OthersAreServedBetweenItsParts) {
  ask_oddly();
  for (int n = 1; n <= 3; ++n) {
    EXPECT_TRUE(other.ask("(ping " + others + ")").is_form("pong"));
    EXPECT_EQ(ask_other(n, "(transact () ((tell (note -1 x) 0)))"), "ok");
    EXPECT_TRUE(is_making()) << n;
  }
  EXPECT_EQ(numbers(odd.receive()).size(), 6U);
  EXPECT_FALSE(is_making());
  pass(2 * server::Refusals::pause);
  EXPECT_TRUE(board.ask(query("(board-refusal ? ? ? ?)"))->answers.empty());
}

TEST_F(ServerIndex, WhatChangesMeanwhileIsInTheAnswer) {
  ask_oddly();
  int number = 0;
  const auto change = [&](const std::string& steps) {
    EXPECT_EQ(ask_other(++number, "(transact () (" + steps + "))"), "ok");
  };
  change("(tell (note 900000 7) 0) (retract (note 7 ?))");
  change("(tell (note 8 7) 0) (tell (note 119998 7) 0)");
  change("(tell (note 20007 8) 0) (retract (note 100007 ?))");
  std::vector<std::int64_t> found = numbers(odd.receive());
  std::ranges::sort(found);
  EXPECT_EQ(found, (std::vector<std::int64_t>{8, 40007, 60007, 80007, 119998, 900000}));
}

TEST_F(ServerIndex, TheRequestsOfAClientStayInTheirOrder) {
  ask_oddly();
  odd.send(request(odds, 2, "(transact () ((tell (note 900000 7) 0)))"));
  odd.send(request(odds, 2, "(transact () ((tell (note 900000 7) 0)))"));
  odd.send(request(odds, 3, "(take (note ? 7) 0)"));
  odd.send(request(odds, 3, "(take (note ? 7) 0)"));
  odd.send(request(odds, 4, asked));
  std::vector<Datum> replies;
  for (Datum reply = odd.receive(); reply != Datum(); reply = odd.receive(300ms)) replies.push_back(reply);
  ASSERT_EQ(replies.size(), 4U) << "what comes again while it waits is done once";
  for (std::size_t i = 0; i < replies.size(); ++i) EXPECT_EQ(replies[i][1], to_datum(i + 1));
  EXPECT_EQ(numbers(replies[0]), (std::vector<std::int64_t>{7, 20007, 40007, 60007, 80007, 100007}));
  EXPECT_EQ(numbers(replies[3]), (std::vector<std::int64_t>{20007, 40007, 60007, 80007, 100007, 900000}));
}

TEST_F(ServerIndex, WhatIsRefusedForWantOfRoomStaysRefusedWhenItComesAgain) {
  constexpr int asking = static_cast<int>(server::Postponed::most_requests) + 60;
  ask_oddly();
  const auto tell = [&](std::int64_t n) {
    return request(odds, static_cast<int>(n), "(transact () ((tell (note " + std::to_string(900'000 + n) + " x) 0)))");
  };
  for (int first = 2; first <= asking; first += 60) {
    std::string frame;
    for (int n = first; n <= std::min(first + 59, asking); ++n) frame += tell(n) + " ";
    odd.send(frame);
  }
  std::map<std::int64_t, Datum> refused;
  for (Datum reply = odd.receive(); reply != Datum(); reply = odd.receive(500ms)) {
    ASSERT_TRUE(reply.is_form("reply"));
    if (reply[2].is_form("fail")) refused[reply[1].integer()] = reply[2];
  }
  ASSERT_FALSE(refused.empty());
  const auto& [last, refusal] = *refused.rbegin();
  EXPECT_EQ(refusal[1], "too-many"_sym);
  EXPECT_EQ(odd.ask(tell(last))[2], refusal);
  for (const auto& [n, said] : refused) {
    EXPECT_EQ(said, refusal) << n;
    EXPECT_TRUE(board.ask(query("(note " + std::to_string(900'000 + n) + " ?)"))->answers.empty()) << n;
  }
}

// Whoever was cut off and asks again learns of each request what came of it.
TEST_F(ServerIndex, OfAllThatMayWaitIsKnownLaterWhatCameOfIt) {
  constexpr int asking = 720;
  ask_oddly();
  const auto tell = [&](int n) {
    return request(odds, n, "(transact () ((tell (note " + std::to_string(900'000 + n) + " x) 0)))");
  };
  for (int n = 2; n <= asking; n += 60) {
    std::string frame;
    for (int i = n; i < std::min(n + 60, asking + 1); ++i) frame += tell(i);
    odd.send(frame);
  }
  while (odd.receive(500ms) != Datum()) {
  }
  std::size_t done = 0;
  for (int n = 2; n <= asking; ++n) {
    const Datum again = odd.ask(tell(n))[2];
    const bool stands = !board.ask(query("(note " + std::to_string(900'000 + n) + " ?)"))->answers.empty();
    EXPECT_EQ(again.is_form("ok"), stands) << n << ": " << write(again);
    if (stands) ++done;
  }
  EXPECT_EQ(done, server::Postponed::most_requests - 1) << "the first that waits is a question";
}

TEST_F(ServerIndex, ALeaseIsRenewedMeanwhile) {
  const Datum lease = odd.ask(request(odds, 1, "(lease 2000000)"))[2][1];
  ask_oddly(2);
  EXPECT_EQ(odd.ask(request(odds, 3, "(renew " + write(lease) + ")"))[1], to_datum(3));
  EXPECT_EQ(odd.receive()[1], to_datum(2));
}

TEST_F(ServerIndex, WhoLeavesMeanwhileLeavesNothingButTheIndex) {
  ask_oddly();
  odd.send(request(odds, 2, "(watch 1 (note ?n 7))"));
  odd.send("(hello \"odd\" " + odds + ")");
  odd.send("(bye " + odds + ")");
  EXPECT_EQ(numbers(other.ask(request(others, 1, asked))).size(), 6U);
  pass(50ms);
  EXPECT_EQ(server->sessions(), 1U);
  server.reset();
  serve();
  Client next(*this, "next");
  EXPECT_EQ(numbers(next.ask(request(next.join(), 1, asked))).size(), 6U);
}

TEST_F(ServerIndex, AServerThatEndsMeanwhileLeavesTheRestToTheNext) {
  ask_oddly();
  server.reset();
  EXPECT_EQ(board.ask(query("(note ?n 7)")).value().answers.size(), 6U);
  serve();
  Client next(*this, "next");
  EXPECT_EQ(numbers(next.ask(request(next.join(), 1, "(ask (note ?n 8))"))).size(), 6U);
  pass(5ms);
  EXPECT_FALSE(is_making());
}

TEST_F(ServerIndex, AWatchBeginsWithAllThatHoldsWhenItIsMade) {
  const std::string query = "(note ?n 7)";
  odd.send(request(odds, 1, "(watch 1 " + query + ")"));
  EXPECT_EQ(ask_other(1, "(transact () ((tell (note 31 7) 0) (retract (note 20007 ?))))"), "ok");
  EXPECT_TRUE(odd.receive().is_form("reply"));
  const Held held = hear_all(query);
  EXPECT_EQ(held, (Held{{7}, {31}, {40007}, {60007}, {80007}, {100007}}));
  EXPECT_EQ(ask_other(2, "(transact () ((tell (note 7 x) 0) (tell (note 32 7) 0)))"), "ok");
  EXPECT_EQ(hear_all(query, held), (Held{{31}, {32}, {40007}, {60007}, {80007}, {100007}}));
}

TEST_F(ServerIndex, AWatchOfAJoinBeginsWithAllThatHoldsWhenItIsMade) {
  const std::string query = "(and (note ?n 7) (note ?m ?n))";
  odd.send(request(odds, 1, "(watch 1 " + query + ")"));
  EXPECT_EQ(ask_other(1, "(transact () ((tell (note 31 7) 0) (retract (note 20007 ?))))"), "ok");
  EXPECT_TRUE(odd.receive().is_form("reply"));
  Held expected{{7, 7}, {7, 31}, {7, 40007}, {7, 60007}, {7, 80007}, {7, 100007}};
  expected.insert({{31, 20031}, {31, 40031}, {31, 60031}, {31, 80031}, {31, 100031}});
  const Held held = hear_all(query);
  EXPECT_EQ(held, expected);
  EXPECT_EQ(ask_other(2, "(transact () ((tell (note 31 x) 0) (tell (note 500000 7) 0)))"), "ok");
  EXPECT_EQ(hear_all(query, held), (Held{{7, 7}, {7, 40007}, {7, 60007}, {7, 80007}, {7, 100007}, {7, 500000}}));
}

// It follows by other ways than it began.
TEST_F(ServerIndex, AWatchThatNeedsOneToFollowBeginsAnewWhenItIsMade) {
  const std::string query = "(and (note 5 ?x) (note ?n ?x))";
  EXPECT_TRUE(board.transact("test", Transaction().tell(read("(note 5 x)"))).has_value());
  odd.send(request(odds, 1, "(watch 1 " + query + ")"));
  EXPECT_TRUE(odd.receive().is_form("reply"));
  for (int n = 1; n <= 5; ++n) {
    const std::string told = std::to_string(n);
    EXPECT_EQ(ask_other(n, "(transact () ((tell (note 5 " + told + ") 0)))"), "ok");
  }
  const Held held = hear_all(query);
  EXPECT_EQ(held, (Held{{5, 5}, {5, 20005}, {5, 40005}, {5, 60005}, {5, 80005}, {5, 100005}}));
  EXPECT_EQ(ask_other(6, "(transact () ((tell (note 5 y) 0) (tell (note 600000 y) 0)))"), "ok");
  EXPECT_EQ(hear_all(query, held), (Held{{5, 5}, {5, 600000}}));
}

TEST(Postponed, HasRoomForSoManyMessagesAndSoMuchOfThem) {
  server::Postponed few;
  const std::string megabyte(1 << 20, 'x');
  few.wait({list("request"_sym, 1, 1, megabyte)});
  for (int n = 2; n <= 3; ++n) EXPECT_TRUE(few.add({list("request"_sym, 1, n, megabyte)}));
  EXPECT_TRUE(few.has_request(1));
  EXPECT_TRUE(few.has_request(3));
  EXPECT_FALSE(few.add({list("request"_sym, 1, 4, megabyte)}));
  EXPECT_FALSE(few.has_request(4));
  EXPECT_TRUE(few.next().has_waited());
  EXPECT_TRUE(few.add({list("request"_sym, 1, 4, megabyte)}));
  server::Postponed many;
  for (std::size_t n = 0; n < server::Postponed::most; ++n) EXPECT_TRUE(many.add({list("bye"_sym, 1)}));
  EXPECT_FALSE(many.add({list("bye"_sym, 1)}));
  server::Postponed asking;
  for (std::size_t n = 1; n <= server::Postponed::most_requests; ++n)
    EXPECT_TRUE(asking.add({list("request"_sym, 1, n)}));
  EXPECT_FALSE(asking.add({list("request"_sym, 1, server::Postponed::most_requests + 1)}));
  EXPECT_TRUE(asking.add({list("unwatch"_sym, 1, 1)}));
}

}  // namespace
}  // namespace pizarra::simulated
