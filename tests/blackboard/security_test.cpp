// A board that asks for keys: who is let in, and as whom.

#include <fstream>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "blackboard/server/kept_board.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "tests/blackboard/security_fixture.hpp"

namespace pizarra {
namespace {

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

}  // namespace
}  // namespace pizarra
