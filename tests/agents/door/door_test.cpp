// Devices at the text door, their words and the answers: facts, questions, watches, leases; and whom it turns away.

#include <sys/stat.h>

#include "blackboard/time/random.hpp"
#include "tests/agents/door/door_fixture.hpp"

namespace pizarra::door {
namespace {

testing::AssertionResult begins(const std::string& text, std::string_view part) {
  if (text.starts_with(part)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << text << " does not begin with " << part;
}

TEST_F(DoorTest, ADeviceTellsAsksAndRetractsUnderItsOwnName) {
  Device barrier = device("barrier");
  EXPECT_TRUE(begins(barrier.said("(tell (blocked barrier-1) (blocked barrier-2))"), "(ok "));
  EXPECT_EQ(barrier.said("(ask (blocked ?b))"), "(ok (blocked barrier-1) (blocked barrier-2))");
  EXPECT_EQ(barrier.said("(ask (and (blocked ?b) (blocked barrier-1)))"),
            "(ok ((blocked barrier-1) (blocked barrier-1)) ((blocked barrier-2) (blocked barrier-1)))");
  EXPECT_EQ(run(executor_, here_->facts(list("blocked"_sym, "barrier-1"_sym)))->front().teller, "barrier");
  EXPECT_TRUE(begins(barrier.said("(retract (blocked barrier-1))"), "(ok "));
  EXPECT_EQ(barrier.said("(ask (blocked ?b))"), "(ok (blocked barrier-2))");
  EXPECT_EQ(barrier.said("(declare (relation blocked ((barrier symbol))))"), "(ok)");
}

TEST_F(DoorTest, BytesMayComeOneAtATimeAndManyLinesAtOnce) {
  Device barrier = device();
  for (const char c : hello("barrier") + "\r\n\r\n(tell (blocked one))\r\n") barrier.send({&c, 1});
  EXPECT_EQ(barrier.hear(), "(welcome barrier)");
  EXPECT_TRUE(begins(barrier.hear(), "(ok "));
  std::string lines;
  for (int i = 0; i < 500; ++i) lines += "(ask (blocked ?b))\n";
  barrier.send(lines);
  for (int i = 0; i < 500; ++i) ASSERT_EQ(barrier.hear(), "(ok (blocked one))");
}

TEST_F(DoorTest, AWatchSaysWhatHoldsAndEveryChangeWhole) {
  tell("(turned one 10)");
  Device barrier = device("barrier");
  EXPECT_EQ(barrier.said("(watch 3 (turned ?t ?d))"), "(ok)");
  EXPECT_EQ(barrier.hear(), "(anew 3)");
  EXPECT_EQ(barrier.hear(), "(came 3 (turned one 10))");
  EXPECT_TRUE(begins(barrier.hear(), "(now 3 "));
  tell("(turned one 20)");
  EXPECT_EQ(barrier.hear(), "(went 3 (turned one 10))");
  EXPECT_EQ(barrier.hear(), "(came 3 (turned one 20))");
  EXPECT_TRUE(begins(barrier.hear(), "(now 3 "));
  EXPECT_TRUE(begins(barrier.said("(watch 3 (blocked ?b))"), "(fail already-there "));
  EXPECT_EQ(barrier.said("(unwatch 3)"), "(ok)");
  tell("(turned one 30)");
  EXPECT_EQ(barrier.said("(ask (turned ?t ?d))"), "(ok (turned one 30))");
  EXPECT_TRUE(begins(barrier.said("(unwatch 3)"), "(fail unknown-watch "));
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(barrier.said("(watch " + std::to_string(i) + " (blocked ?b))"), "(ok)");
    EXPECT_EQ(barrier.hear(), "(anew " + std::to_string(i) + ")");
    EXPECT_TRUE(begins(barrier.hear(), "(now "));
  }
  EXPECT_TRUE(begins(barrier.said("(watch 8 (blocked ?b))"), "(fail too-many "));
}

TEST_F(DoorTest, WhatIsToldUnderALeaseGoesWhenItIsNotRenewedAndStaysForWhoComesBackInTime) {
  Device barrier = device("barrier");
  EXPECT_TRUE(begins(barrier.said("(tell-leased (blocked one))"), "(fail unknown-lease "));
  EXPECT_TRUE(begins(barrier.said("(lease 0)"), "(fail wrong-shape "));
  EXPECT_TRUE(begins(barrier.said("(lease 3600001)"), "(fail wrong-shape "));
  EXPECT_EQ(barrier.said("(lease 3600000)"), "(ok new)");
  EXPECT_TRUE(begins(barrier.said("(tell-leased (blocked one))"), "(ok "));
  EXPECT_EQ(barrier.said("(lease 3600000)"), "(ok kept)");
  EXPECT_EQ(count("(blocked ?)"), 1U);
  EXPECT_EQ(barrier.said("(release)"), "(ok)");
  EXPECT_EQ(count("(blocked ?)"), 0U);
  EXPECT_EQ(barrier.said("(lease 3000)"), "(ok new)");
  EXPECT_TRUE(begins(barrier.said("(tell-leased (blocked one))"), "(ok "));
  EXPECT_TRUE(run_until(executor_, [&] { return board_.store().tables().find("blocked")->second.size() == 0; }));
  EXPECT_EQ(barrier.said("(lease 3000)"), "(ok new)");
}

TEST_F(DoorTest, ALeaseOutlivesItsConnection) {
  {
    Device barrier = device("barrier");
    EXPECT_EQ(barrier.said("(lease 3600000)"), "(ok new)");
    EXPECT_TRUE(begins(barrier.said("(tell-leased (blocked one))"), "(ok "));
  }
  EXPECT_TRUE(run_until(executor_, [&] { return door_->sessions() == 0; }));
  EXPECT_EQ(count("(blocked one)"), 1U);
}

TEST_F(DoorTest, WhatAWebPageMayPostIsNotDone) {
  for (const std::string first : {"POST / HTTP/1.1", "GET /(hello) HTTP/1.1", "OPTIONS * HTTP/1.0"}) {
    Device browser = device();
    browser.send(first + "\r\nHost: 127.0.0.1\r\nContent-Type: text/plain\r\n\r\n" + hello("barrier") +
                 "\n(tell (blocked one))\n" + std::string(100'000, 'x'));
    EXPECT_TRUE(begins(browser.hear(), "(closed ")) << first;
    EXPECT_EQ(browser.hear(), "end");
  }
  EXPECT_EQ(count("(blocked ?)"), 0U);
}

TEST_F(DoorTest, TheFirstLineThatIsNotUnderstoodClosesItAndChangesNothing) {
  for (const std::string line : {"(tell (blocked one)",
                                 "(tell (blocked one)))",
                                 "(tell)",
                                 "(tell blocked)",
                                 "(tell (blocked one) 2)",
                                 "tell",
                                 "()",
                                 "((tell))",
                                 "(ask)",
                                 "(ask (a ?) (b ?))",
                                 "(watch (blocked ?))",
                                 "(watch 1.5 (blocked ?))",
                                 "(unwatch one)",
                                 "(lease ten)",
                                 "(release now)",
                                 "(shout (blocked one))",
                                 "(take (blocked one))",
                                 "(tell (blocked 'one))",
                                 "(tell (blocked one)) (tell (blocked two))",
                                 "(tell (blocked \"\\q\"))",
                                 "(((((((((((((((((((((tell)))))))))))))))))))))",
                                 "\x01\x02",
                                 "(tell (blocked \xff))",
                                 "(hello barrier)",
                                 "(hello \"barrier\" \"x\")"}) {
    Device barrier = device("barrier");
    barrier.send(line + "\n(tell (blocked behind))\n");
    const std::string why = barrier.hear();
    EXPECT_TRUE(begins(why, "(closed ")) << line;
    EXPECT_TRUE(read_one(why).has_value()) << why;
    EXPECT_EQ(barrier.hear(), "end") << line;
  }
  EXPECT_EQ(count("(blocked ?)"), 0U);
}

TEST_F(DoorTest, WhateverADamagedLineSaysItHasOneAnswerOfOneLine) {
  const std::string lines[] = {"(tell (blocked one))",
                               "(ask (and (blocked ?b) (turned ?b ?d)))",
                               "(watch 1 (blocked ?b))",
                               "(lease 60000)",
                               "(tell-leased (blocked two))",
                               "(retract (blocked ?))",
                               "(release)",
                               "(declare (relation blocked ((barrier symbol))))",
                               "(unwatch 1)",
                               hello("barrier")};
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    Device barrier = device("barrier");
    std::string line = lines[random.below(std::size(lines))];
    for (int n = 0; n < 2; ++n) line[random.below(line.size())] = static_cast<char>(' ' + random.below(224));
    const std::string answer = barrier.said(line);
    const bool known = answer.starts_with("(ok") || answer.starts_with("(fail ") || answer.starts_with("(closed ") ||
                       answer == "(welcome barrier)";
    EXPECT_TRUE(known) << line << " is answered by " << answer;
    EXPECT_TRUE(read_one(answer).has_value()) << answer;
  }
}

TEST_F(DoorTest, ALineThatIsTooLongOrNeverEndsIsNotDone) {
  Device barrier = device("barrier");
  barrier.send("(tell (blocked " + std::string(5000, 'x') + "))\n");
  EXPECT_TRUE(begins(barrier.hear(), "(closed too-long "));
  EXPECT_EQ(barrier.hear(), "end");
  Device endless = device("barrier");
  endless.send(std::string(50'000, 'x'));
  EXPECT_TRUE(begins(endless.hear(), "(closed too-long "));
  Device broken = device("barrier");
  broken.send("(tell (blocked one))");
  broken.close();
  EXPECT_TRUE(run_until(executor_, [&] { return door_->sessions() == 0; }));
  EXPECT_EQ(count("(blocked ?)"), 0U);
}

TEST_F(DoorTest, NobodyComesWithoutAKeyAndItsToken) {
  make_key("other", {{"*"}, {}, {"*"}, {}});
  for (const std::string& line :
       {std::string("(hello barrier \"\")"), "(hello barrier \"" + tokens_.at("other") + "\")",
        "(hello barrier \"" + tokens_.at("barrier") + "x\")", "(hello nobody \"" + tokens_.at("other") + "\")",
        "(hello ../keys/other \"" + tokens_.at("other") + "\")"}) {
    Device stranger = device();
    EXPECT_EQ(stranger.said(line), "(closed not-permitted \"nobody comes with this name and this token\")") << line;
    EXPECT_EQ(stranger.hear(), "end");
  }
  Device silent = device();
  EXPECT_TRUE(begins(silent.said("(tell (blocked one))"), "(closed malformed "));
  EXPECT_TRUE(news_.empty());
  ::chmod((keys_ + "/other.secret").c_str(), 0644);
  Device exposed = device();
  EXPECT_TRUE(begins(exposed.said(hello("other")), "(closed not-permitted "));
  ASSERT_EQ(news_.size(), 1U);
  EXPECT_TRUE(begins(news_.front(), "other is not let in: others may read this secret"));
}

TEST_F(DoorTest, ADeviceMayDoWhatItsKeySays) {
  tell("(turned one 10)");
  tell("(secret word)");
  Device barrier = device("barrier");
  for (const char* line :
       {"(tell (turned one 20))", "(tell (blocked one) (turned one 20))", "(tell-leased (secret other))",
        "(retract (turned ? ?))", "(retract (blocked ?) (secret ?))", "(ask (secret ?s))",
        "(ask (and (blocked ?b) (secret ?s)))", "(ask (and (blocked ?b) (not (secret ?b))))", "(watch 1 (secret ?s))",
        "(ask (undeclared ?))", "(declare (relation other ((n integer))))",
        "(declare (relation blocked ((barrier symbol))) (relation other ((n integer))))"}) {
    EXPECT_EQ(barrier.said("(lease 60000)").substr(0, 3), "(ok");
    EXPECT_TRUE(begins(barrier.said(line), "(fail not-permitted ")) << line;
  }
  EXPECT_EQ(count("(blocked ?)"), 0U);
  EXPECT_EQ(count("(turned one 10)"), 1U);
  EXPECT_EQ(count("(secret word)"), 1U);
}

TEST_F(DoorTest, WhatTheBoardRefusesIsAnsweredAndTheSessionGoesOn) {
  make_key("anybody", {{"*"}, {}, {"*"}, {}});
  Device anybody = device("anybody");
  EXPECT_TRUE(begins(anybody.said("(tell (unknown 1))"), "(fail undeclared-relation "));
  EXPECT_TRUE(begins(anybody.said("(tell (blocked 1))"), "(fail wrong-shape "));
  EXPECT_TRUE(begins(anybody.said("(ask (query))"), "(fail bad-query "));
  EXPECT_TRUE(begins(anybody.said("(watch 1 (and))"), "(fail bad-query "));
  EXPECT_TRUE(begins(anybody.said("(declare (relation))"), "(fail "));
  for (int i = 0; i < 400; ++i) tell("(blocked barrier-" + std::to_string(i) + ")");
  EXPECT_TRUE(begins(anybody.said("(ask (blocked ?b))"), "(fail too-large "));
  EXPECT_EQ(anybody.said("(ask (query (blocked ?b) (limit 1)))"), "(ok (blocked barrier-0))");
}

TEST_F(DoorTest, WhoSaysNoHelloIsLetGo) {
  Device silent = device();
  EXPECT_EQ(silent.hear(), "(closed timeout \"nothing was said in time\")");
  EXPECT_EQ(silent.hear(), "end");
}

TEST_F(DoorTest, ADeviceThatComesAgainTakesThePlaceOfItsEarlierSession) {
  Device before = device("barrier");
  EXPECT_EQ(before.said("(watch 1 (blocked ?b))"), "(ok)");
  Device after = device("barrier");
  std::string last;
  for (std::string line = before.hear(); line != "end"; line = before.hear()) last = line;
  EXPECT_TRUE(begins(last, "(closed replaced "));
  EXPECT_TRUE(begins(after.said("(tell (blocked one))"), "(ok "));
  EXPECT_EQ(door_->sessions(), 1U);
  EXPECT_EQ(after.said(hello("barrier")), "(welcome barrier)");
  EXPECT_TRUE(begins(after.said("(release)"), "(fail unknown-lease "));
}

TEST_F(DoorTest, ThereAreOnlySoManyConnections) {
  std::vector<Device> devices;
  for (std::size_t i = 0; i < Door::most_connections; ++i) {
    const std::string name = "device-" + std::to_string(i);
    make_key(name, {{"blocked"}, {}, {}, {}});
    devices.push_back(device(name));
  }
  Device surplus = device();
  EXPECT_TRUE(begins(surplus.said(hello("barrier")), "(closed too-many "));
  EXPECT_EQ(surplus.hear(), "end");
  devices.pop_back();
  EXPECT_TRUE(run_until(executor_, [&] { return door_->sessions() == Door::most_connections - 1; }));
  EXPECT_TRUE(begins(devices.front().said("(tell (blocked one))"), "(ok "));
}

TEST_F(DoorTest, WhoDoesNotReadHoldsUpNobodyAndLearnsWhatHoldsInTheEnd) {
  Device slow(executor_, connect_to(door_->port(), 4096));
  EXPECT_EQ(slow.said(hello("barrier")), "(welcome barrier)");
  EXPECT_EQ(slow.said("(watch 1 (turned ?t ?d))"), "(ok)");
  Device table = device("table");
  constexpr int most = 20'000;
  for (int i = 1; i <= most; ++i) tell("(turned one " + std::to_string(i) + ")");
  EXPECT_TRUE(begins(table.said("(tell (turned two 1))"), "(ok "));
  std::string holds;
  int said = 0;
  for (std::string line = slow.hear(); !line.starts_with("(came 1 (turned two"); line = slow.hear()) {
    ASSERT_NE(line, "end");
    ++said;
    if (line.starts_with("(came")) holds = line;
  }
  EXPECT_EQ(holds, "(came 1 (turned one " + std::to_string(most) + "))");
  // Most of what came between was never said.
  EXPECT_LT(said, most);
}

TEST(Places, AreOfThisMachineAlone) {
  EXPECT_EQ(tcp_place_from("127.0.0.1:7801")->port, 7801);
  EXPECT_EQ(tcp_place_from("localhost:0")->address, "127.0.0.1");
  for (const char* other : {"0.0.0.0:7801", "192.168.0.2:7801", "10.0.0.1:1", "128.0.0.1:1", "255.255.255.255:1"}) {
    EXPECT_EQ(tcp_place_from(other).error().symbol, "not-loopback") << other;
  }
  for (const char* none : {"", ":", "127.0.0.1", "127.0.0.1:", "127.0.0.1:x", "127.0.0.1:70000", "127.1:1", "*:1",
                           "bench:7801", "127.0.0.1:-1", "[::1]:7801"}) {
    EXPECT_EQ(tcp_place_from(none).error().symbol, "bad-address") << none;
  }
  EXPECT_EQ(serial_place_from("/dev/ttyUSB0:9600")->baud, 9600);
  EXPECT_EQ(serial_place_from("/dev/serial/by-path/pci-0000:00:14.0")->path, "/dev/serial/by-path/pci-0000:00:14.0");
  EXPECT_EQ(serial_place_from("ttyUSB0").error().symbol, "bad-address");
}

}  // namespace
}  // namespace pizarra::door
