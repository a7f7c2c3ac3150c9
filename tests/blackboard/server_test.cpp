#include <set>

#include "blackboard/limits.hpp"
#include "blackboard/time/random.hpp"
#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

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
  EXPECT_EQ(refusals(""), std::vector<Datum>{list("unknown-session"_sym, 1)}) << "before its hello";
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
  const int many = static_cast<int>(server::KeptReplies::most) + 2;
  for (int i = 2; i <= many + 1; ++i) client.ask("(request " + session + " " + std::to_string(i) + " (lease 1000000))");
  const Datum reply = client.ask("(request " + session + " 1 (transact () ((tell (note 1 late) 0))))");
  ASSERT_TRUE(reply.is_form("reply")) << write(reply);
  EXPECT_EQ(reply[1], to_datum(1));
  EXPECT_EQ(reply[2][1], "bad-frame"_sym) << write(reply);
  EXPECT_EQ(board.store().size(), 0U);
}

TEST_F(ServerTest, ARequestThatCannotBeReadIsAnsweredToItsNumber) {
  Client client = this->client();
  const std::string session = client.join("alice");
  for (const std::string& rest : {std::string("(ask (note 1. ?)))"), std::string(500'000, '('), std::string("(ask"),
                                  std::string("(ask (note ?n ?)) 1 2)"), std::string("\xff)"), std::string()}) {
    const Datum reply = client.ask("(request " + session + " 7 " + rest);
    ASSERT_TRUE(reply.is_form("reply")) << write(reply);
    EXPECT_EQ(reply[1], to_datum(7)) << write(reply);
    EXPECT_EQ(reply[2][1], "bad-frame"_sym) << write(reply);
  }
  EXPECT_TRUE(client.ask("(request 12345 7 (ask").is_form("refused")) << "another's";
  EXPECT_TRUE(client.ask("(request " + session + " 1.").is_form("refused"));
  EXPECT_EQ(refusals("alice"), std::vector<Datum>{read("(bad-frame 8)")});
}

TEST_F(ServerTest, AWatchWhoseClientAcknowledgesWhatWasNeverSentEnds) {
  Client client = this->client();
  const std::string session = client.join("alice");
  client.ask("(request " + session + " 1 (watch 3 (note ?n ?)))");
  ASSERT_TRUE(client.receive().is_form("change"));
  const Datum ended = client.ask("(ack " + session + " 3 99)");
  ASSERT_TRUE(ended.is_form("watch-failed")) << write(ended);
  EXPECT_EQ(ended[1], to_datum(3));
  EXPECT_EQ(refusals("alice"), std::vector<Datum>{read("(bad-frame 1)")});
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

TEST_F(ServerTest, WhatIsRefusedIsToldWithACountAndTheNewestReason) {
  Client client = this->client();
  const std::string session = client.join("alice");
  for (const char* text : {"garbage(", "(dance ", "(request x)"}) client.ask(text);
  client.ask("(dance " + session + ")");
  client.ask("(request " + session + " 1 (dance))");
  EXPECT_EQ(refusals("alice"), std::vector<Datum>{list("bad-frame"_sym, 5)});
}

TEST_F(ServerTest, WhateverARequestFailsWithIsCountedButThatAPreconditionDoesNotHold) {
  Client client = this->client();
  const std::string session = client.join("alice");
  int number = 0;
  std::map<std::string, int> failed;
  for (const char* body :
       {"(ask (nota ?))", "(ask (note ?))", "(ask (query (note ?x ?) (limit -1)))",
        "(transact () ((tell (note \"a\" b) 0)))", "(transact () ((tell (note 1 a) 99)))", "(renew 99)", "(dance 1)",
        "(transact ((present (note 9 ?))) ())", "(take (note ? ?) 5)", "(lease -1)"}) {
    const Datum reply = client.ask("(request " + session + " " + std::to_string(++number) + " " + body + ")")[2];
    ASSERT_TRUE(reply.is_form("fail")) << body;
    ++failed[std::string(reply[1].text())];
  }
  ASSERT_EQ(failed.erase("precondition-failed"), 1U);
  ASSERT_GE(failed.size(), 4U);
  std::map<std::string, int> counted;
  for (const Datum& refusal : refusals("alice")) counted[std::string(refusal[0].text())] = refusal[1].integer();
  EXPECT_EQ(counted, failed);
}

TEST_F(ServerTest, WhatWasRefusedLongestAgoMakesRoomForTheNewest) {
  server::Refusals refused(board);
  const auto refuse = [&](int n) { refused.note("client-" + std::to_string(n), {"bad-frame", "not formed", {}, {}}); };
  constexpr int most = static_cast<int>(server::Refusals::most_kinds);
  const auto counted = [](std::string_view symbol, int times) {
    return std::vector<Datum>{list(Datum::symbol(symbol), times)};
  };
  for (int n = 0; n < most; ++n) refuse(n);
  refuse(1);
  EXPECT_EQ(refusals("client-1"), counted("bad-frame", 2));
  EXPECT_EQ(refusals("others"), std::vector<Datum>());
  refuse(0);
  refuse(most);
  EXPECT_EQ(refusals("client-" + std::to_string(most)), counted("bad-frame", 1)) << "the newest has its name";
  EXPECT_EQ(refusals("client-0"), counted("bad-frame", 2)) << "it was refused again";
  EXPECT_EQ(refusals("client-2"), std::vector<Datum>());
  EXPECT_EQ(refusals("others"), counted("refused", 1));
  for (int n = 0; n < 3 * most; ++n) refuse(1000 + n);
  EXPECT_EQ(refusals("client-" + std::to_string(999 + 3 * most)), counted("bad-frame", 1));
  EXPECT_EQ(refusals("client-0"), std::vector<Datum>());
  EXPECT_EQ(refusals("others"), counted("refused", most + 3 + 2 * most));
  EXPECT_EQ(board.ask(query("(board-refusal ? ? ? ?)"))->answers.size(), server::Refusals::most_kinds + 1);
}

TEST_F(ServerTest, WhatItRefusedIsItsOwnToTell) {
  Client client = this->client();
  const std::string session = client.join("alice");
  client.ask("garbage(");
  ASSERT_EQ(refusals("alice").size(), 1U);
  int number = 0;
  for (const char* body : {"(transact () ((tell (board-refusal \"bob\" too-large 9 \"forged\") 0)))",
                           "(transact () ((retract (board-refusal ? ? ? ?))))", "(take (board-refusal ? ? ? ?) 0)",
                           "(declare (relation board-refusal ((n integer))))"}) {
    const Datum reply = client.ask("(request " + session + " " + std::to_string(++number) + " " + body + ")")[2];
    ASSERT_TRUE(reply.is_form("fail")) << body;
    EXPECT_EQ(reply[1], "not-permitted"_sym) << write(reply);
  }
  EXPECT_EQ(refusals("alice"), (std::vector<Datum>{read("(bad-frame 1)"), read("(not-permitted 4)")}));
  EXPECT_TRUE(refusals("bob").empty());
  const std::string required = "(transact ((present (board-refusal \"alice\" ? ? ?))) ())";
  EXPECT_TRUE(client.ask("(request " + session + " 9 " + required + ")")[2].is_form("ok")) << "anybody may read it";
}

TEST_F(ServerTest, AClientWhoseProtocolIsMoreThanOneApartIsToldWhichOfThemIsOld) {
  static_assert(wire::protocol == 2, "a hello without a protocol is of the first, which is not a neighbour any more");
  const auto hello = [&](const std::string& protocol) { return client().ask("(hello \"alice\" 0 " + protocol + ")"); };
  for (const char* protocol : {"", "1", "2", "3"}) EXPECT_TRUE(hello(protocol).is_form("welcome")) << protocol;
  for (const char* protocol : {"0", "4", "9223372036854775807"}) {
    const Datum refused = hello(protocol);
    ASSERT_TRUE(refused.is_form("refused")) << protocol << ": " << write(refused);
    EXPECT_EQ(refused[1][1], "other-protocol"_sym) << write(refused);
    const std::string older = protocol == std::string("0") ? "client" : "board";
    EXPECT_EQ(refused[1][2].text(), "the client speaks protocol " + std::string(protocol) +
                                        " and the board protocol 2, more than one apart: bring the " + older +
                                        " up to date");
  }
  for (const char* protocol : {"new", "-1", "(2)", "\"2\""}) {
    const Datum refused = hello(protocol);
    ASSERT_TRUE(refused.is_form("refused")) << protocol << ": " << write(refused);
    EXPECT_EQ(refused[1][1], "bad-frame"_sym) << write(refused);
  }
}

TEST_F(ServerTest, ATellersNameHasABound) {
  const std::string longest(limits::name_bytes, 'x');
  const Datum refused = client().ask("(hello \"" + longest + "x\" 0)");
  ASSERT_TRUE(refused.is_form("refused")) << write(refused);
  EXPECT_EQ(refused[1][1], "too-large"_sym) << write(refused);
  EXPECT_TRUE(client().ask("(hello \"" + longest + "\" 0)").is_form("welcome"));
}

// Agents speak of their clients as symbols.
TEST_F(ServerTest, ATellersNameIsThatOfASymbolAndOfNoVariable) {
  for (const char* name : {"my script", "", "9th", "-1", "?x", "a(b", "a\\nb", "a\\\"b", "caf\u00e9", "."}) {
    const Datum refused = client().ask("(hello \"" + std::string(name) + "\" 0)");
    ASSERT_TRUE(refused.is_form("refused")) << name << ": " << write(refused);
    EXPECT_EQ(refused[1][1], "bad-name"_sym) << write(refused);
  }
  for (const char* name : {"script", "desk/script", "a?", "-", "prompt-17"}) {
    EXPECT_TRUE(client().ask("(hello \"" + std::string(name) + "\" 0)").is_form("welcome")) << name;
  }
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
  memory::MemoryBoard board(executor);
  const auto symbol = [&](const std::string& address, bool insecure) {
    server::BoardServerOptions options;
    options.addresses = {address};
    options.insecure = insecure;
    const auto server = server::BoardServer::open(executor, board, options);
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

TEST(ServerAddress, ASocketWithoutAFileThatGuardsItIsNotServed) {
  RealExecutor executor;
  memory::MemoryBoard board(executor);
  const auto server = server::BoardServer::open(executor, board, {.addresses = {"ipc://@pizarra-test"}});
  ASSERT_FALSE(server.has_value());
  EXPECT_EQ(server.error().symbol, "bad-address");
}

TEST_F(ServerTest, WhatAClientSaysOfItsClockIsBelievedWithinReason) {
  ASSERT_TRUE(board.declare("test", {relation("(relation other ((n integer)) (key n))")}).has_value());
  Client alice = client();
  const std::string session = alice.join("alice");
  const auto count = [&](const char* relation, const char* of) {
    const Query asked = query(std::string("(journey-stats ") + relation + " (?told ? ? ?) (?delivered ? ? ?))");
    const Result<Answers> answers = board.ask(asked);
    return answers->answers.empty() ? 0 : answers->answers.front().bindings.find(of)->integer();
  };
  int number = 0;
  const auto ask = [&](const std::string& body, const std::string& sent = "") {
    return alice.ask("(request " + session + " " + std::to_string(++number) + " " + body + sent + ")");
  };
  for (const char* sent : {" -9223372036854775808", " 9223372036854775807", " 0", " -1"}) {
    const std::string text = std::to_string(number);
    EXPECT_TRUE(ask("(transact () ((tell (note 1 " + text + ") 0) (tell (other 1) 0)))", sent)[2].is_form("ok"));
  }
  EXPECT_EQ(count("note", "?told"), 0);
  ask("(transact () ((tell (note 1 now) 0)))", " " + std::to_string(executor.now().time_since_epoch().count()));
  EXPECT_EQ(count("note", "?told"), 1);
  ask("(watch 1 (and (note ?n ?) (= ?n ?n)))");
  EXPECT_TRUE(alice.receive().is_form("change"));
  for (int n = 2; n <= 4; ++n) {
    ASSERT_TRUE(board.transact("test", Transaction().tell(list("note"_sym, n, "x"_sym))).has_value());
    EXPECT_TRUE(alice.receive().is_form("change"));
  }
  const auto acknowledge = [&](const std::string& said) {
    alice.send("(ack " + session + " 1 " + said + ")");
    EXPECT_TRUE(alice.ask("(ping " + session + ")").is_form("pong"));
  };
  acknowledge("1 other 5000");
  acknowledge("2 note 113000000");
  acknowledge("3 note -9223372036854775808");
  EXPECT_EQ(count("other", "?delivered"), 0);
  EXPECT_EQ(count("note", "?delivered"), 0);
  for (int times = 0; times < 3; ++times) acknowledge("4 note 5000");
  EXPECT_EQ(count("note", "?delivered"), 1) << "of each change once";
}

TEST(ServerAddress, LocalhostIsThisMachine) {
  RealExecutor executor;
  memory::MemoryBoard board(executor);
  const auto server = server::BoardServer::open(executor, board, {.addresses = {"tcp://localhost:*"}});
  ASSERT_TRUE(server.has_value()) << describe(server.error());
  EXPECT_TRUE((*server)->addresses().front().starts_with("tcp://127.0.0.1:"));
}

TEST(ServerAddress, AnAddressInUseIsNotTakenAway) {
  RealExecutor executor;
  memory::MemoryBoard board(executor);
  for (const std::string& address : {ipc_address(), std::string("tcp://127.0.0.1:*")}) {
    const auto first = server::BoardServer::open(executor, board, {.addresses = {address}});
    ASSERT_TRUE(first.has_value());
    const auto second = server::BoardServer::open(executor, board, {.addresses = {(*first)->addresses().front()}});
    ASSERT_FALSE(second.has_value());
    EXPECT_EQ(second.error().symbol, "address-in-use");
  }
}

}  // namespace
}  // namespace pizarra
