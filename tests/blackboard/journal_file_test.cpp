#include "blackboard/journal/journal_file.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

class JournalFileTest : public testing::Test {
 protected:
  JournalFileTest()
      : folder_(memory_or_disk() / ("pizarra-journal-file-" + std::to_string(getpid()))),
        path_((folder_ / "cell.journal").string()) {
    std::filesystem::create_directory(folder_);
  }
  // A disk is slow to say that it has everything; few tests are about that.
  static std::filesystem::path memory_or_disk() {
    const std::filesystem::path memory = "/dev/shm";
    return std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
  }
  ~JournalFileTest() override { std::filesystem::remove_all(folder_); }

  // One life of a board that keeps its journal in the file.
  struct Life {
    explicit Life(const std::string& path, const History& history = {}) {
      auto store = std::make_unique<Store>();
      file = JournalFile::open(path, history).value();
      remembered = file->recover(*store).value();
      writer = std::make_unique<JournalWriter>(executor, file);
      board = std::make_unique<MemoryBoard>(executor, std::move(store));
      board->set_journal([this](std::string_view line) { writer->append(line); });
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
    // Until everything is written.
    void keep() {
      writer->keep();
      executor.run_for(1ms);
    }
    VirtualExecutor executor;
    std::shared_ptr<JournalFile> file;
    std::vector<RememberedReply> remembered;
    std::unique_ptr<JournalWriter> writer;
    std::unique_ptr<MemoryBoard> board;
  };

  Datum facts_at(const Moment& until, const std::string& pattern) {
    Store store;
    const Result<PlayedBack> later = read_journal(path_, store, until);
    if (!later) return Datum::symbol(later.error().symbol);
    std::vector<Datum> facts;
    const Result<Answers> answers = store.ask(query(pattern));
    for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front().datum);
    return Datum::list(std::move(facts));
  }

  const std::filesystem::path folder_;
  const std::string path_;
  const std::vector<Relation> relations_ = {relation("(relation goal ((n integer) (what datum)) (key n) (durable))"),
                                            relation("(relation seen ((name string)))")};
};

TEST_F(JournalFileTest, DurableFactsOutliveTheBoardAndOthersDoNot) {
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

// No lease outlives the board that gave it, and what stood under one is not to outlive it either.
TEST_F(JournalFileTest, DurableFactsUnderALeaseGoWithIt) {
  const auto live = [&](const History& history) {
    Life life(path_, history);
    EXPECT_TRUE(life.board->declare("alice", relations_).has_value());
    const LeaseId lease = life.board->lease(3600s).value();
    Transaction transaction;
    transaction.tell(read("(goal 1 told-under-it)"), {}, lease).tell(read("(goal 2 bound-later)"));
    transaction.tell(read("(goal 3 freed-later)"), {}, lease).tell(read("(goal 4 free)"));
    transaction.tell(read("(goal 5 freed-at-once)"), {}, lease).tell(read("(goal 5 freed-at-once)"));
    transaction.tell(read("(goal 6 because)"), {1}, lease);
    EXPECT_TRUE(life.board->transact("alice", transaction).has_value());
    Transaction again;
    again.tell(read("(goal 2 bound-later)"), {}, lease).tell(read("(goal 3 freed-later)"));
    EXPECT_TRUE(life.board->transact("alice", again).has_value());
    EXPECT_EQ(life.facts("(goal ? ?)").size(), 6U);
    if (history.revisions > 0) return;
    // So that the horizon passes them.
    for (int n = 0; n < 200; ++n) {
      life.tell(write(list("goal"_sym, 7, list(n, std::string(3000, 'x')))));
      life.executor.run_for(1s);
    }
    EXPECT_TRUE(life.board->transact("alice", Transaction().retract(read("(goal 7 ?)"))).has_value());
  };
  for (const History& history : {History{}, History{.revisions = 0}}) {
    live(history);
    EXPECT_EQ(facts_at({.revision = 1}, "(goal ?n ?)").is_symbol("forgotten"), history.revisions == 0);
    for (int restart = 0; restart < 2; ++restart) {
      EXPECT_EQ(
          Life(path_).facts("(query (goal ?n ?) (order ?n))"),
          (std::vector<Datum>{read("(goal 3 freed-later)"), read("(goal 4 free)"), read("(goal 5 freed-at-once)")}));
    }
    remove_journal(path_);
  }
}

// What the journal has let go can be told from nothing no more.
TEST_F(JournalFileTest, WhatCompactionForgotDoesNotPassForUnchanged) {
  Revision seen = 0;
  {
    Life life(path_, {.revisions = 1});
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    life.tell("(goal 1 x)");
    seen = life.board->store().revision();
    ASSERT_TRUE(life.board->transact("alice", Transaction().retract(read("(goal 1 ?)"))).has_value());
    for (int n = 0; n < 200; ++n) {
      life.tell(write(list("goal"_sym, 7, list(n, std::string(3000, 'x')))));
      life.executor.run_for(1s);
    }
  }
  Life life(path_, {.revisions = 1});
  const auto told_if_unchanged = [&](const std::string& fact, Revision since) {
    Transaction transaction;
    transaction.require(Transaction::Unchanged{read(fact), since}).tell(read(fact));
    const Result<Revision> told = life.board->transact("alice", transaction);
    return told ? "ok" : told.error().symbol;
  };
  EXPECT_EQ(told_if_unchanged("(goal 1 x)", seen), "precondition-failed");
  EXPECT_EQ(told_if_unchanged("(goal 1 x)", life.board->store().revision()), "ok");
}

// A fact that was taken still goes with the lease that it was told under.
TEST_F(JournalFileTest, ADurableFactThatWasTakenGoesWithTheLeaseItWasToldUnder) {
  const auto live = [&](const History& history) {
    Life life(path_, history);
    EXPECT_TRUE(life.board->declare("alice", relations_).has_value());
    const LeaseId told = life.board->lease(3600s).value();
    Transaction transaction;
    for (const char* fact : {"(goal 1 held)", "(goal 2 standing)", "(goal 3 returned)"}) {
      transaction.tell(read(fact), {}, told);
    }
    EXPECT_TRUE(life.board->transact("alice", transaction.tell(read("(goal 4 free)"))).has_value());
    const LeaseId released = life.board->lease(3600s).value();
    EXPECT_TRUE(life.board->take("bob", read("(goal 3 ?)"), released).has_value());
    if (history.revisions == 0) {
      for (int n = 0; n < 100; ++n) {
        life.tell(write(list("goal"_sym, 7, list(n, std::string(3000, 'x')))));
        life.executor.run_for(1s);
      }
    }
    EXPECT_TRUE(life.board->release(released).has_value());
    EXPECT_EQ(life.facts("(goal 3 ?)").size(), 1U);
    const LeaseId holder = life.board->lease(3600s).value();
    EXPECT_TRUE(life.board->take("bob", read("(goal 1 ?)"), holder).has_value());
    EXPECT_TRUE(life.board->take("bob", read("(goal 4 ?)"), holder).has_value());
    if (history.revisions > 0) return;
    for (int n = 0; n < 200; ++n) {
      life.tell(write(list("goal"_sym, 7, list(n, std::string(3000, 'x')))));
      life.executor.run_for(1s);
    }
    EXPECT_TRUE(life.board->transact("alice", Transaction().retract(read("(goal 7 ?)"))).has_value());
  };
  for (const History& history : {History{}, History{.revisions = 0}}) {
    live(history);
    EXPECT_EQ(Life(path_).facts("(goal ?n ?)"), std::vector<Datum>{read("(goal 4 free)")});
    remove_journal(path_);
  }
}

TEST_F(JournalFileTest, WhatIsWaitedForIsWrittenInOneGroupAndWhatIsNotSoonAfter) {
  Life life(path_);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  life.keep();
  for (int n = 0; n < 64; ++n) {
    life.tell(write(list("goal"_sym, n, "x"_sym)));
    life.writer->keep();
  }
  EXPECT_LT(life.writer->kept(), life.writer->position());
  life.executor.run_for(1ms);
  EXPECT_EQ(life.writer->kept(), life.writer->position());
  life.tell("(seen \"circle\")");
  life.executor.run_for(1ms);
  EXPECT_LT(life.writer->kept(), life.writer->position());
  life.executor.run_for(100ms);
  EXPECT_EQ(life.writer->kept(), life.writer->position());
}

TEST_F(JournalFileTest, AFileIsKeptByOneBoardAtATimeAndReadByOthersMeanwhile) {
  Life life(path_);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  life.tell("(goal 1 x)");
  life.keep();
  EXPECT_EQ(JournalFile::open(path_, {}).error().symbol, "journal-file");
  EXPECT_EQ(JournalFile::open("/no/such/folder/journal", {}).error().symbol, "journal-file");
  EXPECT_EQ(facts_at({}, "(goal ?n ?)"), read("((goal 1 x))"));
}

TEST_F(JournalFileTest, ThePastIsAsItWasAndWhatTheHorizonPassedIsForgotten) {
  Life life(path_, {.revisions = 100});
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  const std::string padding(3000, 'x');
  for (int n = 1; n <= 1000; ++n) {
    life.tell(write(list("goal"_sym, n % 7, list(n, padding))));
    life.executor.run_for(1s);
    if (n % 10 == 0) life.keep();
  }
  EXPECT_EQ(facts_at({.revision = 1}, "(goal ?n ?)"), "forgotten"_sym);
  EXPECT_EQ(facts_at({.time = Time(1s)}, "(goal ?n ?)"), "forgotten"_sym);
  for (const int then : {900, 950, 1000}) {
    const Datum facts = facts_at({.revision = static_cast<Revision>(then)}, "(query (goal ?n ?what) (order ?n))");
    ASSERT_EQ(facts.size(), 7U) << then;
    for (int n = 0; n < 7; ++n) EXPECT_EQ(facts[n][2][0].integer(), then - (then - n) % 7);
  }
  EXPECT_EQ(facts_at({.time = Time(950s)}, "(goal 5 (?n ?))"), facts_at({.revision = 950}, "(goal 5 (?n ?))"));
  EXPECT_LT(std::filesystem::file_size(path_), 2'000'000U) << "3 MB were told";
  const std::vector<Datum> before = life.facts("(goal ? ?)");
  life.board.reset();
  life.writer.reset();
  life.file.reset();
  EXPECT_EQ(Life(path_).facts("(goal ? ?)"), before);
}

TEST_F(JournalFileTest, RepliesAreRememberedInTheNextLife) {
  {
    Life life(path_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    for (std::uint64_t n = 1; n <= 300; ++n) {
      life.tell(write(list("goal"_sym, n, "x"_sym)));
      life.writer->remember({7, "ali\"ce", n, list("ok"_sym, n)});
      if (n % 50 == 0) life.keep();
    }
  }
  const Life life(path_);
  ASSERT_EQ(life.remembered.size(), 256U);
  EXPECT_EQ(life.remembered.front().request, 300U);
  EXPECT_EQ(life.remembered.front().teller, "ali\"ce");
  EXPECT_EQ(life.remembered.front().result, read("(ok 300)"));
  EXPECT_EQ(life.remembered.back().request, 45U);
}

TEST_F(JournalFileTest, WhatIsNoJournalIsRefusedByName) {
  for (const std::string& text : {std::string("hello"), std::string(5000, 'x'), std::string("SQLite format 3\0", 16)}) {
    std::ofstream(path_, std::ios::binary) << text;
    const auto opened = JournalFile::open(path_, {});
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().symbol, "bad-journal") << opened.error().sentence;
    EXPECT_NE(opened.error().sentence.find(path_), std::string::npos) << opened.error().sentence;
  }
}

// A board that was killed leaves its file and SQLite's beside it as they are; damage must not pass for less.
TEST_F(JournalFileTest, DamageIsAFailureAndNeverAWrongBoard) {
  constexpr std::uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::vector<Datum> expected;
  {
    Life life(path_, {.revisions = 50});
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    for (int n = 1; n <= 400; ++n) {
      life.tell(write(list("goal"_sym, n % 100, list(n, std::string(1500, 'y')))));
      life.executor.run_for(1s);
    }
    expected = life.facts("(goal ? ?)");
  }
  std::ifstream in(path_, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  Random random(seed);
  int found = 0;
  for (int round = 0; round < 120; ++round) {
    std::string text = whole;
    if (round % 3 == 0) {
      text.resize(random.below(text.size()));
    } else {
      for (int n = 0; n < 8; ++n) text[random.below(text.size())] ^= static_cast<char>(1 + random.below(255));
    }
    std::ofstream(path_, std::ios::binary) << text;
    std::filesystem::remove(path_ + "-wal");
    std::filesystem::remove(path_ + "-shm");
    Store store;
    const auto file = JournalFile::open(path_, {});
    const auto recovered = file ? (*file)->recover(store) : fail(file.error());
    if (!recovered) {
      ++found;
      EXPECT_TRUE(recovered.error().symbol == "bad-journal" || recovered.error().symbol == "journal-file")
          << recovered.error().symbol << ": " << recovered.error().sentence;
      continue;
    }
    if (store.tables().empty() && text.empty()) continue;
    std::vector<Datum> facts;
    const Result<Answers> answers = store.ask(query("(goal ? ?)"));
    ASSERT_TRUE(answers.has_value()) << "round " << round;
    for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front().datum);
    EXPECT_EQ(facts, expected) << "round " << round;
  }
  EXPECT_GT(found, 60) << "most damage meets something";
}

// SQLite takes the first damaged page of its log for the end of it.
TEST_F(JournalFileTest, DamageWithinWhatWasKeptIsSaidAndNothingBehindItDroppedSilently) {
  constexpr std::uint64_t seed = 6;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::string copy = (folder_ / "copy.journal").string();
  Life life(path_);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  for (int n = 1; n <= 100; ++n) {
    life.tell(write(list("goal"_sym, n, std::string(500, 'y'))));
    life.keep();
  }
  const auto restart_with = [&](const std::string& log) {
    remove_journal(copy);
    for (const char* part : {"", "-kept"}) std::filesystem::copy_file(path_ + part, copy + part);
    std::ofstream(copy + "-wal", std::ios::binary) << log;
    return JournalFile::open(copy, {});
  };
  std::ifstream in(path_ + "-wal", std::ios::binary);
  const std::string log((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  ASSERT_GT(log.size(), 100'000U);
  EXPECT_TRUE(restart_with(log).has_value()) << "killed, it goes on";
  Random random(seed);
  for (int round = 0; round < 30; ++round) {
    std::string damaged = log;
    damaged[random.below(damaged.size() * 9 / 10)] ^= static_cast<char>(1U << random.below(8));
    const auto opened = restart_with(damaged);
    // What SQLite never reads, the counters of the header, may be anything.
    if (opened && (*opened)->append({"(1000 1 \"a\" (retract 1))\n", "", true})) continue;
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().symbol, "bad-journal");
    EXPECT_NE(opened.error().sentence.find("up to entry 1"), std::string::npos) << opened.error().sentence;
    Store store;
    EXPECT_EQ(read_journal(copy, store).error().symbol, "bad-journal");
    // Who would rather have less than nothing says so.
    std::filesystem::remove(copy + "-kept");
    EXPECT_TRUE(JournalFile::open(copy, {}).has_value());
  }
}

TEST_F(JournalFileTest, WhatIsLeftOfAJournalWhoseFileIsGoneIsNotBegunAnew) {
  {
    Life life(path_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    life.tell("(goal 1 x)");
    life.keep();
    // As a crash leaves it.
    for (const char* part : {"-wal", "-kept"}) std::filesystem::copy_file(path_ + part, path_ + "2" + part);
  }
  const std::string gone = path_ + "2";
  for (const char* part : {"-wal", "-kept"}) {
    const auto opened = JournalFile::open(gone, {});
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().symbol, "bad-journal");
    EXPECT_NE(opened.error().sentence.find(gone + part), std::string::npos) << opened.error().sentence;
    EXPECT_FALSE(std::filesystem::exists(gone));
    EXPECT_TRUE(std::filesystem::exists(gone + part));
    std::filesystem::remove(gone + part);
  }
  EXPECT_TRUE(JournalFile::open(gone, {}).has_value());
}

TEST_F(JournalFileTest, AFolderIsNoJournal) {
  EXPECT_EQ(end_of_journal(folder_.string()).error().symbol, "journal-file");
  Store store;
  EXPECT_EQ(read_journal(folder_.string(), store).error().symbol, "journal-file");
  EXPECT_EQ(JournalFile::open(folder_.string(), {}).error().symbol, "journal-file");
}

TEST_F(JournalFileTest, WhenTheFileMayNotGrowWhatIsDurableIsRefusedAndLaterWritten) {
  Life life(path_);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  life.tell("(goal 1 x)");
  life.keep();
  std::vector<std::string> news;
  life.writer->on_failure = [&](const std::optional<Failure>& f) { news.push_back(f ? f->symbol : "well"); };
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{4096, before.rlim_max};
  const auto former = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  life.tell("(goal 2 x)");
  life.keep();
  EXPECT_TRUE(life.writer->stuck());
  EXPECT_EQ(life.writer->check_room(true).error().symbol, "journal-full");
  EXPECT_TRUE(life.writer->check_room(false).has_value());
  EXPECT_EQ(life.facts("(goal ? ?)").size(), 2U) << "reading goes on";
  life.executor.run_for(2s);
  EXPECT_TRUE(life.writer->stuck());
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, former);
  life.executor.run_for(300ms);
  EXPECT_FALSE(life.writer->stuck());
  EXPECT_TRUE(life.writer->check_room(true).has_value());
  EXPECT_EQ(life.writer->kept(), life.writer->position());
  EXPECT_EQ(news, (std::vector<std::string>{"journal-full", "well"}));
  EXPECT_EQ(facts_at({}, "(goal ? ?)"), read("((goal 1 x) (goal 2 x))"));
}

}  // namespace
}  // namespace pizarra
