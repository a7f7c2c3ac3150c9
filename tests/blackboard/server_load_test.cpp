// A client that asks, sends, opens or keeps too much is limited, and nobody else notices.

#include <set>

#include "blackboard/limits.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

using ServerLoad = ServerTest;

TEST_F(ServerLoad, WhatTakesLookingAtTooManyFactsIsRefusedToWhoAsksItAlone) {
  Client greedy = client();
  Client polite = client();
  const std::string asking = greedy.join("greedy");
  const std::string telling = polite.join("polite");
  Transaction facts;
  for (int n = 0; n < 600; ++n) facts.tell(list("note"_sym, n, "same"_sym));
  ASSERT_TRUE(board.transact("test", facts).has_value());
  // Each pair is looked at, and none fits; the transactions look through the relation once a step.
  std::string steps;
  for (int i = 0; i < 500; ++i) steps += "(retract (note ? (f ?x ?x)))";
  std::string absences;
  for (int i = 0; i < 500; ++i) absences += "(absent (note ?n (f ?x ?x)))";
  int request = 0;
  for (const std::string& body : {std::string("(ask (and (note ?a ?t) (note ?b ?u) (/= ?t ?u)))"),
                                  "(transact () (" + steps + "))", "(transact (" + absences + ") ())"}) {
    const Datum refused = greedy.ask("(request " + asking + " " + std::to_string(++request) + " " + body + ")");
    ASSERT_TRUE(refused.is_form("reply")) << write(refused);
    EXPECT_EQ(refused[2][1], "too-costly"_sym) << write(refused);
    const Datum told =
        polite.ask("(request " + telling + " " + std::to_string(request) + " (transact () ((tell (note 1 " +
                   std::string(static_cast<std::size_t>(request), 'x') + ") 0))))");
    EXPECT_TRUE(told[2].is_form("ok")) << write(told);
  }
  EXPECT_EQ(refusals("greedy"), std::vector<Datum>{read("(too-costly 3)")});
  EXPECT_TRUE(refusals("polite").empty());
}

// Its answers come when all is looked through, or joined; what another says meanwhile is answered before.
TEST_F(ServerLoad, WhoBeginsWatchesAmongManyFactsLetsOthersBeServedBetween) {
  constexpr int facts = 150'000;
  constexpr int a_transaction = 5000;
  for (int n = 0; n < facts; n += a_transaction) {
    Transaction some;
    for (int i = n; i < n + a_transaction; ++i) some.tell(list("note"_sym, i, i % 7));
    ASSERT_TRUE(board.transact("test", some).has_value());
  }
  Client greedy = client();
  Client polite = client();
  const std::string watching = greedy.join("greedy");
  const std::string own = polite.join("polite");
  constexpr int watches = 8;
  int asked = 0;
  // Begins them, or has them begin again on another connection, and a moment later another asks.
  const auto changes_before_a_pong = [&](Client& watcher, const std::vector<std::string>& frames) {
    for (const std::string& frame : frames) watcher.send(frame);
    pass(executor, 1ms);
    EXPECT_EQ(polite.ask("(ping " + own + ")").head(), "pong");
    int changes = 0;
    for (Datum message = watcher.receive(1ms); message != Datum(); message = watcher.receive(1ms)) {
      if (message.is_form("change")) ++changes;
    }
    return changes;
  };
  const auto wait_for_changes = [&](Client& watcher, int some) {
    for (int changes = 0; changes < some;) {
      const Datum message = watcher.receive();
      ASSERT_NE(message, Datum());
      if (message.is_form("change")) ++changes;
    }
  };
  std::vector<std::string> begins;
  for (int i = 1; i <= watches; ++i) {
    begins.push_back("(request " + watching + " " + std::to_string(++asked) + " (watch " + std::to_string(i) +
                     " (and (note ?n ?what) (< ?what 0))))");
  }
  const int before = changes_before_a_pong(greedy, begins);
  EXPECT_LT(before, watches / 2);
  wait_for_changes(greedy, watches - before);
  Client again = client();
  const int before_again = changes_before_a_pong(again, {"(hello \"greedy\" " + watching + ")"});
  EXPECT_LT(before_again, watches / 2);
  wait_for_changes(again, watches - before_again);
}

TEST_F(ServerLoad, AClientThatDoesNotAcknowledgeGetsSixteenChangesAndLaterOneThatSaysAll) {
  Client slow = client();
  const std::string session = slow.join("slow");
  ASSERT_EQ(slow.ask("(request " + session + " 1 (watch 7 (note ?n ?text)))"), read("(reply 1 (ok ()))"));
  const int many = 3000;
  for (int i = 0; i < many; ++i) {
    Transaction transaction;
    transaction.tell(list("note"_sym, 1, i));
    ASSERT_TRUE(board.transact("fast", transaction).has_value());
    if (i % 100 != 0) continue;
    slow.send("(ping " + session + ")");
    pass(executor, 1ms);
  }
  std::int64_t sequence = 0;
  for (Datum message = slow.receive(100ms); message != Datum(); message = slow.receive(100ms)) {
    if (!message.is_form("change")) continue;
    EXPECT_EQ(message[2].integer(), ++sequence);
  }
  EXPECT_EQ(sequence, 16);
  slow.send("(ack " + session + " 7 " + std::to_string(sequence) + ")");
  const Datum next = slow.receive();
  ASSERT_TRUE(next.is_form("change")) << write(next);
  EXPECT_EQ(next[3], to_datum(many));
  EXPECT_TRUE(next[4].is_symbol("yes"));
  EXPECT_EQ(next[5][0][0][4], list("note"_sym, 1, many - 1));
}

TEST_F(ServerLoad, AClientThatReadsNothingDelaysNobody) {
  Client deaf(executor, server->addresses().front(), 1);
  const std::string session = deaf.join("deaf");
  Transaction heavy;
  heavy.tell(list("note"_sym, 1, std::string(100'000, 'x')));
  ASSERT_TRUE(board.transact("fast", heavy).has_value());
  // More than the sockets and their queues hold.
  for (int i = 0; i < 600; ++i)
    deaf.send("(request " + session + " " + std::to_string(i + 1) + " (ask (note 1 ?text)))");
  Client other = client();
  const std::string own = other.join("other");
  for (int i = 1; i <= 20; ++i) {
    const std::string number = std::to_string(i);
    const Datum reply =
        other.ask("(request " + own + " " + number + " (transact () ((tell (note 2 " + number + ") 0))))");
    ASSERT_EQ(reply.head(), "reply");
  }
  int replies = 0;
  while (deaf.receive(200ms) != Datum()) ++replies;
  EXPECT_LT(replies, 600) << "its queue was full";
  EXPECT_EQ(deaf.ask("(request " + session + " 601 (ask (note 2 ?text)))")[2].head(), "ok");
}

TEST_F(ServerLoad, RepliesAreRememberedUpToABoundOfBytes) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const auto take = [&](int i) {
    return "(request " + session + " " + std::to_string(i) + " (take (note " + std::to_string(i) + " ?) 1))";
  };
  ASSERT_EQ(board.lease(60s).value(), 1U);
  constexpr std::size_t heavy = 500'000;
  const int more = static_cast<int>(server::KeptReplies::most_bytes / heavy) + 2;
  for (int i = 1; i <= more; ++i) {
    Transaction told;
    told.tell(list("note"_sym, i, std::string(heavy, 'x')));
    ASSERT_TRUE(board.transact("test", told).has_value());
    const Datum reply = client.ask(take(i));
    ASSERT_TRUE(reply.is_form("reply")) << write(reply).substr(0, 200);
    ASSERT_TRUE(reply[2].is_form("ok")) << write(reply).substr(0, 200);
    ASSERT_EQ(client.ask(take(i)), reply);
  }
  EXPECT_EQ(client.ask(take(1))[2][1], "bad-frame"_sym);
  EXPECT_TRUE(client.ask(take(more - 1)).is_form("reply"));
}

TEST_F(ServerLoad, WhoOpensSessionsWithoutEndIsRefusedCountedAndLeavesRoomForOthers) {
  std::vector<std::unique_ptr<Client>> greedy;
  for (std::size_t i = 0; i < server::Sessions::most_of_a_name; ++i) {
    greedy.push_back(std::make_unique<Client>(executor, server->addresses().front()));
    greedy.back()->join("greedy");
  }
  Client one_more = client();
  const Datum refused = one_more.ask("(hello \"greedy\" 0)");
  ASSERT_TRUE(refused.is_form("refused")) << write(refused);
  EXPECT_TRUE(refused[1][1].is_symbol("too-large")) << write(refused);
  Client polite = client();
  EXPECT_EQ(polite.ask("(ping " + polite.join("polite") + ")").head(), "pong");
  EXPECT_EQ(refusals(""), std::vector<Datum>{list("too-large"_sym, 1)});
}

TEST_F(ServerLoad, ClientsOfAFormerLifeTakeNoRoomFromNewOnesAndTheNewestHaveTheirAnswers) {
  constexpr std::size_t many = 2 * server::Sessions::most_remembered;
  server::BoardServerOptions options;
  options.addresses = {"tcp://127.0.0.1:*"};
  for (std::size_t i = 1; i <= many; ++i) options.remembered.push_back({i, "former", 1, read("(ok 5)"), ""});
  server = server::BoardServer::open(executor, board, options).value();
  EXPECT_EQ(server->sessions(), server::Sessions::most_remembered);
  Client stranger = client();
  EXPECT_EQ(stranger.ask("(ping " + stranger.join("former") + ")").head(), "pong");
  Client newest = client();
  const std::string session = std::to_string(many);
  ASSERT_EQ(write(newest.ask("(hello \"former\" " + session + ")")[1]), session);
  EXPECT_EQ(newest.ask("(request " + session + " 1 (take (note 1 ?) 0))")[2], read("(ok 5)"));
  Client oldest = client();
  EXPECT_NE(write(oldest.ask("(hello \"former\" 1)")[1]), "1");
}

TEST_F(ServerLoad, WhoAsksForLeasesWithoutEndIsRefusedCountedAndLeavesThemToOthers) {
  Client greedy = client();
  const std::string session = greedy.join("greedy");
  std::size_t number = 0;
  const auto request = [&](const std::string& body) {
    return "(request " + session + " " + std::to_string(++number) + " (" + body + "))";
  };
  for (std::size_t i = 0; i < server::KeyRights::most_leases; ++i) {
    greedy.send(request("lease 60000000"));
    // As many as wait for it without being lost.
    if (i % 128 == 127) {
      for (int n = 0; n < 128; ++n) ASSERT_TRUE(greedy.receive()[2].is_form("ok"));
    }
  }
  const Datum refused = greedy.ask(request("lease 60000000"))[2];
  ASSERT_TRUE(refused.is_form("fail")) << write(refused);
  EXPECT_TRUE(refused[1].is_symbol("too-large"));
  EXPECT_EQ(refusals("greedy"), std::vector<Datum>{list("too-large"_sym, 1)});
  Client polite = client();
  const std::string own = polite.join("polite");
  EXPECT_TRUE(polite.ask("(request " + own + " 1 (lease 60000000))")[2].is_form("ok"));
  // What it gives back it may ask for again.
  greedy.ask(request("release 1"));
  EXPECT_TRUE(greedy.ask(request("lease 60000000"))[2].is_form("ok"));
}

// Each connection is served in turn: between two frames of the polite client's come few of the flooder's, and not all
// that it has sent before.
TEST_F(ServerLoad, AFloodDelaysNobodyByMoreThanItsShare) {
  std::vector<std::unique_ptr<Client>> flooders;
  std::vector<std::string> sessions;
  constexpr int connections = 4;
  constexpr int flood = 900;
  for (int i = 0; i < connections; ++i) {
    flooders.push_back(std::make_unique<Client>(executor, server->addresses().front(), 100'000));
    sessions.push_back(flooders.back()->join("flooder"));
  }
  Client polite = client();
  const std::string own = polite.join("polite");
  int sent = 0;
  const auto pour = [&](int count) {
    for (int n = 0; n < count; ++n, ++sent) {
      const auto which = static_cast<std::size_t>(sent % connections);
      flooders[which]->send("(request " + sessions[which] + " " + std::to_string(sent + 1) +
                            " (transact () ((tell (note " + std::to_string(10 + which) + " " + std::to_string(sent) +
                            ") 0))))");
    }
  };
  int asked = 0;
  const auto most_served_between = [&] {
    pour(connections * flood);
    Revision most = 0;
    for (int i = 0; i < 10; ++i) {
      const Revision before = board.store().revision();
      const std::string number = std::to_string(++asked);
      const Datum reply =
          polite.ask("(request " + own + " " + number + " (transact () ((tell (note 1 " + number + ") 0))))");
      const auto committed = static_cast<Revision>(reply[2][1].integer());
      most = std::max(most, committed - before);
      pour(connections * 50);
    }
    return most;
  };
  // Others on the machine may hold a message up before it comes to the server, but not in every round.
  Revision served_between = most_served_between();
  for (int round = 1; round < 5; ++round) served_between = std::min(served_between, most_served_between());
  EXPECT_LT(served_between, Revision{connections * flood / 2}) << "of " << sent << " that were sent";
}

TEST_F(ServerLoad, AFloodBesideOthersIsRefusedCountedAndLosesNothingThatWasAcknowledged) {
  constexpr int most = 200;
  serve(10s, {.most = most, .window = 60s});
  Client flooder(executor, server->addresses().front(), 100'000);
  Client polite = client();
  const std::string flooding = flooder.join("flooder");
  const std::string own = polite.join("polite");
  const auto tell = [](const std::string& session, int number, int note) {
    const std::string fact = "(note " + std::to_string(note) + " x)";
    return "(request " + session + " " + std::to_string(number) + " (transact () ((tell " + fact + " 0))))";
  };
  ASSERT_TRUE(polite.ask(tell(own, 1, -1))[2].is_form("ok"));
  constexpr int flood = 768;
  constexpr int wave = 128;  // whose answers all wait for it without being lost
  std::set<std::int64_t> acknowledged;
  std::set<std::int64_t> refused;
  for (int sent = 0; sent < flood; sent += wave) {
    for (int i = 1; i <= wave; ++i) flooder.send(tell(flooding, sent + i, sent + i));
    for (int i = 1; i <= 2; ++i) EXPECT_TRUE(polite.ask(tell(own, 1 + sent + i, -i))[2].is_form("ok"));
    for (int i = 0; i < wave; ++i) {
      const Datum reply = flooder.receive();
      ASSERT_TRUE(reply.is_form("reply")) << write(reply);
      const bool done = reply[2].is_form("ok");
      if (!done) {
        EXPECT_EQ(reply[2][1], "too-many"_sym) << write(reply);
      }
      (done ? acknowledged : refused).insert(reply[1].integer());
    }
  }
  EXPECT_EQ(acknowledged.size(), most);
  EXPECT_EQ(refused.size(), flood - most);
  const Result<Answers> stand = board.ask(query("(query (note ?n x) (order ?n))"));
  std::set<std::int64_t> standing;
  for (const Answer& answer : stand->answers) standing.insert(answer.facts.front().datum[1].integer());
  std::erase_if(standing, [](std::int64_t n) { return n < 0; });
  EXPECT_EQ(standing, acknowledged);
  EXPECT_EQ(refusals("flooder"), std::vector<Datum>{list("too-many"_sym, flood - most)});
  // One that was done is answered as it was, however much else is refused.
  EXPECT_TRUE(flooder.ask(tell(flooding, static_cast<int>(*acknowledged.rbegin()), 1))[2].is_form("ok"));
}

// A client that hears nothing for a second asks again, and may have been answered meanwhile that it was not done.
TEST_F(ServerLoad, WhatWasTooMuchIsNotDoneWhenItComesAgainLater) {
  constexpr Duration window = 200ms;
  serve(10s, {.most = 1, .window = window});
  Client flooder = client();
  Client polite = client();
  const std::string flooding = flooder.join("flooder");
  const std::string own = polite.join("polite");
  const auto tell = [](const std::string& session, int number) {
    const std::string text = std::to_string(number);
    return "(request " + session + " " + text + " (transact () ((tell (note " + text + " x) 0))))";
  };
  Datum refused;
  int number = 0;
  while (number < 100 && !refused.is_form("fail")) {
    polite.ask(tell(own, ++number));
    refused = flooder.ask(tell(flooding, 100 + number))[2];
  }
  ASSERT_TRUE(refused.is_form("fail"));
  ASSERT_EQ(refused[1], "too-many"_sym);
  pass(executor, 2 * window);
  EXPECT_EQ(flooder.ask(tell(flooding, 100 + number))[2], refused);
  EXPECT_TRUE(board.ask(query_for(list("note"_sym, 100 + number, "?"_sym)))->answers.empty());
  EXPECT_TRUE(flooder.ask(tell(flooding, 101 + number))[2].is_form("ok")) << "what is new is done";
}

// The server does not come to read at all.
TEST_F(ServerLoad, WhatAClientSendsAheadIsHeldToABound) {
  zmq::context_t context{1};
  zmq::socket_t flooder(context, zmq::socket_type::dealer);
  flooder.set(zmq::sockopt::linger, 0);
  flooder.set(zmq::sockopt::sndhwm, 1);
  flooder.set(zmq::sockopt::sndtimeo, 500);
  flooder.connect(server->addresses().front());
  const std::string large(limits::frame_bytes, 'x');
  int sent = 0;
  while (sent < 300 && flooder.send(zmq::buffer(large), zmq::send_flags::none)) ++sent;
  constexpr int network = 16;  // holds some as well
  EXPECT_GE(sent, wire::WireSocket::read_ahead);
  EXPECT_LE(sent, wire::WireSocket::read_ahead + network);
}

TEST_F(ServerLoad, AFrameBeyondTheLimitIsRefusedAndOneFarBeyondItEndsItsConnectionAlone) {
  Client other = client();
  const std::string session = other.join("other");
  Client large = client();
  large.join("large");
  EXPECT_TRUE(large.ask("\"" + std::string(3 * limits::frame_bytes / 2, 'x') + "\"").is_form("refused"));
  Client huge = client();
  huge.join("huge");
  huge.send("\"" + std::string(8 * limits::frame_bytes, 'x') + "\"");
  EXPECT_EQ(huge.receive(100ms), Datum());
  EXPECT_EQ(other.ask("(ping " + session + ")").head(), "pong");
}

}  // namespace
}  // namespace pizarra
