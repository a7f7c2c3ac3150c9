// A board whose journal is on a file system of sixteen megabytes that becomes full, or that may not grow.

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <ranges>
#include <set>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/blackboard/server_fixture.hpp"
#include "tests/blackboard/small_disk.hpp"

namespace pizarra {
namespace {

struct Raw : ServerTest {
  using ServerTest::Client;
};

class FullDiskTest : public testing::Test, public Wall {
 protected:
  explicit FullDiskTest(const std::string& size = "16m") : disk_(size) {}
  void SetUp() override {
    if (!disk_.mounted()) GTEST_SKIP() << "a file system is root's to mount";
  }
  void start(std::vector<std::string> words = {}) {
    for (const std::string& word :
         {std::string(PIZARRA_BOARD_PROGRAM), std::string("--listen"), address_, std::string("--journal"),
          disk_.file("board.journal"), std::string("--history"), std::string("0")}) {
      words.push_back(word);
    }
    board_.emplace(std::move(words));
    std::string line = board_->line();
    // On a full disk it says so first.
    if (line.find("the disk is full") != std::string::npos) line = board_->line();
    ASSERT_TRUE(line.starts_with("pizarra-board: ready")) << line;
    alice_ = view("alice");
  }
  void declare() {
    ASSERT_EQ(symbol_of(run(alice_->declare({relation("(relation goal ((n integer) (text string)) (key n) (durable))"),
                                             relation("(relation note ((n integer) (text string)) (key n))")}))),
              "ok");
  }
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return client::RemoteBoard::connect(executor_, address_, teller).value();
  }
  Result<Revision> tell(const std::string& relation, int n, std::size_t bytes = 20'000) {
    return run(alice_->tell(list(Datum::symbol(relation), n, std::string(bytes, 'x'))));
  }
  std::size_t goals() { return numbers().size(); }

  std::set<int> numbers() {
    std::set<int> numbers;
    for (int n = 0; n < 500; ++n) {
      if (!run(alice_->facts(list("goal"_sym, n, "?"_sym))).value().empty()) numbers.insert(n);
    }
    return numbers;
  }
  Task<void> tell_large(int n, std::map<int, std::string>& told) {
    const Datum fact = list("goal"_sym, n, std::string(100'000, 'x'));
    const Result<Revision> result = co_await alice_->tell(fact);
    told[n] = symbol_of(result);
  }
  Task<void> take_first(LeaseId lease, std::string& taken) {
    const Datum pattern = read("(goal 0 ?)");
    const Result<std::optional<Fact>> result = co_await alice_->take(pattern, lease);
    taken = symbol_of(result);
  }

  const SmallDisk disk_;
  const std::string address_ = ipc_address();
  RealExecutor executor_;
  std::optional<ChildProgram> board_;
  std::unique_ptr<Board> alice_;
};

TEST_F(FullDiskTest, WhatIsDurableIsRefusedByNameReadsGoOnAndWithSpaceItIsWrittenAgain) {
  start();
  declare();
  ASSERT_EQ(symbol_of(tell("goal", 1)), "ok");
  disk_.fill();
  int last = 1;
  Result<Revision> told = tell("goal", last + 1);
  for (; told && last < 400; told = tell("goal", last + 1)) ++last;
  ASSERT_FALSE(told.has_value());
  EXPECT_EQ(told.error().symbol, "journal-full") << told.error().sentence;
  EXPECT_NE(told.error().sentence.find("board.journal"), std::string::npos) << told.error().sentence;
  EXPECT_EQ(goals(), static_cast<std::size_t>(last)) << "reading goes on, and what was refused is not there";
  EXPECT_EQ(symbol_of(tell("note", 1)), "ok") << "what need not last goes on";
  disk_.clear();
  const Time freed = executor_.now();
  while (!told && executor_.now() < freed + 20s) {
    pass(50ms);
    told = tell("goal", last + 1);
  }
  ASSERT_TRUE(told.has_value()) << told.error().sentence;
  // All that was acknowledged is there after it was killed.
  EXPECT_EQ(board_->stop(SIGKILL), -SIGKILL);
  start();
  EXPECT_EQ(goals(), static_cast<std::size_t>(last + 1));
}

// Asked for at once, while the board is held: more than the disk takes.
TEST_F(FullDiskTest, OfManyChangesUnderWayThoseRefusedDoNotStandAndTheOthersLast) {
  start();
  declare();
  ASSERT_EQ(symbol_of(tell("goal", 0)), "ok");
  const LeaseId lease = *run(alice_->lease(60s));
  disk_.fill();
  constexpr int many = 120;
  std::map<int, std::string> told;
  std::string taken;
  std::vector<Job> jobs;
  board_->send(SIGSTOP);
  for (int n = 1; n <= many; ++n) jobs.push_back(executor_.spawn(tell_large(n, told)));
  jobs.push_back(executor_.spawn(take_first(lease, taken)));
  pass(200ms);
  board_->send(SIGCONT);
  const Time begun = executor_.now();
  ASSERT_TRUE(comes([&] { return told.size() == many && !taken.empty(); }));
  EXPECT_LT(executor_.now() - begun, 5s);
  std::set<int> expected;
  if (taken != "ok") expected.insert(0);
  for (const auto& [n, symbol] : told) {
    EXPECT_TRUE(symbol == "ok" || symbol == "journal-full") << n << ": " << symbol;
    if (symbol == "ok") expected.insert(n);
  }
  const auto refused = std::ranges::count(std::views::values(told), "journal-full");
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, many);
  EXPECT_EQ(numbers(), expected);
  EXPECT_EQ(board_->stop(SIGKILL), -SIGKILL);
  disk_.clear();
  start();
  expected.insert(0);  // what was taken is put back, for its taker is gone
  EXPECT_EQ(numbers(), expected);
}

// A client that hears nothing for a second asks again: both may be on their way when the first is refused.
TEST_F(FullDiskTest, WhatWasRefusedIsNotDoneWhenItComesAgainAndThereIsSpace) {
  start();
  declare();
  Raw::Client client(executor_, address_);
  const std::string session = client.join("bob");
  const auto told = [&](int n) {
    const std::string fact = "(goal " + std::to_string(n) + " \"" + std::string(20'000, 'x') + "\")";
    const std::string number = std::to_string(n);
    return client.ask("(request " + session + " " + number + " (transact () ((tell " + fact + " 0))))");
  };
  disk_.fill();
  int refused = 1;
  while (refused < 400 && told(refused)[2].is_form("ok")) ++refused;
  disk_.clear();
  int later = refused + 1;
  while (later < refused + 100 && !told(later)[2].is_form("ok")) pass(50ms), ++later;
  ASSERT_LT(later, refused + 100);
  const Datum again = told(refused);
  ASSERT_TRUE(again[2].is_form("fail")) << write(again);
  EXPECT_EQ(again[2][1], "journal-full"_sym);
  EXPECT_FALSE(numbers().contains(refused));
}

TEST_F(FullDiskTest, WhatTakesDurableFactsAwayAndAddsNoneGoesOn) {
  start();
  declare();
  for (int n = 0; n < 10; ++n) ASSERT_EQ(symbol_of(tell("goal", n)), "ok");
  const LeaseId lease = *run(alice_->lease(60s));
  const Fact held = *run(alice_->take(read("(goal 0 ?)"), lease)).value();
  disk_.fill();
  int last = 10;
  while (last < 400 && tell("goal", last)) ++last;
  ASSERT_EQ(symbol_of(tell("goal", last)), "journal-full");
  EXPECT_EQ(symbol_of(run(alice_->transact(Transaction().retract(read("(goal 1 ?)"))))), "ok");
  EXPECT_EQ(symbol_of(run(alice_->transact(Transaction().settle(held.id)))), "ok");
  EXPECT_EQ(symbol_of(run(alice_->take(read("(goal 3 ?)"), lease))), "journal-full") << "it may come back";
  EXPECT_EQ(
      symbol_of(run(alice_->transact(Transaction().retract(read("(goal 4 ?)")).tell(list("goal"_sym, 4, "short"))))),
      "journal-full");
  EXPECT_EQ(numbers().size(), static_cast<std::size_t>(last) - 2);
  EXPECT_EQ(board_->stop(SIGKILL), -SIGKILL);
  start();
  const std::set<int> kept = numbers();
  EXPECT_EQ(kept.size(), static_cast<std::size_t>(last) - 2);
  for (const int gone : {0, 1}) EXPECT_FALSE(kept.contains(gone)) << gone;
}

// The journal names every fact that goes: of many that is more than a frame holds.
TEST_F(FullDiskTest, NoMoreIsRetractedAtOnceThanThereIsRoomToSay) {
  start();
  declare();
  constexpr int many = 120'000;
  Transaction some;
  for (int n = 0; n < many; ++n) {
    some.tell(list("goal"_sym, n, std::to_string(n % 8)));
    if (some.steps.size() < 8000) continue;
    ASSERT_EQ(symbol_of(run(alice_->transact(std::exchange(some, {})))), "ok");
  }
  const Result<Revision> all = run(alice_->transact(Transaction().retract(read("(goal ? ?)"))));
  ASSERT_EQ(symbol_of(all), "journal-full");
  EXPECT_EQ(run(alice_->facts(read("(goal 7 ?)")))->size(), 1U) << "nothing went";
  for (int part = 0; part < 8; ++part) {
    Transaction portion;
    portion.retract(list("goal"_sym, "?"_sym, std::to_string(part)));
    std::string said = symbol_of(run(alice_->transact(portion)));
    // The work done for her until here is paid by waiting.
    for (int waited = 0; said == "too-many" && waited < 50; ++waited) {
      pass(100ms);
      said = symbol_of(run(alice_->transact(portion)));
    }
    EXPECT_EQ(said, "ok") << part;
  }
  EXPECT_TRUE(run(alice_->facts(read("(goal ? ?)")))->empty());
}

// Where there is space for more than one file may hold.
class FullFileTest : public FullDiskTest {
 protected:
  FullFileTest() : FullDiskTest("64m") {}
};

TEST_F(FullFileTest, WhatStandsAndCannotBeWrittenIsSaidToStandAndNothingMoreIsTaken) {
  start({"sh", "-c", "ulimit -f 32768; exec \"$@\"", "sh"});  // blocks of 512 bytes
  declare();
  int last = 0;
  Result<Revision> told = tell("goal", last + 1, 100'000);
  for (; told && last < 400; told = tell("goal", last + 1, 100'000)) ++last;
  ASSERT_FALSE(told.has_value());
  EXPECT_EQ(told.error().symbol, "not-durable") << told.error().sentence;
  EXPECT_TRUE(told.error().subject.is_integer()) << "the revision that it stands since";
  EXPECT_EQ(goals(), static_cast<std::size_t>(last + 1));
  EXPECT_EQ(symbol_of(tell("goal", last + 2, 100'000)), "journal-full");
  EXPECT_EQ(goals(), static_cast<std::size_t>(last + 1));
  EXPECT_EQ(symbol_of(tell("note", 1)), "ok") << "what need not last goes on";
  EXPECT_EQ(board_->stop(SIGKILL), -SIGKILL);
  start();
  EXPECT_EQ(goals(), static_cast<std::size_t>(last));
}

}  // namespace
}  // namespace pizarra
