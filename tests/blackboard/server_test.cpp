#include <gtest/gtest.h>
#include <set>
#include <zmq.hpp>

#include "blackboard/limits.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

// A server, and clients that say just what a test has them say.
class ServerTest : public testing::Test {
 protected:
  class Client {
   public:
    Client(Executor& executor, const std::string& address, int room = 1000)
        : executor_(executor), socket_(context_, zmq::socket_type::dealer) {
      socket_.set(zmq::sockopt::linger, 0);
      socket_.set(zmq::sockopt::rcvhwm, room);
      socket_.connect(address);
    }
    void send(const std::string& text) { ASSERT_TRUE(socket_.send(zmq::buffer(text)).has_value()); }
    void send_parts(const std::vector<std::string>& parts) {
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto flags = i + 1 < parts.size() ? zmq::send_flags::sndmore : zmq::send_flags::none;
        ASSERT_TRUE(socket_.send(zmq::buffer(parts[i]), flags).has_value());
      }
    }
    // The next message, or an empty list when patience ends.
    Datum receive(Duration patience = 5s) {
      zmq::message_t message;
      const Time deadline = executor_.now() + patience;
      while (executor_.now() < deadline) {
        if (socket_.recv(message, zmq::recv_flags::dontwait)) return read_one(message.to_string_view()).value();
        pass(executor_, 1ms);
      }
      return {};
    }
    Datum ask(const std::string& text) {
      send(text);
      return receive();
    }
    std::string join(const std::string& teller) {
      const Datum welcome = ask("(hello \"" + teller + "\" 0)");
      EXPECT_TRUE(welcome.is_form("welcome"));
      return welcome.size() == 3 ? write(welcome[1]) : "0";
    }

   private:
    Executor& executor_;
    zmq::context_t context_{1};
    zmq::socket_t socket_;
  };

  ServerTest() {
    EXPECT_TRUE(board.declare("test", {relation("(relation note ((n integer) (text datum)) (key n))")}).has_value());
    serve(10s);
  }
  void serve(Duration session_length, ClientRequests::Limit requests = {}) {
    BoardServerOptions options;
    options.addresses = {"tcp://127.0.0.1:*"};
    options.session_length = session_length;
    options.requests = requests;
    server = BoardServer::open(executor, board, options).value();
  }
  static void pass(Executor& executor, Duration time) {
    bool passed = false;
    executor.call_at(executor.now() + time, [&] { passed = true; });
    executor.run_until([&] { return passed; });
  }
  Client client() { return {executor, server->addresses().front()}; }
  // (SYMBOL COUNT) of what the server refused this client, once it is told.
  std::vector<Datum> refusals(const std::string& teller) {
    pass(executor, 2 * Refusals::pause);
    const Query asked = query_for(list("board-refusal"_sym, teller, "?symbol"_sym, "?count"_sym, "?"_sym));
    std::vector<Datum> counts;
    const Result<Answers> told = board.ask(asked);
    for (const Answer& answer : told->answers) {
      counts.push_back(list(*answer.bindings.find("?symbol"), *answer.bindings.find("?count")));
    }
    return counts;
  }

  RealExecutor executor;
  MemoryBoard board{executor};
  std::unique_ptr<BoardServer> server;
};

TEST_F(ServerTest, WhatWentIsSaidByItsIdToWhoKeepsWhatItWasSent) {
  Client client = this->client();
  const std::string session = client.join("alice");
  ASSERT_TRUE(client.ask("(request " + session + " 1 (transact () ((tell (note 1 a) 0))))").is_form("reply"));
  client.ask("(request " + session + " 2 (watch 1 (note ?n ?text) kept))");
  client.ask("(request " + session + " 3 (watch 2 (note ?n ?text)))");
  for (int first = 0; first < 2; ++first) client.receive();
  const Datum kept = client.ask("(request " + session + " 4 (transact () ((retract (note ? ?)))))");
  const Datum whole = client.receive();
  ASSERT_EQ(kept.size(), 7U) << write(kept);
  ASSERT_EQ(whole.size(), 7U) << write(whole);
  EXPECT_EQ(kept[6], read("(1)")) << write(kept);
  EXPECT_EQ(whole[6][0][0][4], read("(note 1 a)")) << write(whole);
}

TEST_F(ServerTest, WhatTakesLookingAtTooManyFactsIsRefusedToWhoAsksItAlone) {
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

TEST_F(ServerTest, ARequestSentTwiceIsDoneOnce) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const std::string request = "(request " + session + " 1 (transact () ((tell (note 1 a) 0) (retract (note 2 ?)))))";
  const Datum first = client.ask(request);
  EXPECT_EQ(first, read("(reply 1 (ok 1))"));
  ASSERT_EQ(client.ask("(request " + session + " 2 (transact () ((retract (note 1 ?)))))"), read("(reply 2 (ok 2))"));
  EXPECT_EQ(client.ask(request), first);
  EXPECT_EQ(board.store().revision(), 2U);
}

TEST_F(ServerTest, ALeaseAskedForTwiceIsOneLease) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const Datum first = client.ask("(request " + session + " 1 (lease 1000000))");
  EXPECT_EQ(client.ask("(request " + session + " 1 (lease 1000000))"), first);
}

TEST_F(ServerTest, ASessionThatIsNotHeardFromIsForgottenAndToldSo) {
  serve(300ms);
  Client client = this->client();
  const std::string session = client.join("alice");
  client.ask("(request " + session + " 1 (watch 1 (note ?n ?text)))");
  EXPECT_TRUE(client.receive().is_form("change"));
  executor.run_until([&] { return server->sessions() == 0; });
  EXPECT_EQ(client.ask("(ping " + session + ")"), read("(unknown-session " + session + ")"));
}

TEST_F(ServerTest, AClientThatSaysByeIsForgottenAtOnce) {
  Client client = this->client();
  const std::string session = client.join("alice");
  EXPECT_EQ(server->sessions(), 1U);
  client.send("(bye " + session + ")");
  executor.run_until([&] { return server->sessions() == 0; });
}

TEST_F(ServerTest, AClientThatDoesNotAcknowledgeGetsSixteenChangesAndLaterOneThatSaysAll) {
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

TEST_F(ServerTest, AClientThatReadsNothingDelaysNobody) {
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

TEST_F(ServerTest, ANewConnectionOfASessionIsResynchronised) {
  std::string session;
  {
    Client first = client();
    session = first.join("alice");
    first.ask("(request " + session + " 1 (watch 1 (note ?n ?text)))");
    ASSERT_EQ(first.receive()[2], to_datum(1));
  }
  Transaction transaction;
  transaction.tell(list("note"_sym, 1, "a"_sym));
  ASSERT_TRUE(board.transact("fast", transaction).has_value());
  Client second = client();
  EXPECT_EQ(second.ask("(hello \"alice\" " + session + ")")[1], read(session));
  second.send("(ping " + session + ")");
  Datum change = second.receive();
  while (change.is_form("pong")) change = second.receive();
  ASSERT_TRUE(change.is_form("change")) << write(change);
  EXPECT_TRUE(change[4].is_symbol("yes"));
  EXPECT_EQ(change[5].size(), 1U);
}

TEST_F(ServerTest, ASessionCountsOnTheConnectionThatSaidHelloAlone) {
  Client alice = client();
  const std::string session = alice.join("alice");
  Client thief = client();
  const std::string theft = "(request " + session + " 1 (transact () ((tell (note 1 stolen) 0))))";
  EXPECT_EQ(thief.ask(theft), read("(unknown-session " + session + ")"));
  thief.join("thief");
  EXPECT_EQ(thief.ask(theft), read("(unknown-session " + session + ")"));
  EXPECT_EQ(thief.ask("(bye " + session + ")"), read("(unknown-session " + session + ")"));
  EXPECT_EQ(alice.ask("(ping " + session + ")").head(), "pong");
  EXPECT_EQ(board.store().size(), 0U);
  EXPECT_EQ(refusals("thief"), std::vector<Datum>{list("not-permitted"_sym, 2)});
}

TEST_F(ServerTest, AnothersNameDoesNotOpenItsSessionNorDoesItsNumberUnderAnotherName) {
  Client alice = client();
  const std::string session = alice.join("alice");
  Client thief = client();
  const Datum welcome = thief.ask("(hello \"thief\" " + session + ")");
  ASSERT_TRUE(welcome.is_form("welcome"));
  EXPECT_NE(write(welcome[1]), session);
  EXPECT_TRUE(thief.ask("(hello \"alice\" " + session + ")").is_form("refused")) << "it is the thief already";
  EXPECT_EQ(alice.ask("(ping " + session + ")").head(), "pong");
  Client usurper = client();
  EXPECT_TRUE(usurper.ask("(hello \"board\" 0)").is_form("refused"));
}

TEST_F(ServerTest, NumbersOfSessionsShareNothing) {
  std::set<std::string> high_digits;
  constexpr std::size_t many = 16;
  std::vector<std::unique_ptr<Client>> clients;
  for (std::size_t i = 0; i < many; ++i) {
    clients.push_back(std::make_unique<Client>(executor, server->addresses().front()));
    const std::string session = clients.back()->join("alice");
    high_digits.insert(session.substr(0, session.size() / 2));
  }
  EXPECT_EQ(high_digits.size(), many);
}

TEST_F(ServerTest, AHelloSaidTwiceIsOneSession) {
  Client client = this->client();
  const std::string session = client.join("alice");
  EXPECT_EQ(client.join("alice"), session);
  EXPECT_EQ(server->sessions(), 1U);
}

TEST_F(ServerTest, ARequestFarBehindTheOthersIsRefusedAndNotDone) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const int many = static_cast<int>(BoardServer::max_replies) + 2;
  for (int i = 2; i <= many + 1; ++i) client.ask("(request " + session + " " + std::to_string(i) + " (lease 1000000))");
  const Datum reply = client.ask("(request " + session + " 1 (transact () ((tell (note 1 late) 0))))");
  EXPECT_TRUE(reply.is_form("refused")) << write(reply);
  EXPECT_EQ(board.store().size(), 0U);
}

TEST_F(ServerTest, ALongSubjectIsNotSentBackNorRemembered) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const std::string heavy(250'000, 'x');
  const std::string request = "(request " + session + " 1 (transact ((present (note 1 \"" + heavy + "\"))) ()))";
  for (int i = 0; i < 2; ++i) {
    const std::string reply = write(client.ask(request));
    EXPECT_TRUE(reply.contains("(fail ")) << reply.substr(0, 200);
    EXPECT_LT(reply.size(), 1000U);
  }
}

TEST_F(ServerTest, RepliesAreRememberedUpToABoundOfBytes) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const auto take = [&](int i) {
    return "(request " + session + " " + std::to_string(i) + " (take (note " + std::to_string(i) + " ?) 1))";
  };
  ASSERT_EQ(board.lease(60s).value(), 1U);
  constexpr std::size_t heavy = 500'000;
  const int more = static_cast<int>(BoardServer::max_reply_bytes / heavy) + 2;
  for (int i = 1; i <= more; ++i) {
    Transaction told;
    told.tell(list("note"_sym, i, std::string(heavy, 'x')));
    ASSERT_TRUE(board.transact("test", told).has_value());
    const Datum reply = client.ask(take(i));
    ASSERT_TRUE(reply.is_form("reply")) << write(reply).substr(0, 200);
    ASSERT_TRUE(reply[2].is_form("ok")) << write(reply).substr(0, 200);
    ASSERT_EQ(client.ask(take(i)), reply);
  }
  EXPECT_TRUE(client.ask(take(1)).is_form("refused"));
  EXPECT_TRUE(client.ask(take(more - 1)).is_form("reply"));
}

TEST_F(ServerTest, WhoOpensSessionsWithoutEndIsRefusedCountedAndLeavesRoomForOthers) {
  std::vector<std::unique_ptr<Client>> greedy;
  for (std::size_t i = 0; i < BoardServer::max_sessions_of_a_name; ++i) {
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

TEST_F(ServerTest, WhoAsksForLeasesWithoutEndIsRefusedCountedAndLeavesThemToOthers) {
  Client greedy = client();
  const std::string session = greedy.join("greedy");
  std::size_t number = 0;
  const auto request = [&](const std::string& body) {
    return "(request " + session + " " + std::to_string(++number) + " (" + body + "))";
  };
  for (std::size_t i = 0; i < LeaseQuota::most; ++i) {
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
TEST_F(ServerTest, AFloodDelaysNobodyByMoreThanItsShare) {
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
  pour(connections * flood);
  Revision served_between = 0;
  constexpr int asked = 10;
  for (int i = 1; i <= asked; ++i) {
    const Revision before = board.store().revision();
    const std::string number = std::to_string(i);
    const Datum reply =
        polite.ask("(request " + own + " " + number + " (transact () ((tell (note 1 " + number + ") 0))))");
    ASSERT_EQ(reply.head(), "reply");
    const auto committed = static_cast<Revision>(reply[2][1].integer());
    served_between = std::max(served_between, committed - before);
    pour(connections * 50);
  }
  EXPECT_LT(served_between, Revision{connections * flood / 2}) << "of " << sent << " that were sent";
}

TEST_F(ServerTest, AFloodBesideOthersIsRefusedCountedAndLosesNothingThatWasAcknowledged) {
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
  constexpr int flood = 800;
  for (int i = 1; i <= flood; ++i) flooder.send(tell(flooding, i, i));
  for (int i = 2; i <= 10; ++i) EXPECT_TRUE(polite.ask(tell(own, i, -i))[2].is_form("ok"));
  std::set<std::int64_t> acknowledged;
  std::set<std::int64_t> refused;
  for (int i = 0; i < flood; ++i) {
    const Datum reply = flooder.receive();
    ASSERT_TRUE(reply.is_form("reply")) << write(reply);
    const bool done = reply[2].is_form("ok");
    if (!done) {
      EXPECT_EQ(reply[2][1], "too-many"_sym) << write(reply);
    }
    (done ? acknowledged : refused).insert(reply[1].integer());
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

TEST_F(ServerTest, WhatIsRefusedIsToldWithACountAndTheNewestReason) {
  Client client = this->client();
  const std::string session = client.join("alice");
  for (const char* text : {"garbage(", "(dance ", "(request x)"}) client.ask(text);
  client.ask("(dance " + session + ")");
  client.ask("(request " + session + " 1 (dance))");
  EXPECT_EQ(refusals("alice"), std::vector<Datum>{list("bad-frame"_sym, 5)});
}

TEST_F(ServerTest, WhatIsNoMessageIsRefusedAndTheServerGoesOn) {
  Client client = this->client();
  const std::string session = client.join("alice");
  const std::string deep = std::string(500'000, '(');
  for (const std::string& text :
       {std::string("garbage"), std::string(")"), std::string("(ping)"), std::string("(ping soon)"),
        std::string("\0\1", 2), std::string("\xff\xfe"), deep, "(request " + session + " -1 " + deep,
        std::string("(hello alice 0)"), std::string("(hello \"\" 0)"), "(hello \"" + std::string(5000, 'x') + "\" 0)",
        std::string()}) {
    EXPECT_TRUE(client.ask(text).is_form("refused")) << text.substr(0, 60);
  }
  client.send_parts({"(ping " + session + ")", "more"});
  EXPECT_TRUE(client.receive().is_form("refused"));
  client.send_parts({"", "", "(ping " + session + ")"});
  EXPECT_TRUE(client.receive().is_form("refused"));
  for (const char* body : {"(dance)", "()", "5", "(transact)", "(transact 1 2)", "(transact () ((tell)))", "(ask)",
                           "(transact () ((tell (note 1 a) -1)))", "(transact ((perhaps (note 1 a))) ())", "(lease)",
                           "(lease long)", "(renew -1)", "(take (note 1 ?))", "(watch (note 1 ?))", "(declare 1)",
                           "(ask (and))", "(ask word)", "(watch 1 5)", "(take 5 0)"}) {
    static int number = 0;
    const Datum reply = client.ask("(request " + session + " " + std::to_string(++number) + " " + body + ")");
    ASSERT_TRUE(reply.is_form("reply")) << body;
    EXPECT_TRUE(reply[2].is_form("fail")) << body;
  }
  EXPECT_EQ(client.ask("(ping " + session + ")").head(), "pong");
}

TEST_F(ServerTest, AFrameBeyondTheLimitIsRefusedAndOneFarBeyondItEndsItsConnectionAlone) {
  Client other = client();
  const std::string session = other.join("other");
  Client large = client();
  large.join("large");
  EXPECT_TRUE(large.ask("\"" + std::string(2 * limits::frame_bytes, 'x') + "\"").is_form("refused"));
  Client huge = client();
  huge.join("huge");
  huge.send("\"" + std::string(8 * limits::frame_bytes, 'x') + "\"");
  EXPECT_EQ(huge.receive(100ms), Datum());
  EXPECT_EQ(other.ask("(ping " + session + ")").head(), "pong");
}

TEST_F(ServerTest, RandomDamageToMessagesHurtsNobody) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Client client = this->client();
  const std::string session = client.join("fuzz");
  const std::vector<std::string> messages = {
      "(hello \"fuzz\" " + session + ")",
      "(request " + session + " 1 (declare (relation on ((a symbol) (b symbol)) (key a) (lease 5))))",
      "(request " + session +
          " 2 (transact ((absent (note 1 ?)) (unchanged (note ? ?) 3)) ((tell (note 1 \"a\") 0 1 2) (retract (note 1 "
          "?)))))",
      "(request " + session +
          " 3 (ask (query (and (note ?n ?t) (not (note 2 ?)) (< ?n 5)) (order (down ?n)) (limit 3))))",
      "(request " + session + " 4 (watch 1 (note ?n ?t)))",
      "(request " + session + " 5 (take (note ?n ?t) 0))",
      "(ack " + session + " 1 1)"};
  for (int round = 0; round < 3000; ++round) {
    std::string text = messages[random.below(messages.size())];
    for (std::uint64_t damage = 1 + random.below(3); damage > 0; --damage) {
      const std::size_t at = random.below(text.size());
      if (random.below(2) == 0) text[at] = static_cast<char>(random.below(256));
      if (random.below(3) == 0) text.erase(at, 1 + random.below(8));
      if (random.below(3) == 0) text.insert(at, text.substr(random.below(text.size()), random.below(20)));
      if (text.empty()) text = "(";
    }
    client.send(text);
    if (round % 50 == 0) {
      while (client.receive(2ms) != Datum()) {
      }
    }
  }
  Client sane = this->client();
  const std::string own = sane.join("sane");
  EXPECT_EQ(sane.ask("(ping " + own + ")").head(), "pong");
}

TEST(ServerAddress, OnlyThisMachineIsServedUnlessInsecure) {
  RealExecutor executor;
  MemoryBoard board(executor);
  const auto symbol = [&](const std::string& address, bool insecure) {
    BoardServerOptions options;
    options.addresses = {address};
    options.insecure = insecure;
    const auto server = BoardServer::open(executor, board, options);
    return server ? std::string("ok") : server.error().symbol;
  };
  for (const char* address :
       {"tcp://0.0.0.0:*", "tcp://*:*", "tcp://192.168.7.1:5555", "tcp://127.0.0.1.evil.org:5555"}) {
    EXPECT_EQ(symbol(address, false), "not-loopback") << address;
  }
  EXPECT_EQ(symbol("tcp://0.0.0.0:*", true), "ok");
  EXPECT_EQ(symbol("tcp://127.0.0.1:*", false), "ok");
  for (const char* address :
       {"inproc://x", "tcp://127.0.0.1", "tcp://:5", "tcp://127.0.0.1:99999", "ipc://", "", "pgm://x"}) {
    EXPECT_EQ(symbol(address, true), "bad-address") << address;
  }
  EXPECT_EQ(symbol("ipc:///tmp/" + std::string(200, 'x'), false), "bad-address");
  EXPECT_EQ(symbol("ipc:///no/such/folder/board", false), "bad-address");
}

TEST(ServerAddress, AnAddressInUseIsNotTakenAway) {
  RealExecutor executor;
  MemoryBoard board(executor);
  for (const std::string& address : {ipc_address(), std::string("tcp://127.0.0.1:*")}) {
    const auto first = BoardServer::open(executor, board, {.addresses = {address}});
    ASSERT_TRUE(first.has_value());
    const auto second = BoardServer::open(executor, board, {.addresses = {(*first)->addresses().front()}});
    ASSERT_FALSE(second.has_value());
    EXPECT_EQ(second.error().symbol, "address-in-use");
  }
}

}  // namespace
}  // namespace pizarra
