// A board that asks for keys: who is let in, as whom, and what each may do.

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/server/kept_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

class SecurityTest : public testing::Test, public Wall {
 protected:
  SecurityTest() {
    std::filesystem::remove_all(folder_);
    EXPECT_TRUE(wire::make_keys(folder_, "board", {}).has_value());
    EXPECT_TRUE(wire::make_keys(folder_, "boss", {{"*"}, {"*"}, {"*"}, {}}).has_value());
    EXPECT_TRUE(wire::make_keys(folder_, "robot", {{"arm", "agent"}, {"job"}, {"arm*", "job"}, {}}).has_value());
  }
  ~SecurityTest() override { std::filesystem::remove_all(folder_); }

  void serve(Duration session_length = 800ms) {
    server::BoardServerOptions options;
    options.addresses = {"tcp://127.0.0.1:*", ipc_};
    options.keys = folder_;
    options.session_length = session_length;
    server_ = server::BoardServer::open(executor_, board_, options).value();
    const std::unique_ptr<Board> boss = view("boss");
    EXPECT_EQ(
        symbol_of(run(boss->declare(
            {relation("(relation arm ((state symbol)) (key))"), relation("(relation arm-pose ((x number)) (key))"),
             relation("(relation agent ((name symbol)) (key name))"), relation("(relation job ((n integer)) (key n))"),
             relation("(relation goal ((n integer)) (key n))")}))),
        "ok");
  }
  std::string tcp() const { return server_->addresses().front(); }
  std::string secret_of(const std::string& name) const { return folder_ + "/" + name + ".secret"; }

  Executor& executor() override { return executor_; }
  // Comes with the key of its name.
  std::unique_ptr<Board> view(const std::string& name) override { return view(name, name); }
  std::unique_ptr<Board> view(const std::string& key, const std::string& teller, Duration timeout = 5s) {
    return client::RemoteBoard::connect(executor_, tcp(), teller, timeout,
                                        wire::read_client_keys(secret_of(key)).value())
        .value();
  }
  std::string tell(Board& board, const std::string& fact, LeaseId lease = 0) {
    Transaction transaction;
    transaction.tell(read(fact), {}, lease);
    return symbol_of(run(board.transact(transaction)));
  }
  std::string retract(Board& board, const std::string& pattern) { return symbol_of(run(board.retract(read(pattern)))); }
  std::string ask(Board& board, const std::string& text) { return symbol_of(run(board.ask(query(text)))); }

  // The newest refusals of a client, once they are told.
  std::vector<Fact> refusals(const std::string& client) {
    pass(2 * server::Refusals::pause);
    const auto answers = board_.ask(query_for(list("board-refusal"_sym, client, "?"_sym, "?"_sym, "?"_sym)));
    std::vector<Fact> facts;
    for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front());
    return facts;
  }

  const std::string ipc_ = ipc_address();
  const std::string folder_ = ipc_.substr(6) + ".keys";
  RealExecutor executor_;
  memory::MemoryBoard board_{executor_};
  std::unique_ptr<server::BoardServer> server_;
};

TEST_F(SecurityTest, AClientWithAnAuthorisedKeyTellsUnderItsName) {
  serve();
  const auto robot = view("robot");
  ASSERT_EQ(tell(*robot, "(arm idle)"), "ok");
  const auto part = view("robot", "gripper");
  ASSERT_EQ(tell(*part, "(agent gripper)"), "ok");
  const auto boss = view("boss");
  EXPECT_EQ(run(boss->facts(read("(arm ?)")))->front().teller, "robot");
  EXPECT_EQ(run(boss->facts(read("(agent ?)")))->front().teller, "robot/gripper");
}

TEST_F(SecurityTest, SaysToAClientWhatItsOwnKeyPermitsAndCountsNoRefusal) {
  serve();
  const auto permissions_of = [&](Board& board) {
    std::vector<std::string> said;
    const Result<std::vector<Fact>> permissions = run(board.facts(read("(own-permission ?verb ?relation)")));
    EXPECT_TRUE(permissions) << permissions.error().sentence;
    for (const Fact& fact : *permissions) said.push_back(write(fact.datum));
    std::ranges::sort(said);
    return fmt::format("{}", fmt::join(said, " "));
  };
  const auto robot = view("robot");
  EXPECT_EQ(permissions_of(*robot),
            "(own-permission read arm*) (own-permission read job) (own-permission take job) "
            "(own-permission tell agent) (own-permission tell arm)");
  EXPECT_EQ(permissions_of(*view("boss")), "(own-permission read *) (own-permission take *) (own-permission tell *)");
  EXPECT_EQ(permissions_of(*board_.view("here")),
            "(own-permission override *) (own-permission read *) (own-permission take *) (own-permission tell *)");
  EXPECT_EQ(refusals("robot").size(), 0U);
  EXPECT_EQ(ask(*robot, "(and (own-permission tell ?x) (job ?n))"), "bad-query") << "it is asked for alone";
  EXPECT_EQ(tell(*robot, "(own-permission tell goal)"), "not-permitted");
}

TEST_F(SecurityTest, OfAFactsReasonsAClientHearsThoseThatItMayRead) {
  serve();
  const auto boss = view("boss");
  ASSERT_EQ(tell(*boss, "(goal 1)"), "ok");
  const auto id_of = [&](const char* pattern) {
    const Result<std::vector<Fact>> facts = run(boss->facts(read(pattern)));
    return facts->front().id;
  };
  const FactId goal = id_of("(goal ?n)");
  ASSERT_TRUE(run(boss->tell(read("(job 1)"), std::vector<FactId>(1, goal))).has_value());
  const Query why = query(fmt::format("(provenance {} ?id ?fact ?teller ?when ?because)", id_of("(job ?n)")));
  EXPECT_EQ(run(boss->ask(why))->answers.size(), 2U);
  const Result<Answers> heard = run(view("robot")->ask(why));
  ASSERT_TRUE(heard) << heard.error().sentence;
  ASSERT_EQ(heard->answers.size(), 1U);
  EXPECT_EQ(*heard->answers.front().bindings.find("?fact"), read("(job 1)"));
}

// A board that lives again knows its sessions by what their clients were answered.
TEST_F(SecurityTest, ARestoredSessionIsItsKeysAlone) {
  server::BoardServerOptions options;
  options.addresses = {"tcp://127.0.0.1:*", ipc_};
  options.keys = folder_;
  const std::string key = wire::read_public_key(folder_ + "/robot.key")->key;
  options.remembered = {{77, "robot", 1, read("(ok 5)"), key}, {78, "hand", 1, read("(ok 6)"), ""}};
  server_ = server::BoardServer::open(executor_, board_, options).value();
  // The session that is given to who says so over the address.
  const auto welcomed = [&](const std::string& address, const wire::ClientKeys* keys, const std::string& hello) {
    std::optional<std::uint64_t> session;
    wire::WireSocket client(executor_, wire::WireSocket::Kind::dealer,
                            [&](const std::string&, std::optional<std::string_view> frame) {
                              if (frame && frame->starts_with("(welcome"))
                                session = wire::count_at(read(std::string(*frame)), 1);
                            });
    EXPECT_TRUE(client.connect(address, keys).has_value());
    for (int tries = 0; tries < 200 && !session; ++tries) {
      client.send({}, hello);
      pass(10ms);
    }
    return session.value_or(0);
  };
  const wire::ClientKeys keys = wire::read_client_keys(secret_of("robot")).value();
  EXPECT_NE(welcomed(ipc_, nullptr, "(hello \"robot\" 77)"), 77U) << "came with no key";
  EXPECT_EQ(welcomed(ipc_, nullptr, "(hello \"hand\" 78)"), 78U);
  EXPECT_EQ(welcomed(tcp(), &keys, "(hello \"robot\" 77)"), 77U);
  ASSERT_TRUE(wire::make_keys(folder_ + ".new", "robot", {{"*"}, {"*"}, {"*"}, {}}).has_value());
  std::filesystem::rename(folder_ + ".new/robot.key", folder_ + "/robot.key");
  wire::ClientKeys anew = keys;
  anew.own = wire::read_secret_key(folder_ + ".new/robot.secret").value();
  std::filesystem::remove_all(folder_ + ".new");
  EXPECT_NE(welcomed(tcp(), &anew, "(hello \"robot\" 77)"), 77U) << "came with another key of that name";
}

TEST_F(SecurityTest, ManyShortClientsOfAKeyBeforeARestartTakeNoRoomFromTheNextOne) {
  const std::string journal = folder_ + ".journal";
  journal::remove_journal(journal);
  // A life of the board, in which so many clients come one after another.
  const auto live = [&](std::size_t clients) {
    server::KeptBoard kept(executor_);
    ASSERT_TRUE(kept.begin(journal::JournalFile::open(journal, {}).value()).has_value());
    ASSERT_TRUE(kept.board().declare("test", {relation("(relation goal ((n integer)) (key n) (durable))")}));
    server::BoardServerOptions options;
    options.addresses = {"tcp://127.0.0.1:*"};
    options.keys = folder_;
    options.journal = kept.journal();
    options.remembered = kept.take_remembered();
    server_ = server::BoardServer::open(executor_, kept.board(), options).value();
    for (std::size_t i = 0; i < clients; ++i) {
      EXPECT_EQ(tell(*view("boss"), write(list("goal"_sym, i))), "ok") << "client " << i;
    }
    server_.reset();
  };
  live(server::Sessions::most_of_a_key + 6);
  live(1);
  journal::remove_journal(journal);
}

TEST_F(SecurityTest, AStrangersKeyIsRefusedWithAReasonAndTold) {
  serve();
  const std::string elsewhere = folder_ + ".other";
  const wire::KeyPair stranger = wire::make_keys(elsewhere, "stranger", {{"*"}, {"*"}, {"*"}, {}}).value();
  const wire::ClientKeys keys{stranger, wire::read_public_key(folder_ + "/board.key")->key};
  std::filesystem::remove_all(elsewhere);
  const auto board = client::RemoteBoard::connect(executor_, tcp(), "stranger", 5s, keys).value();
  const Time before = executor_.now();
  const Result<Answers> refused = run(board->ask(query("(arm ?x)")));
  ASSERT_EQ(symbol_of(refused), "not-permitted");
  EXPECT_NE(refused.error().sentence.find("does not accept this key"), std::string::npos) << refused.error().sentence;
  EXPECT_LT(executor_.now() - before, 3s) << "at once, not when its patience ends";
  ASSERT_EQ(refusals(stranger.public_key).size(), 1U);
  EXPECT_TRUE(refusals(stranger.public_key).front().datum[2].is_symbol("not-permitted"));
}

TEST_F(SecurityTest, AClientWithoutAKeyIsToldToBringOne) {
  serve();
  const auto board = client::RemoteBoard::connect(executor_, tcp(), "robot").value();
  const Result<Answers> refused = run(board->ask(query("(arm ?x)")));
  ASSERT_EQ(symbol_of(refused), "not-permitted");
  EXPECT_NE(refused.error().sentence.find("--key"), std::string::npos) << refused.error().sentence;
}

// A board that asks for keys may close the line before its reason has been read.
TEST_F(SecurityTest, AClientWithoutAKeyIsToldToBringOneAlsoWhereTheBoardBreaksOffWithoutAReason) {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{.sin_family = AF_INET, .sin_port = 0, .sin_addr = {htonl(INADDR_LOOPBACK)}, .sin_zero = {}};
  socklen_t length = sizeof address;
  auto* const place = reinterpret_cast<sockaddr*>(&address);
  ASSERT_EQ(bind(listener, place, length), 0);
  ASSERT_EQ(listen(listener, 8), 0);
  ASSERT_EQ(getsockname(listener, place, &length), 0);
  executor_.watch_readable(listener, [&] { close(accept(listener, nullptr, nullptr)); });
  const std::string breaks_off = "tcp://127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  const auto board = client::RemoteBoard::connect(executor_, breaks_off, "robot").value();
  const Result<Answers> refused = run(board->ask(query("(arm ?x)")));
  executor_.unwatch_readable(listener);
  close(listener);
  ASSERT_EQ(symbol_of(refused), "not-permitted");
  EXPECT_NE(refused.error().sentence.find("--key"), std::string::npos) << refused.error().sentence;
}

// The board may close the line before a client has read why, and each client tries again more and more seldom. So
// another one asks after two seconds.
TEST_F(SecurityTest, AKeyForABoardThatAsksForNoneIsSaidToBeInTheWay) {
  const auto open = server::BoardServer::open(executor_, board_, {.addresses = {"tcp://127.0.0.1:*"}}).value();
  const wire::ClientKeys keys = wire::read_client_keys(secret_of("robot")).value();
  std::string symbol;
  for (int clients = 0; clients < 10 && symbol != "not-permitted"; ++clients) {
    const auto board = client::RemoteBoard::connect(executor_, open->addresses().front(), "robot", 2s, keys).value();
    symbol = symbol_of(run(board->ask(query("(arm ?x)"))));
  }
  EXPECT_EQ(symbol, "not-permitted");
}

TEST_F(SecurityTest, AnotherBoardsKeyLetsNobodySpeakToIt) {
  serve();
  wire::ClientKeys keys = wire::read_client_keys(secret_of("robot")).value();
  keys.board_key = keys.own.public_key;
  const auto board = client::RemoteBoard::connect(executor_, tcp(), "robot", 2s, keys).value();
  const Result<Answers> refused = run(board->ask(query("(arm ?x)")));
  ASSERT_EQ(symbol_of(refused), "unreachable");
  EXPECT_TRUE(refused.error().sentence.contains("its key is another than board.key says")) << refused.error().sentence;
}

TEST_F(SecurityTest, OnTheFileOfThisMachineNoKeyIsAskedFor) {
  serve();
  const auto local = client::RemoteBoard::connect(executor_, ipc_, "local").value();
  EXPECT_EQ(tell(*local, "(goal 1)"), "ok");
  const auto keyed =
      client::RemoteBoard::connect(executor_, ipc_, "robot", 5s, wire::read_client_keys(secret_of("robot")).value())
          .value();
  EXPECT_EQ(tell(*keyed, "(goal 2)"), "ok");
}

TEST_F(SecurityTest, WhoMayDeclareWhatBeginsWithANameLeavesTheBoardRoomForOthers) {
  serve();
  const auto robot = view("robot");
  const auto declare = [&](Board& board, int number) {
    return symbol_of(run(board.declare({relation(fmt::format("(relation arm-{} ((n integer)))", number))})));
  };
  std::string said = "ok";
  int declared = 0;
  for (; said == "ok" && declared < 1000; ++declared) said = declare(*robot, declared);
  EXPECT_EQ(said, "too-large");
  EXPECT_LE(declared, 260);
  std::vector<Relation> at_once;
  for (int i = 0; i < 300; ++i) at_once.push_back(relation(fmt::format("(relation arm-at-once-{} ((n integer)))", i)));
  EXPECT_EQ(symbol_of(run(robot->declare(at_once))), "too-large");
  EXPECT_EQ(declare(*robot, 0), "ok") << "it is there";
  EXPECT_EQ(declare(*view("boss"), declared), "ok");
}

TEST_F(SecurityTest, NobodyTellsReadsOrTakesWhatItsKeyDoesNotAllow) {
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  for (const char* fact : {"(goal 1)", "(arm idle)", "(job 1)"}) ASSERT_EQ(tell(*boss, fact), "ok") << fact;
  const Result<Revision> refused = run(robot->tell(read("(goal 2)")));
  ASSERT_EQ(symbol_of(refused), "not-permitted");
  EXPECT_EQ(refused.error().sentence, "the key robot may not tell facts of goal");
  EXPECT_EQ(refused.error().subject, read("(goal 2)"));
  EXPECT_EQ(retract(*robot, "(goal ?)"), "not-permitted");
  EXPECT_EQ(ask(*robot, "(goal ?n)"), "not-permitted");
  EXPECT_EQ(ask(*robot, "(and (arm ?s) (not (goal ?n)))"), "not-permitted");
  EXPECT_EQ(symbol_of(run(robot->watch(query("(goal ?n)")))), "not-permitted");
  EXPECT_EQ(symbol_of(run(robot->take(read("(arm ?)"), 0))), "not-permitted");
  Transaction curious;
  curious.require(Transaction::Present{read("(goal 1)")}).tell(read("(arm moving)"));
  EXPECT_EQ(symbol_of(run(robot->transact(curious))), "not-permitted");
  const std::vector<Relation> own_idea = {relation("(relation plan ((n integer)))")};
  EXPECT_EQ(symbol_of(run(robot->declare(own_idea))), "not-permitted");
  // A client does not learn the declarations of relations that it has no right to.
  const std::string guesses[] = {"(relation goal ((n integer)) (key n))", "(relation goal ((n symbol)))"};
  for (const std::string& guess : guesses) {
    const Result<void> learned = run(robot->declare({relation(guess)}));
    ASSERT_EQ(symbol_of(learned), "not-permitted") << guess;
    EXPECT_EQ(learned.error().sentence, "the key robot may not declare goal");
    EXPECT_EQ(learned.error().subject, relation_to_datum(relation(guess))) << "no more than what it said";
  }
  EXPECT_EQ(symbol_of(run(robot->declare({relation("(relation job ((n integer)) (key n))")}))), "ok");

  EXPECT_EQ(tell(*robot, "(arm moving)"), "ok");
  EXPECT_EQ(ask(*robot, "(arm ?s)"), "ok");
  EXPECT_EQ(ask(*robot, "(arm-pose ?x)"), "ok") << "a beginning with a star";
  EXPECT_EQ(symbol_of(run(robot->take(read("(job ?)"), 0))), "ok");
  const std::vector<Fact> told = refusals("robot");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.front().datum[3].integer(), 10);
  const auto hand = view("robot", "prompt-17");
  EXPECT_EQ(ask(*hand, "(goal ?n)"), "not-permitted");
  EXPECT_EQ(refusals("robot").front().datum[3].integer(), 11) << "it is the key that was refused";
  EXPECT_TRUE(refusals("robot/prompt-17").empty());
}

TEST_F(SecurityTest, WhatAnotherToldUnderItsLeaseIsLeftToItUnlessThatIsPermitted) {
  ASSERT_TRUE(wire::make_keys(folder_, "warden", {{"agent"}, {}, {}, {"agent"}}).has_value());
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  const LeaseId lease = run(boss->lease(60s)).value();
  ASSERT_EQ(tell(*boss, "(agent boss)", lease), "ok");
  ASSERT_EQ(tell(*boss, "(agent loose)"), "ok");
  EXPECT_EQ(retract(*robot, "(agent ?)"), "not-permitted");
  EXPECT_EQ(tell(*robot, "(agent boss)"), "not-permitted") << "it would take the lease away";
  EXPECT_EQ(tell(*robot, "(agent robot)", lease), "not-permitted");
  const Result<void> renewed = run(robot->renew(lease));
  ASSERT_EQ(symbol_of(renewed), "not-permitted");
  EXPECT_EQ(renewed.error().sentence, "the key robot may not use the lease of another");
  EXPECT_EQ(symbol_of(run(robot->release(lease))), "not-permitted");
  EXPECT_EQ(retract(*robot, "(agent loose)"), "ok") << "nobody's lease";
  EXPECT_EQ(symbol_of(run(boss->renew(lease))), "ok");
  const auto warden = view("warden");
  EXPECT_EQ(retract(*warden, "(agent ?)"), "ok");
}

// To permit a transaction and to do it have one bound together.
TEST_F(SecurityTest, WhatAKeyRetractsIsLookedAtWithinTheBoundOfATransaction) {
  serve();
  const std::vector<Relation> pairs = {relation("(relation arm-pair ((a integer) (b integer)))")};
  ASSERT_EQ(symbol_of(run(view("boss")->declare(pairs))), "ok");
  constexpr std::size_t many = limits::examined * 3 / 5;
  Transaction all;
  for (std::size_t i = 0; i < many; ++i) {
    all.tell(list("arm-pair"_sym, i, i + 1));
    if (all.steps.size() < limits::steps / 2 && i + 1 < many) continue;
    ASSERT_EQ(symbol_of(board_.transact("robot", std::exchange(all, {}))), "ok");
  }
  ASSERT_TRUE(wire::make_keys(folder_, "arm", {{"arm*"}, {}, {}, {}}).has_value());
  ASSERT_TRUE(wire::make_keys(folder_, "warden", {{"arm*"}, {}, {}, {"arm*"}}).has_value());
  EXPECT_EQ(retract(*view("arm"), "(arm-pair ?x ?x)"), "too-costly") << "looked at twice";
  EXPECT_EQ(retract(*view("warden"), "(arm-pair ?x ?x)"), "ok") << "looked at once";
  Transaction flood;
  for (int i = 0; i < 200; ++i) flood.retract(read("(arm-pair ?x ?x)"));
  const auto arm = view("arm");
  ASSERT_EQ(symbol_of(run(arm->ask(query("(arm-pair 1 ?)")))), "not-permitted") << "it is met";
  const Time before = executor_.now();
  EXPECT_EQ(symbol_of(run(arm->transact(flood))), "too-costly");
  EXPECT_LT(executor_.now() - before, 1s) << "in which nobody else is served";
}

TEST_F(SecurityTest, WhatAnotherTookIsNotSettledForIt) {
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  ASSERT_EQ(tell(*boss, "(job 1)"), "ok");
  const LeaseId holder = run(boss->lease(60s)).value();
  const FactId taken = run(boss->take(read("(job ?)"), holder)).value()->id;
  Transaction steal;
  steal.settle(taken);
  EXPECT_EQ(symbol_of(run(robot->transact(steal))), "not-permitted");
  EXPECT_EQ(symbol_of(run(boss->transact(steal))), "ok");
}

TEST_F(SecurityTest, ARemovedKeyIsOutWithinASecondThoughItsConnectionStands) {
  serve();
  const auto robot = view("robot");
  ASSERT_EQ(tell(*robot, "(arm idle)"), "ok");
  const std::unique_ptr<Watch> watch = run(robot->watch(query("(arm ?s)"))).value();
  std::filesystem::remove(folder_ + "/robot.key");
  pass(400ms);
  EXPECT_EQ(tell(*robot, "(arm moving)"), "not-permitted");
  const auto again = view("robot");
  EXPECT_EQ(tell(*again, "(arm moving)"), "not-permitted");
}

TEST_F(SecurityTest, AnotherKeyUnderTheSameNameEndsTheFormersSessions) {
  serve();
  const auto old = view("robot");
  ASSERT_EQ(tell(*old, "(arm idle)"), "ok");
  std::filesystem::remove(folder_ + "/robot.key");
  std::filesystem::remove(folder_ + "/robot.secret");
  ASSERT_TRUE(wire::make_keys(folder_, "robot", {{"arm"}, {}, {}, {}}).has_value());
  const auto fresh = view("robot");
  EXPECT_EQ(tell(*fresh, "(arm moving)"), "ok") << "at its first connection";
  EXPECT_EQ(tell(*old, "(arm fault)"), "not-permitted");
}

TEST_F(SecurityTest, ChangedPermissionsHoldForSessionsThatStandAndTheirWatches) {
  serve();
  const auto robot = view("robot");
  const std::unique_ptr<Watch> watch = run(robot->watch(query("(job ?n)"))).value();
  ASSERT_TRUE(run(watch->next()).has_value());
  const std::string path = folder_ + "/robot.key";
  const wire::PublicKey key = wire::read_public_key(path).value();
  std::ofstream(path) << "(key robot \"" << key.key << "\" (tell goal))\n";
  const Result<Change> ended = run(watch->next());
  EXPECT_EQ(symbol_of(ended), "not-permitted");
  EXPECT_EQ(tell(*robot, "(goal 1)"), "ok");
  EXPECT_EQ(tell(*robot, "(arm idle)"), "not-permitted");
}

TEST_F(SecurityTest, NobodyHearsOfARelationThatIsNoneOfItsBusiness) {
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  ASSERT_EQ(symbol_of(run(boss->declare({relation("(relation xarm-plans ((n integer)) (key n))")}))), "ok");
  const auto told = [&](const auto& result) { return result.error().symbol + ": " + result.error().sentence; };
  const std::string without = "undeclared-relation: no relation is called arm-plans";
  EXPECT_EQ(told(run(robot->ask(query("(arm-plans ?n)")))), without);
  EXPECT_EQ(told(run(robot->watch(query("(arm-plans ?n)")))), without);
  const Transaction::Absent none{read("(arm-plans ?)")};
  EXPECT_EQ(told(run(robot->transact(Transaction().tell(read("(arm idle)")).require(none)))), without);
  EXPECT_EQ(told(run(boss->ask(query("(arm-plans ?n)")))), without + "; did you mean xarm-plans?");
  EXPECT_EQ(told(run(robot->ask(query("(arm-pos ?n)")))),
            "undeclared-relation: no relation is called arm-pos; did you mean arm-pose?");
}

TEST_F(SecurityTest, OfAFolderOfKeysIsLookedAtForEachHelloOnlyWhetherFilesCameOrWent) {
  server::KeyFolder keys = server::KeyFolder::open(folder_).value();
  const auto robot = [&] { return wire::read_public_key(folder_ + "/robot.key").value(); };
  EXPECT_FALSE(keys.follow());
  const std::string former = robot().key;
  std::ofstream(folder_ + "/robot.key", std::ios::app) << "\n";
  EXPECT_FALSE(keys.follow()) << "what is written into one is found in its time";
  EXPECT_TRUE(keys.refresh());
  EXPECT_FALSE(keys.refresh());
  EXPECT_NE(keys.find(former), nullptr);
  // The clock of a file system has steps.
  pass(20ms);
  std::filesystem::remove(folder_ + "/robot.key");
  EXPECT_TRUE(keys.follow());
  EXPECT_EQ(keys.find(former), nullptr);
}

TEST_F(SecurityTest, ABrokenKeyFileLetsNobodyInAndIsTold) {
  serve();
  std::ofstream(folder_ + "/robot.key") << "(key robot";
  pass(200ms);
  const auto robot = view("robot");
  EXPECT_EQ(tell(*robot, "(arm idle)"), "not-permitted");
  EXPECT_EQ(refusals("").size(), 1U);
}

TEST(KeyFiles, AreWrittenSoThatOnlyTheOwnerReadsTheSecretAndReadBack) {
  const std::string folder = ipc_address().substr(6) + ".keys";
  const wire::Permissions may{{"arm", "arm-*"}, {"request"}, {"*"}, {}};
  const wire::KeyPair made = wire::make_keys(folder, "robot", may).value();
  EXPECT_EQ(std::filesystem::status(folder + "/robot.secret").permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_EQ(wire::read_public_key(folder + "/robot.key").value(), (wire::PublicKey{"robot", made.public_key, may}));
  EXPECT_EQ(wire::read_secret_key(folder + "/robot.secret").value().secret_key, made.secret_key);
  EXPECT_EQ(symbol_of(wire::make_keys(folder, "robot", may)), "already-there");
  EXPECT_EQ(symbol_of(wire::make_keys(folder, "../robot", may)), "bad-name");
  EXPECT_EQ(symbol_of(wire::read_client_keys(folder + "/robot.secret")), "unreadable-file") << "no board.key";
  std::filesystem::permissions(folder + "/robot.secret", std::filesystem::perms::group_read,
                               std::filesystem::perm_options::add);
  EXPECT_EQ(symbol_of(wire::read_secret_key(folder + "/robot.secret")), "exposed-key");
  std::filesystem::remove_all(folder);
}

TEST(KeyFiles, AreNotMadeForWhatIsNoRelationAndNothingIsLeftBehind) {
  const std::string folder = ipc_address().substr(6) + ".keys";
  const std::string longest(limits::name_bytes, 'r');
  for (const std::string& name :
       {std::string(), std::string(" x"), std::string("a*b"), std::string("**"), std::string("?x"), std::string("12"),
        std::string("."), std::string("a(b"), std::string("\xff"), std::string("a\0", 2), longest + "r"}) {
    for (const wire::Permissions& may :
         {wire::Permissions{{"arm", name}, {}, {}, {}}, wire::Permissions{{}, {name}, {}, {}},
          wire::Permissions{{}, {}, {name}, {}}, wire::Permissions{{}, {}, {}, {name}}}) {
      EXPECT_EQ(symbol_of(wire::make_keys(folder, "robot", may)), "bad-name") << name;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
  const wire::Permissions may{{"arm-*", longest}, {"*"}, {"<-*"}, {}};
  ASSERT_EQ(symbol_of(wire::make_keys(folder, "robot", may)), "ok");
  EXPECT_EQ(wire::read_public_key(folder + "/robot.key").value().may, may);
  std::filesystem::remove_all(folder);
}

TEST(KeyFiles, SayWhereTheyAreWrong) {
  const std::string file = ipc_address().substr(6) + ".key";
  const std::string key(40, '0');
  for (const std::string& text :
       {std::string("(key)"), std::string("(key robot)"), "(key robot \"" + key.substr(1) + "\")",
        "(key \"robot\" \"" + key + "\")", "(key robot \"" + key + "\" (dance *))",
        "(key robot \"" + key + "\" (tell a*b))", "(key robot \"" + key + "\" (tell ?a))",
        "(key robot \"" + key + "\" (tell \"arm\"))", "(key robot \"" + key + "\" (tell a) (tell b))",
        "(key robot \"" + key + "\") (key)"}) {
    std::ofstream(file) << text;
    const Result<wire::PublicKey> read = wire::read_public_key(file);
    ASSERT_EQ(symbol_of(read), "bad-key") << text;
    EXPECT_NE(read.error().place.find(file + ":1:"), std::string::npos) << read.error().place;
  }
  std::ofstream(file) << "(key robot \"" + key + "\" (read *))";
  EXPECT_EQ(symbol_of(wire::read_public_key(file)), "ok");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace pizarra
