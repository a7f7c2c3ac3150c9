#include "blackboard/journal.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "blackboard/journal_file.hpp"
#include "blackboard/recorded_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class Journal : public testing::Test {
 protected:
  Journal() : path_(std::filesystem::temp_directory_path() / ("pizarra-journal-" + std::to_string(getpid()))) {
    std::filesystem::remove(path_);
  }
  ~Journal() override { std::filesystem::remove(path_); }

  // One life of a board that keeps its journal in the file.
  struct Life {
    explicit Life(const std::string& path) {
      auto store = std::make_unique<Store>();
      file = JournalFile::open(path, *store).value();
      board = std::make_unique<MemoryBoard>(executor, std::move(store));
      board->set_journal([this](std::string_view line) { file->append(line); });
      board->resume();
    }
    std::vector<Datum> facts(const std::string& pattern) {
      std::vector<Datum> facts;
      const Result<Answers> answers = board->ask(query(pattern));
      for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front().datum);
      return facts;
    }
    void tell(const std::string& fact) {
      Transaction transaction;
      transaction.tell(read(fact));
      EXPECT_TRUE(board->transact("alice", transaction).has_value());
    }
    VirtualExecutor executor;
    std::unique_ptr<JournalFile> file;
    std::unique_ptr<MemoryBoard> board;
  };

  std::filesystem::path path_;
  const std::vector<Relation> relations_ = {relation("(relation goal ((n integer) (what datum)) (key n) (durable))"),
                                            relation("(relation seen ((name string)))")};
};

TEST_F(Journal, SaysEveryKindOfChangeInALine) {
  VirtualExecutor executor;
  MemoryBoard board(executor);
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

TEST_F(Journal, ARecordedBoardAnswersAsOfItsRevision) {
  const std::string text =
      "(0 0 \"alice\" (declare (relation mode ((name symbol)) (key))))\n"
      "(1 10 \"alice\" (tell 1 (mode idle)))\n"
      "(2 20 \"bob\" (retract 1) (tell 2 (mode ready)))\n"
      "(3 30 \"bob\" (retract 2))\n"
      "(4 40 \"bob\" (tell 3 (mo";
  VirtualExecutor executor;
  const auto modes_at = [&](Revision revision) {
    const std::unique_ptr<RecordedBoard> board = RecordedBoard::open(text, revision).value();
    std::vector<Fact> facts;
    const auto collect = [](Board& b, std::vector<Fact>& out) -> Task<void> {
      Datum pattern = read_one("(mode ?m)").value();
      Result<std::vector<Fact>> found = co_await b.facts(pattern);
      out = std::move(*found);
    };
    const Job job = executor.spawn(collect(*board, facts));
    executor.run_until([&] { return job.done(); });
    return facts;
  };
  EXPECT_EQ(modes_at(1).at(0).datum, read("(mode idle)"));
  const Fact ready = modes_at(2).at(0);
  EXPECT_EQ(ready.datum, read("(mode ready)"));
  EXPECT_EQ(ready.teller, "bob");
  EXPECT_EQ(ready.when, Time(20us));
  EXPECT_EQ(ready.revision, 2U);
  EXPECT_TRUE(modes_at(100).empty()) << "the torn line is left out";
}

TEST_F(Journal, ARecordedBoardCannotBeChanged) {
  VirtualExecutor executor;
  const std::unique_ptr<RecordedBoard> board =
      RecordedBoard::open("(0 0 \"a\" (declare (relation mode ((name symbol)) (key))))\n").value();
  std::string symbol;
  const auto attempt = [](Board& b, std::string& out) -> Task<void> {
    Datum fact = read_one("(mode idle)").value();
    const Result<Revision> told = co_await b.tell(fact);
    out = told.error().symbol;
  };
  const Job job = executor.spawn(attempt(*board, symbol));
  executor.run_until([&] { return job.done(); });
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
    Store store;
    EXPECT_FALSE(replay(start + line + "\n", store).has_value()) << line;
  }
}

TEST_F(Journal, DurableFactsOutliveTheBoardAndOthersDoNot) {
  {
    Life life(path_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    life.tell("(goal 1 (on a b))");
    life.tell("(goal 2 (on b c))");
    life.tell("(seen \"circle\")");
    const LeaseId lease = life.board->lease(60s).value();
    ASSERT_TRUE(life.board->take("bob", read("(goal 1 ?)"), lease).has_value());
  }
  for (int restart = 0; restart < 2; ++restart) {
    Life life(path_);
    EXPECT_EQ(life.facts("(query (goal ?n ?) (order ?n))"),
              (std::vector<Datum>{read("(goal 1 (on a b))"), read("(goal 2 (on b c))")}))
        << "what was taken by somebody who is gone is back";
    EXPECT_TRUE(life.facts("(seen ?)").empty());
  }
  Life life(path_);
  const Revision before = life.board->store().revision();
  life.tell("(goal 3 x)");
  EXPECT_EQ(life.board->store().revision(), before + 1);
}

TEST_F(Journal, ATornLastLineIsDroppedAndTheFileGoesOn) {
  {
    Life life(path_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    life.tell("(goal 1 x)");
  }
  const std::string whole = text_of(path_);
  for (const char* torn : {"(", "(9 9 \"alice\" (tell 9 (goal 9 y)))", "\xff\xff"}) {
    std::ofstream(path_, std::ios::app | std::ios::binary) << torn;
    Life life(path_);
    EXPECT_EQ(life.facts("(goal ?n ?)").size(), 1U);
    EXPECT_TRUE(text_of(path_).starts_with(whole));
    EXPECT_EQ(text_of(path_).find(torn, whole.size() + 1) == std::string::npos, std::string(torn) != "(");
  }
  Life life(path_);
  life.tell("(goal 2 y)");
  EXPECT_EQ(life.facts("(goal ?n ?)").size(), 2U);
}

TEST_F(Journal, ABrokenLineInTheMiddleIsAFailureThatNamesIt) {
  std::ofstream(path_)
      << "(0 0 \"a\" (declare (relation mode ((name symbol)) (key))))\nbroken\n(1 0 \"a\" (tell 1 (mode x)))\n";
  Store store;
  const auto opened = JournalFile::open(path_, store);
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().symbol, "bad-journal");
  EXPECT_NE(opened.error().sentence.find("line 2"), std::string::npos) << opened.error().sentence;
}

TEST_F(Journal, AFileIsKeptByOneBoardAtATime) {
  const Life life(path_);
  Store store;
  EXPECT_EQ(JournalFile::open(path_, store).error().symbol, "journal-file");
  EXPECT_EQ(JournalFile::open("/no/such/folder/journal", store).error().symbol, "journal-file");
}

TEST_F(Journal, AFileThatCannotBeWrittenSaysSoOnce) {
  Store store;
  const auto file = JournalFile::open(path_, store).value();
  int failures = 0;
  file->on_failure = [&](const Failure&) { ++failures; };
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{40, before.rlim_max};
  const auto former = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  for (int i = 1; i < 5; ++i) file->append("(1 0 \"a\" (retract 1))");
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, former);
  EXPECT_EQ(failures, 1);
}

}  // namespace
}  // namespace pizarra
