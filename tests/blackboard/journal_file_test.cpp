#include "blackboard/journal/journal_file.hpp"

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "lisp/writer.hpp"
#include "tests/blackboard/journal_fixture.hpp"

namespace pizarra {
namespace {

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
  const auto live = [&](const journal::History& history) {
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
  for (const journal::History& history : {journal::History{}, journal::History{.revisions = 0}}) {
    live(history);
    EXPECT_EQ(facts_at({.revision = 1}, "(goal ?n ?)").is_symbol("forgotten"), history.revisions == 0);
    for (int restart = 0; restart < 2; ++restart) {
      EXPECT_EQ(
          Life(path_).facts("(query (goal ?n ?) (order ?n))"),
          (std::vector<Datum>{read("(goal 3 freed-later)"), read("(goal 4 free)"), read("(goal 5 freed-at-once)")}));
    }
    journal::remove_journal(path_);
  }
}

// A revision that the journal has let go cannot be told from an empty one any more.
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
  const auto live = [&](const journal::History& history) {
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
  for (const journal::History& history : {journal::History{}, journal::History{.revisions = 0}}) {
    live(history);
    EXPECT_EQ(Life(path_).facts("(goal ?n ?)"), std::vector<Datum>{read("(goal 4 free)")});
    journal::remove_journal(path_);
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
  EXPECT_EQ(journal::JournalFile::open(path_, {}).error().symbol, "journal-file");
  EXPECT_EQ(journal::JournalFile::open("/no/such/folder/journal", {}).error().symbol, "journal-file");
  EXPECT_EQ(facts_at({}, "(goal ?n ?)"), read("((goal 1 x))"));
}

// Whether SQLite has its lock on the file, by which another program knows that it is not the last one to close it. That
// program would otherwise remove the log. `file` is another descriptor of it.
bool is_locked(int file) {
  constexpr off_t shared_bytes = 0x40000002;
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = shared_bytes;
  lock.l_len = 510;
  EXPECT_EQ(fcntl(file, F_OFD_GETLK, &lock), 0);
  return lock.l_type != F_UNLCK;
}

TEST_F(JournalFileTest, AProcessThatReadsItsOwnJournalKeepsItLocked) {
  int file = -1;
  {
    Life life(path_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    life.tell("(goal 1 x)");
    life.keep();
    file = ::open(path_.c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(file, 0);
    EXPECT_TRUE(is_locked(file));
    EXPECT_TRUE(journal::end_of_journal(path_).has_value());
    EXPECT_EQ(facts_at({}, "(goal ?n ?)"), read("((goal 1 x))"));
    EXPECT_TRUE(is_locked(file));
  }
  EXPECT_FALSE(is_locked(file));
  ::close(file);
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

TEST_F(JournalFileTest, OfALongPastNoMoreBytesAreKeptThanItMayHave) {
  {
    Life life(path_, {.bytes = 4 << 20});
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    for (int n = 1; n <= 400; ++n) {
      life.tell(write(list("goal"_sym, n % 7, list(n, std::string(100'000, 'x')))));
      life.keep();
      life.executor.run_for(5s);
    }
  }
  EXPECT_EQ(facts_at({.revision = 300}, "(goal ?n ?)"), "forgotten"_sym);
  EXPECT_EQ(facts_at({.revision = 380}, "(goal ?n ?)").size(), 7U);
  EXPECT_LT(std::filesystem::file_size(path_), 8'000'000U) << "40 MB were told";
  Life less(path_, {.bytes = 1 << 20});
  less.executor.run_for(3000s);
  less.tell("(goal 1 x)");
  less.executor.run_for(60s);
  EXPECT_EQ(facts_at({.revision = 380}, "(goal ?n ?)"), "forgotten"_sym) << "with less space than before";
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
  EXPECT_EQ(life.remembered.front().request, 45U);
  EXPECT_EQ(life.remembered.front().teller, "ali\"ce");
  EXPECT_EQ(life.remembered.front().result, read("(ok 45)"));
  EXPECT_EQ(life.remembered.back().request, 300U);
}

TEST(RememberedReplies, ThoseOfASessionShareALineThatHasABound) {
  std::string text;
  journal::ReplyLines lines;
  std::vector<journal::RememberedReply> all;
  for (std::uint64_t n = 1; n <= 12; ++n) {
    const std::uint64_t session = n < 10 ? 7 : 8;
    all.push_back({session, "ali\"ce", n, list("ok"_sym, std::string(n < 4 ? 30'000 : 3, 'x')), n < 10 ? "" : "key"});
    lines.add(text, all.back());
  }
  EXPECT_EQ(std::ranges::count(text, '\n'), 3);
  const std::vector<journal::RememberedReply> read = journal::replies_from(text).value();
  ASSERT_EQ(read.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(read[i].session, all[i].session);
    EXPECT_EQ(read[i].teller, all[i].teller);
    EXPECT_EQ(read[i].request, all[i].request);
    EXPECT_EQ(read[i].result, all[i].result);
    EXPECT_EQ(read[i].key, all[i].key);
  }
}

TEST(RememberedReplies, ThoseOfFormerFilesAreReadAndDamagedOnesAreNot) {
  const std::vector<journal::RememberedReply> read =
      journal::replies_from("(7 \"alice\" 1 (ok 5))\n(8 \"bob\" 2 (ok 6) \"key\")\n").value();
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].request, 1U);
  EXPECT_EQ(read[0].key, "");
  EXPECT_EQ(read[1].result, pizarra::read("(ok 6)"));
  EXPECT_EQ(read[1].key, "key");
  for (const char* damaged :
       {"(7 \"alice\")\n", "(7 alice 1 (ok 5))\n", "(-7 \"alice\" 1 (ok 5))\n", "(7 \"alice\" \"\" 1)\n",
        "(7 \"alice\" \"\" 1 (ok 5) 2)\n", "(7 \"alice\" \"\" -1 (ok 5))\n", "(7 \"alice\"\n", "7\n"}) {
    EXPECT_FALSE(journal::replies_from(damaged).has_value()) << damaged;
  }
}

TEST_F(JournalFileTest, AFolderIsNoJournal) {
  EXPECT_EQ(journal::end_of_journal(folder_.string()).error().symbol, "journal-file");
  store::Store store;
  EXPECT_EQ(journal::read_journal(folder_.string(), store).error().symbol, "journal-file");
  EXPECT_EQ(journal::JournalFile::open(folder_.string(), {}).error().symbol, "journal-file");
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
  EXPECT_EQ(life.writer->check_room(journal::JournalWriter::Change::lasting, 100).error().symbol, "journal-full");
  EXPECT_TRUE(life.writer->check_room(journal::JournalWriter::Change::passing, 100).has_value());
  EXPECT_EQ(life.facts("(goal ? ?)").size(), 2U) << "reading goes on";
  life.executor.run_for(2s);
  EXPECT_TRUE(life.writer->stuck());
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, former);
  life.executor.run_for(300ms);
  EXPECT_FALSE(life.writer->stuck());
  EXPECT_TRUE(life.writer->check_room(journal::JournalWriter::Change::lasting, 100).has_value());
  EXPECT_EQ(life.writer->kept(), life.writer->position());
  EXPECT_EQ(news, (std::vector<std::string>{"journal-full", "well"}));
  EXPECT_EQ(facts_at({}, "(goal ? ?)"), read("((goal 1 x) (goal 2 x))"));
}

TEST_F(JournalFileTest, WhileItIsNotWhereItWasWhatIsDurableIsRefusedAndNothingIsTakenForWritten) {
  const std::filesystem::path aside = folder_.string() + "-aside";
  const auto away = [&] { std::filesystem::rename(folder_, aside); };
  const auto back = [&] { std::filesystem::rename(aside, folder_); };
  const auto away_and_another = [&] {
    away();
    std::filesystem::create_directory(folder_);
    std::ofstream(path_) << "another";
  };
  const auto back_for_another = [&] {
    std::filesystem::remove_all(folder_);
    back();
  };
  const std::string log = path_ + "-wal";
  const auto log_away = [&] { std::filesystem::rename(log, log + "-aside"); };
  const auto log_back = [&] { std::filesystem::rename(log + "-aside", log); };
  const auto cut_log = [&] {
    std::filesystem::copy_file(log, log + "-whole");
    std::filesystem::resize_file(log, 0);
  };
  const auto whole_log = [&] {
    std::filesystem::copy_file(log + "-whole", log, std::filesystem::copy_options::overwrite_existing);
  };
  using Act = std::function<void()>;
  const std::vector<std::pair<Act, Act>> ways = {
      {away, back}, {away_and_another, back_for_another}, {log_away, log_back}, {cut_log, whole_log}};
  Life life(path_);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  std::vector<std::string> news;
  life.writer->on_failure = [&](const std::optional<Failure>& f) { news.push_back(f ? f->symbol : "well"); };
  std::size_t told = 0;
  for (const auto& [go, come] : ways) {
    life.tell("(goal " + std::to_string(++told) + " x)");
    life.keep();
    ASSERT_EQ(life.writer->kept(), life.writer->position());
    go();
    life.tell("(goal " + std::to_string(++told) + " x)");
    life.keep();
    EXPECT_LT(life.writer->kept(), life.writer->position());
    EXPECT_TRUE(life.writer->stuck());
    life.executor.run_for(2s);
    const Result<void> room = life.writer->check_room(journal::JournalWriter::Change::lasting, 100);
    ASSERT_FALSE(room.has_value());
    EXPECT_EQ(room.error().symbol, "journal-full");
    EXPECT_NE(room.error().sentence.find("end the board in order (SIGTERM, Ctrl-C)"), std::string::npos)
        << room.error().sentence;
    EXPECT_EQ(life.facts("(goal ? ?)").size(), told) << "reading goes on";
    come();
    life.executor.run_for(300ms);
    EXPECT_EQ(life.writer->kept(), life.writer->position());
    EXPECT_TRUE(life.writer->check_room(journal::JournalWriter::Change::lasting, 100).has_value());
  }
  std::vector<std::string> expected;
  for (std::size_t i = 0; i < ways.size(); ++i) expected.insert(expected.end(), {"journal-full", "well"});
  EXPECT_EQ(news, expected);
  EXPECT_EQ(facts_at({}, "(goal ? ?)").size(), told);
}

TEST_F(JournalFileTest, ABoardThatEndsInOrderWithoutItsLogHasWrittenItBack) {
  {
    Life life(path_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    life.tell("(goal 1 x)");
    life.keep();
    std::filesystem::remove(path_ + "-wal");
  }
  EXPECT_EQ(facts_at({}, "(goal ? ?)").size(), 1U);
}

}  // namespace
}  // namespace pizarra
