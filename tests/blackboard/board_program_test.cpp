#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zmq.hpp>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/child_program.hpp"

namespace pizarra {
namespace {

struct Program : ChildProgram {
  explicit Program(std::vector<std::string> words) : ChildProgram(of_board(std::move(words))) {}
  static std::vector<std::string> of_board(std::vector<std::string> words) {
    words.insert(words.begin(), PIZARRA_BOARD_PROGRAM);
    return words;
  }
};

class BoardProgram : public testing::Test, public Wall {
 protected:
  ~BoardProgram() override { journal::remove_journal(journal_); }
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return client::RemoteBoard::connect(executor_, address_, teller).value();
  }

  const std::vector<Relation> relations_ = {relation("(relation goal ((n integer)) (durable))"),
                                            relation("(relation seen ((n integer)))")};
  RealExecutor executor_;
  const std::string address_ = ipc_address();
  const std::string path_ = address_.substr(6);
  const std::string journal_ = path_ + ".journal";
};

TEST_F(BoardProgram, SaysThatItIsReadyServesAndStopsCleanly) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program({"--listen", address_, "--listen", "tcp://127.0.0.1:*"});
    const std::string ready = program.line();
    EXPECT_TRUE(ready.starts_with("pizarra-board: ready on " + address_ + " tcp://127.0.0.1:")) << ready;
    const auto alice = client::RemoteBoard::connect(executor_, address_, "alice").value();
    EXPECT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
    EXPECT_EQ(symbol_of(run(alice->tell(read("(seen 1)")))), "ok");
    const Time stopped = executor_.now();
    program.send(signal);
    executor_.run_until([&] { return !alice->connected() || executor_.now() > stopped + 3s; });
    EXPECT_LT(executor_.now() - stopped, 1s) << "its clients are told";
    EXPECT_EQ(program.wait(), 0);
    EXPECT_EQ(program.rest(), "");
    EXPECT_FALSE(std::filesystem::exists(path_));
  }
}

TEST_F(BoardProgram, SaysBeforeItStandsByThatItCouldNotLeadTheCell) {
  const std::vector<std::string> log = {"--log", "etcd://127.0.0.1:1/cell"};
  const auto refusal = [&](std::vector<std::string> words) {
    words.insert(words.end(), log.begin(), log.end());
    Program program(words);
    EXPECT_EQ(program.wait(), 3);
    return program.rest();
  };
  const std::string keys = refusal({"--listen", "tcp://127.0.0.1:*", "--keys", "/nowhere"});
  EXPECT_TRUE(keys.contains("the board has no key of its own there")) << keys;
  // 192.0.2.0/24 is for documentation: no machine has such an address.
  const std::string address = refusal({"--listen", "tcp://192.0.2.1:7943", "--insecure"});
  EXPECT_TRUE(address.contains("ZeroMQ refuses the address")) << address;
  EXPECT_FALSE(address.contains("stands by")) << address;
}

TEST_F(BoardProgram, RunsWithoutOpenCvAndGuile) {
  Program program({"--listen", address_});
  program.line();
  const std::string files = program.mapped_files();
  EXPECT_NE(files.find("libzmq"), std::string::npos) << files;
  EXPECT_EQ(files.find("libopencv"), std::string::npos) << files;
  EXPECT_EQ(files.find("libguile"), std::string::npos) << files;
  EXPECT_EQ(program.stop(SIGTERM), 0);
}

// All of it was stopped, those of its threads too that hear what comes.
TEST_F(BoardProgram, ALeaseStandsThatWasRenewedWhileItWasStopped) {
  Program program({"--listen", address_});
  program.line();
  const auto alice = view("alice");
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  // Long enough that it cannot lapse before the board is stopped, however busy the machine is.
  constexpr Duration lease_time = 1s;
  for (int round = 0; round < 4; ++round) {
    const LeaseId lease = run(alice->lease(lease_time)).value();
    ASSERT_EQ(symbol_of(run(alice->transact(Transaction().tell(list("seen"_sym, round), {}, lease)))), "ok");
    program.send(SIGSTOP);
    bool goes_on = false;
    executor_.call_at(executor_.now() + lease_time + 100ms, [&] {
      program.send(SIGCONT);
      goes_on = true;
    });
    EXPECT_EQ(symbol_of(run(alice->renew(lease))), "ok") << "round " << round;
    EXPECT_TRUE(goes_on);
    EXPECT_EQ(run(alice->ask(query_for(list("seen"_sym, round))))->answers.size(), 1U);
  }
  EXPECT_EQ(program.stop(SIGTERM), 0);
}

TEST_F(BoardProgram, DurableFactsOutliveItsSuddenDeath) {
  {
    Program program({"--listen", address_, "--journal", journal_});
    program.line();
    const auto alice = view("alice");
    ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
    ASSERT_EQ(symbol_of(run(alice->tell(read("(goal 1)")))), "ok");
    ASSERT_EQ(symbol_of(run(alice->tell(read("(seen 1)")))), "ok");
    EXPECT_EQ(program.stop(SIGKILL), -SIGKILL);
  }
  Program program({"--listen", address_, "--journal", journal_});
  program.line();
  const auto bob = view("bob");
  EXPECT_EQ(run(bob->facts(read("(goal ?n)")))->size(), 1U);
  EXPECT_TRUE(run(bob->facts(read("(seen ?n)")))->empty());
  EXPECT_EQ(program.stop(SIGTERM), 0);
}

TEST_F(BoardProgram, GivesNoRevisionAndNoFactNumberOutAgainThatWasLostInACrash) {
  Program first({"--listen", address_, "--journal", journal_});
  first.line();
  const auto alice = view("alice");
  ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
  ASSERT_EQ(symbol_of(run(alice->tell(read("(goal 1)")))), "ok");
  for (int n = 0; n < 20; ++n) ASSERT_EQ(symbol_of(run(alice->tell(list("seen"_sym, n)))), "ok");
  const Revision last = *run(alice->tell(read("(seen 20)")));
  const FactId newest = run(alice->facts(read("(seen 20)")))->front().id;
  EXPECT_EQ(first.stop(SIGKILL), -SIGKILL);
  Program second({"--listen", address_, "--journal", journal_});
  second.line();
  const Result<Revision> told = run(alice->tell(read("(goal 2)")));
  ASSERT_EQ(symbol_of(told), "ok");
  EXPECT_GT(*told, last);
  EXPECT_GT(run(alice->facts(read("(goal 2)")))->front().id, newest);
  Transaction stale;
  stale.preconditions.emplace_back(Transaction::Unchanged{read("(goal ?n)"), last});
  stale.tell(read("(goal 3)"));
  EXPECT_EQ(symbol_of(run(alice->transact(stale))), "precondition-failed") << "goal 2 came since";
  EXPECT_EQ(second.stop(SIGTERM), 0);
}

// The client's side of the wire, word by word, over a connection of its own.
Datum say(const std::string& address, const std::vector<std::string>& words) {
  zmq::context_t context(1);
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  socket.set(zmq::sockopt::linger, 0);
  socket.set(zmq::sockopt::rcvtimeo, 5000);
  socket.connect(address);
  zmq::message_t answer;
  for (const std::string& word : words) {
    socket.send(zmq::buffer(word));
    if (!socket.recv(answer)) return {};
  }
  return read(answer.to_string());
}

TEST_F(BoardProgram, ARequestWhoseAnswerWasLostInACrashIsNotDoneTwice) {
  const std::string declare = "(declare (relation goal ((n integer)) (durable)))";
  std::string session;
  std::string request;
  {
    Program program({"--listen", address_, "--journal", journal_});
    program.line();
    session = std::to_string(say(address_, {"(hello \"alice\" 0)"})[1].integer());
    const std::string begin = "(request " + session;
    request = begin + " 3 (take (goal ?n) 0))";
    const Datum taken = say(address_, {"(hello \"alice\" " + session + ")", begin + " 1 " + declare + ")",
                                       begin + " 2 (transact () ((tell (goal 1) 0) (tell (goal 2) 0))))", request});
    ASSERT_EQ(taken[2][1][0][4], read("(goal 1)")) << write(taken);
    EXPECT_EQ(program.stop(SIGKILL), -SIGKILL);
  }
  Program program({"--listen", address_, "--journal", journal_});
  program.line();
  EXPECT_TRUE(say(address_, {request}).is_form("unknown-session")) << "the client must learn that this is another life";
  const Datum other = say(address_, {"(hello \"mallory\" " + session + ")"});
  ASSERT_TRUE(other.is_form("welcome")) << write(other);
  EXPECT_NE(other[1], read(session));
  const Datum again = say(address_, {"(hello \"alice\" " + session + ")", request});
  EXPECT_EQ(again[2][1][0][4], read("(goal 1)")) << write(again);
  const auto bob = view("bob");
  EXPECT_EQ(run(bob->facts(read("(goal ?n)")))->size(), 1U) << "the other one was not taken in its place";
  EXPECT_EQ(program.stop(SIGTERM), 0);
}

// An hour after the wall clock: as after a life before somebody set the clock back.
TEST_F(BoardProgram, ItsTimeGoesOnFromItsJournalsEndWhenTheClockWasSetBack) {
  {
    RealExecutor later(RealExecutor::wall_clock() + std::chrono::hours(1));
    memory::MemoryBoard board(later);
    std::string lines;
    board.set_journal([&](std::string_view line) { lines.append(line) += '\n'; });
    ASSERT_TRUE(board.declare("alice", relations_).has_value());
    ASSERT_TRUE(board.transact("alice", Transaction().tell(read("(goal 1)"))).has_value());
    const auto file = journal::JournalFile::open(journal_, {}).value();
    ASSERT_TRUE(file->append({.lines = lines, .replies = {}, .durable = true}).has_value());
  }
  Program program({"--listen", address_, "--journal", journal_});
  program.line();
  const auto bob = view("bob");
  ASSERT_EQ(symbol_of(run(bob->tell(read("(goal 2)")))), "ok");
  const std::vector<Fact> goals = run(bob->facts(read("(goal ?n)"))).value();
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_GT(goals[1].when, goals[0].when);
  Query then = query("(goal ?n)");
  then.at = Moment{.time = goals[0].when};
  EXPECT_EQ(run(bob->ask(then))->answers.size(), 1U);
  EXPECT_EQ(program.stop(SIGTERM), 0);
}

TEST_F(BoardProgram, ARelationOfTodayIsNotSuggestedInItsOwnPlaceWhereThePastHadNone) {
  Program program({"--listen", address_, "--journal", journal_});
  program.line();
  const auto bob = view("bob");
  ASSERT_EQ(symbol_of(run(bob->declare(relations_))), "ok");
  ASSERT_EQ(symbol_of(run(bob->tell(read("(goal 1)")))), "ok");
  ASSERT_EQ(symbol_of(run(bob->declare({relation("(relation later ((n integer)))")}))), "ok");
  Query then = query("(later ?n)");
  then.at = Moment{.revision = 0};
  const Result<Answers> nothing = run(bob->ask(then));
  ASSERT_FALSE(nothing.has_value());
  EXPECT_EQ(nothing.error().sentence, "at revision 0, before the first change of all, no relation is called later");
  EXPECT_EQ(program.stop(SIGTERM), 0);
}

TEST_F(BoardProgram, ItsExitCodesSayWhatWasWrong) {
  const auto code = [](std::vector<std::string> words) {
    Program program(std::move(words));
    EXPECT_NE(program.rest(), "");
    return program.wait();
  };
  EXPECT_EQ(code({"--help"}), 0);
  EXPECT_EQ(code({}), 2);
  EXPECT_EQ(code({"--listen", address_, "--dance"}), 2);
  EXPECT_EQ(code({"--listen", "nowhere"}), 3);
  EXPECT_EQ(code({"--listen", "tcp://0.0.0.0:5999"}), 3);
  EXPECT_EQ(code({"--listen", "\xff\xfe"}), 3);
  EXPECT_EQ(code({"--listen", address_, "--journal", "/no/such/folder/journal"}), 4);
  EXPECT_EQ(code({"--listen", address_, "--journal", "/"}), 4);
  EXPECT_EQ(code({"--listen", address_, "--journal", ""}), 2);
  for (const char* history :
       {"long", "36501d", "999999999d", "1000000000min", "1000000001", "-1", "99999999999999999999s"}) {
    EXPECT_EQ(code({"--listen", address_, "--journal", path_ + ".none", "--history", history}), 2) << history;
  }
}

}  // namespace
}  // namespace pizarra
