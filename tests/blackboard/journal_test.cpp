#include "blackboard/journal/journal.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <unistd.h>

#include "blackboard/limits.hpp"
#include "blackboard/memory/recorded_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

class Journal : public testing::Test {
 protected:
  ~Journal() override { std::filesystem::remove(path_); }

  std::unique_ptr<memory::RecordedBoard> play(const std::string& text, const Moment& until = {}) {
    std::ofstream(path_, std::ios::binary) << text;
    return memory::RecordedBoard::open(executor_, path_, until).value();
  }
  std::vector<Fact> facts(Board& board, const std::string& pattern) {
    std::vector<Fact> facts;
    const auto collect = [](Board& b, Datum wanted, std::vector<Fact>& out) -> Task<void> {
      Result<std::vector<Fact>> found = co_await b.facts(wanted);
      out = std::move(*found);
    };
    const Job job = executor_.spawn(collect(board, read(pattern), facts));
    executor_.run_until([&] { return job.done(); });
    return facts;
  }

  const std::filesystem::path path_ = scratch_folder() + "journal";
  VirtualExecutor executor_;
};

TEST_F(Journal, SaysEveryKindOfChangeInALine) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  std::string text;
  board.set_journal([&](std::string_view line) { text += std::string(line) + "\n"; });
  ASSERT_TRUE(board.declare("alice", {relation("(relation on ((a symbol) (b symbol)))")}).has_value());
  Transaction first;
  first.tell(read("(on a b)")).tell(read("(on b c)"), {1, 7});
  ASSERT_TRUE(board.transact("alice", first).has_value());
  executor.run_for(1500us);
  const LeaseId lease = board.lease(1s).value();
  ASSERT_TRUE(board.take("bob", read("(on a ?)"), lease).has_value());
  ASSERT_TRUE(board.take("bob", read("(on b ?)"), lease).has_value());
  Transaction second;
  second.settle(1);
  ASSERT_TRUE(board.transact("bob", second).has_value());
  ASSERT_TRUE(board.renew(lease).has_value());
  ASSERT_TRUE(board.release(lease).has_value());
  Transaction third;
  third.retract(read("(on ? ?)"));
  ASSERT_TRUE(board.transact("alice", third).has_value());
  ASSERT_TRUE(board.transact("alice", third).has_value());
  EXPECT_EQ(text,
            "(0 0 \"alice\" (declare (relation on ((a symbol) (b symbol)) (key a b))))\n"
            "(1 0 \"alice\" (tell 1 (on a b)) (tell 2 (on b c) (because 1 7)))\n"
            "(2 1500 \"bob\" (take 1))\n"
            "(3 1500 \"bob\" (take 2))\n"
            "(4 1500 \"bob\" (settle 1))\n"
            "(5 1500 \"board\" (return 2 3))\n"
            "(6 1500 \"alice\" (retract 3))\n");
}

TEST_F(Journal, AFactToldBecauseOfNoFactCanBeRead) {
  const auto read_back = journal::read_journal_line("(1 0 \"alice\" (tell 1 (on a b) (because 0 7)))");
  ASSERT_TRUE(read_back.has_value()) << read_back.error().sentence;
  EXPECT_EQ(std::get<store::Commit>(*read_back).entries.at(0).fact.because, (std::vector<FactId>{0, 7}));
}

// The end of a lease under which everything was taken, on a board that has lived for long.
TEST_F(Journal, WhatItSaysOfAllThereMayBeCanBeRead) {
  constexpr FactId highest = std::numeric_limits<std::int64_t>::max();
  store::Commit commit{.revision = 1, .when = {}, .teller = "board", .entries = {}};
  store::Commit::Entry entry{.kind = store::Commit::Entry::Kind::returned, .fact = {}, .under_lease = true};
  for (FactId id = highest - limits::facts; id < highest; ++id) {
    entry.former = entry.fact.id = id;
    commit.entries.push_back(entry);
  }
  const auto read = journal::read_journal_line(journal::journal_line(commit));
  ASSERT_TRUE(read.has_value()) << read.error().sentence;
  EXPECT_EQ(std::get<store::Commit>(*read).entries.size(), limits::facts);
}

constexpr const char* modes =
    "(0 0 \"alice\" (declare (relation mode ((name symbol)) (key))))\n"
    "(1 10 \"alice\" (tell 1 (mode idle)))\n"
    "(2 20 \"bob\" (retract 1) (tell 2 (mode ready)))\n"
    "(3 30 \"bob\" (retract 2))\n"
    "(4 40 \"bob\" (tell 3 (mo";

TEST_F(Journal, ARecordedBoardAnswersAsOfItsRevision) {
  EXPECT_EQ(facts(*play(modes, {.revision = 1}), "(mode ?m)").at(0).datum, read("(mode idle)"));
  const Fact ready = facts(*play(modes, {.revision = 2}), "(mode ?m)").at(0);
  EXPECT_EQ(ready.datum, read("(mode ready)"));
  EXPECT_EQ(ready.teller, "bob");
  EXPECT_EQ(ready.when, Time(20us));
  EXPECT_EQ(ready.revision, 2U);
  EXPECT_TRUE(facts(*play(modes, {}), "(mode ?m)").empty()) << "the torn line is left out";
}

TEST_F(Journal, ARecordedBoardAnswersAsOfATime) {
  const auto at = [&](Duration time) { return play(modes, {.time = Time(time)})->revision(); };
  EXPECT_EQ(at(9us), 0U);
  EXPECT_EQ(at(10us), 1U);
  EXPECT_EQ(at(29us), 2U);
  EXPECT_EQ(at(1s), 3U);
}

TEST_F(Journal, WhoeverWatchesARecordedBoardSeesEveryRevisionThatIsPlayedBack) {
  const std::unique_ptr<memory::RecordedBoard> board = play(modes, {.revision = 0});
  std::vector<std::string> seen;
  const auto follow = [](Board& b, std::vector<std::string>& out) -> Task<void> {
    Query watched = query("(mode ?m)");
    const Result<std::unique_ptr<Watch>> watch = co_await b.watch(watched);
    while (true) {
      const Result<Change> change = co_await (*watch)->next();
      std::string line = std::to_string(change->revision);
      for (const Answer& answer : change->added) line += " +" + write(answer.facts.front().datum);
      for (const Answer& answer : change->removed) line += " -" + write(answer.facts.front().datum);
      out.push_back(line);
    }
  };
  const Job job = executor_.spawn(follow(*board, seen));
  executor_.run_for(1ms);
  EXPECT_EQ(board->next(), Time(10us));
  EXPECT_TRUE(board->step().value());
  EXPECT_EQ(board->revision(), 1U);
  EXPECT_TRUE(board->step().value());
  EXPECT_EQ(board->revision(), 2U);
  EXPECT_TRUE(board->step().value());
  EXPECT_FALSE(board->step().value());
  EXPECT_EQ(board->next(), std::nullopt);
  executor_.run_for(1ms);
  EXPECT_EQ(seen, (std::vector<std::string>{"0", "1 +(mode idle)", "2 +(mode ready) -(mode idle)", "3 -(mode ready)"}));
}

TEST_F(Journal, ARecordedBoardCannotBeChanged) {
  const std::unique_ptr<memory::RecordedBoard> board = play(modes);
  std::string symbol;
  const auto attempt = [](Board& b, std::string& out) -> Task<void> {
    Datum fact = read_one("(mode idle)").value();
    const Result<Revision> told = co_await b.tell(fact);
    out = told.error().symbol;
  };
  const Job job = executor_.spawn(attempt(*board, symbol));
  executor_.run_until([&] { return job.done(); });
  EXPECT_EQ(symbol, "read-only");
}

TEST_F(Journal, LinesThatCannotHaveHappenedAreRefused) {
  const std::string start = "(0 0 \"a\" (declare (relation mode ((name symbol)) (key))))\n";
  for (const char* line :
       {"nonsense", "(1 0 \"a\")", "(1 0 a (tell 1 (mode x)))", "(0 0 \"a\" (tell 1 (mode x)))",
        "(1 0 \"a\" (tell 0 (mode x)))", "(1 0 \"a\" (tell 1 (mode 5)))", "(1 0 \"a\" (tell 1 (other x)))",
        "(1 0 \"a\" (retract 1))", "(1 0 \"a\" (settle 1))", "(1 0 \"a\" (return 1 2))",
        "(1 0 \"a\" (tell 1 (mode x)) (tell 2 (mode y)))", "(1 0 \"a\" (forget 1))",
        "(1 0 \"a\" (tell 1 (mode x) (since 3)))", "(1 0 \"a\" (tell 1 (mode ?x)))", "(1 0 \"a\" (tell 1 (mode x))"}) {
    store::Store store;
    EXPECT_FALSE(journal::replay(start + line + "\n", store).has_value()) << line;
  }
}

}  // namespace
}  // namespace pizarra
