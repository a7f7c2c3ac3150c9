// A journal that fills its disk all by itself: there is a way out, and nothing that was kept is lost on it.

#include <gtest/gtest.h>
#include <set>

#include "lisp/writer.hpp"
#include "tests/blackboard/journal_fixture.hpp"
#include "tests/blackboard/small_disk.hpp"

namespace pizarra {
namespace {

using Written = journal::JournalWriter::Change;

class JournalRoomTest : public JournalFileTest {
 protected:
  void SetUp() override {
    if (!disk_.mounted()) GTEST_SKIP() << "a file system is root's to mount";
  }
  // As a server does: what there is no room for is refused.
  bool tell(Life& life, int n, std::size_t bytes) {
    if (!life.writer->check_room(Written::lasting, bytes + 512)) return false;
    life.tell(write(list("goal"_sym, n, list(++told, std::string(bytes, 'x')))));
    life.keep();
    return true;
  }
  static bool retract(Life& life, const std::string& pattern, std::size_t facts) {
    if (!life.writer->check_room(Written::removing, 512 + 32 * facts)) return false;
    EXPECT_TRUE(life.board->transact("alice", Transaction().retract(read(pattern))).has_value());
    life.keep();
    return true;
  }
  // More than one answer holds.
  static std::set<Datum> goals(const Life& life) {
    std::set<Datum> goals;
    for (const store::StandingFact& standing : life.board->store().tables().at("goal").facts()) {
      goals.insert(standing.fact.datum);
    }
    return goals;
  }
  // So many facts of 50 kB each, until no more are taken.
  int fill(Life& life, int first, int most) {
    int taken = 0;
    while (taken < most && tell(life, first + taken, 50'000)) ++taken;
    return taken;
  }

  int told = 0;  // no two facts are the same
  const SmallDisk disk_{"16m"};
  const std::string journal_ = disk_.file("board.journal");
};

TEST_F(JournalRoomTest, ThePastIsLetGoRatherThanThatTheDiskBecomesFull) {
  std::set<Datum> before;
  {
    Life life(journal_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    for (int n = 0; n < 1200; ++n) {
      ASSERT_TRUE(tell(life, n % 7, 50'000)) << n << " facts of 50 kB, seven of which stand";
      life.executor.run_for(1s);
    }
    before = goals(life);
    EXPECT_EQ(before.size(), 7U);
    ASSERT_EQ(life.writer->kept(), life.writer->position());
  }
  Life life(journal_);
  EXPECT_EQ(goals(life), before);
  const std::optional<std::int64_t> oldest = [&]() -> std::optional<std::int64_t> {
    store::Store store;
    const Result<journal::PlayedBack> played = journal::read_journal(journal_, store, {.revision = 1});
    if (played) return std::nullopt;
    EXPECT_EQ(played.error().symbol, "forgotten");
    return played.error().subject.integer();
  }();
  EXPECT_TRUE(oldest.has_value());
  EXPECT_LT(oldest.value_or(1200), 1150) << "of the past, what there is space for stays";
}

TEST_F(JournalRoomTest, OfAFullDiskFactsAreRetractedAndOthersToldInTheirPlace) {
  std::set<Datum> before;
  {
    Life life(journal_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    const int first = fill(life, 0, 400);
    ASSERT_LT(first, 400);
    ASSERT_GT(first, 40) << "most of the disk is used for facts";
    life.executor.run_for(60s);
    EXPECT_FALSE(tell(life, 1000, 50'000)) << "what stands needs its space";
    for (int round = 0; round < 5; ++round) {
      for (int n = 0; n < first / 2; ++n) {
        ASSERT_TRUE(retract(life, write(list("goal"_sym, n, "?"_sym)), 1)) << n;
      }
      life.executor.run_for(60s);
      ASSERT_GT(fill(life, 0, first / 2), first / 3) << round;
      life.executor.run_for(60s);
    }
    before = goals(life);
    ASSERT_EQ(life.writer->kept(), life.writer->position());
  }
  EXPECT_EQ(goals(Life(journal_)), before);
}

TEST_F(JournalRoomTest, ABoardBeginsOnAFullDiskAndRetracts) {
  {
    Life life(journal_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    ASSERT_LT(fill(life, 0, 400), 400);
    // As it is when the board is killed: nothing is copied or given back.
    for (const char* part : {"", "-wal", "-shm", "-reserve", "-kept"}) {
      if (!std::filesystem::exists(journal_ + part)) continue;
      std::filesystem::copy_file(journal_ + part, path_ + part);
    }
  }
  for (const char* part : {"", "-wal", "-shm", "-reserve", "-kept"}) {
    if (std::filesystem::exists(path_ + part))
      std::filesystem::copy_file(path_ + part, journal_ + part, std::filesystem::copy_options::overwrite_existing);
  }
  Life life(journal_);
  const std::size_t stood = goals(life).size();
  EXPECT_GT(stood, 40U);
  for (int n = 0; n < 20; ++n) ASSERT_TRUE(retract(life, write(list("goal"_sym, n, "?"_sym)), 1)) << n;
  life.executor.run_for(60s);
  EXPECT_TRUE(tell(life, 0, 50'000));
  EXPECT_EQ(goals(life).size(), stood - 19);
}

// Facts that need not last go into the journal as well; it must not take what a retraction needs.
TEST_F(JournalRoomTest, WhatNeedNotLastLeavesRoomForRetractions) {
  Life life(journal_);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  ASSERT_LT(fill(life, 0, 400), 400);
  for (int n = 0; n < 200; ++n) {
    if (life.writer->check_room(Written::passing, 20'512)) {
      Transaction next;
      next.retract(read("(seen ?)")).tell(list("seen"_sym, std::to_string(n) + std::string(20'000, 'y')));
      EXPECT_TRUE(life.board->transact("alice", next).has_value());
    }
    life.executor.run_for(100ms);
  }
  life.executor.run_for(60s);
  for (int n = 0; n < 20; ++n) ASSERT_TRUE(retract(life, write(list("goal"_sym, n, "?"_sym)), 1)) << n;
  life.executor.run_for(60s);
  EXPECT_TRUE(tell(life, 0, 50'000));
  EXPECT_EQ(life.writer->kept(), life.writer->position());
}

// Somebody else's files: with them gone everything goes on, without a new board.
TEST_F(JournalRoomTest, WithTheSpaceThatOthersGiveBackItGoesOn) {
  Life life(journal_);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  disk_.fill();
  const int stood = fill(life, 0, 400);
  ASSERT_LT(stood, 400);
  disk_.clear();
  life.executor.run_for(1s);
  EXPECT_TRUE(tell(life, stood, 50'000));
  EXPECT_EQ(goals(life).size(), static_cast<std::size_t>(stood) + 1);
}

}  // namespace
}  // namespace pizarra
