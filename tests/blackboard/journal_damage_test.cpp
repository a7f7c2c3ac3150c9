// A file that is damaged, torn or no journal at all is refused by name, and never passes for less or for something
// else.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "blackboard/journal/journal_tables.hpp"
#include "blackboard/journal/sqlite.hpp"
#include "blackboard/time/random.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/journal_fixture.hpp"
#include "tests/whole_file.hpp"

namespace pizarra {
namespace {

class JournalDamageTest : public JournalFileTest {
 protected:
  // A journal whose horizon has moved on: relations and facts stand in their tables.
  std::vector<Datum> keep_a_past() {
    Life life(path_, {.revisions = 50});
    EXPECT_TRUE(life.board->declare("alice", relations_).has_value());
    for (int n = 1; n <= 400; ++n) {
      life.tell(write(list("goal"_sym, n % 100, list(n, std::string(1500, 'y')))));
      life.executor.run_for(1s);
    }
    return life.facts("(goal ? ?)");
  }
  std::string contents() const { return whole_file(path_); }
  // A board's view of a file with this content.
  Result<void> recover(const std::string& text, store::Store& store) const {
    std::ofstream(path_, std::ios::binary) << text;
    for (const char* part : {"-wal", "-shm"}) std::filesystem::remove(path_ + part);
    const auto file = journal::JournalFile::open(path_, {});
    if (!file) return fail(file.error());
    const auto recovered = (*file)->recover(store);
    if (!recovered) return fail(recovered.error());
    return {};
  }
  // Behind the board's back.
  void change(const std::string& sql) const {
    journal::sqlite::Database database = journal::sqlite::Database::open(path_, journal::sqlite::Access::write).value();
    ASSERT_TRUE(database.run(sql.c_str()).has_value()) << database.failure().sentence;
  }
  // As it was before heads had a sum, before they told of all facts and of what is forgotten, or before groups had
  // the sum they have.
  void make_format(int format) const {
    give_groups_their_former_sum();
    if (format == 3) return change("PRAGMA user_version = 3");
    change("DELETE FROM about WHERE name IN ('sum', 'facts', 'forgotten'); PRAGMA user_version = " +
           std::to_string(format));
    if (format == 1) return;
    journal::sqlite::Database database = journal::sqlite::Database::open(path_, journal::sqlite::Access::write).value();
    ASSERT_TRUE(journal::journal_tables::seal_head(database).has_value());
  }
  void give_groups_their_former_sum() const {
    journal::sqlite::Database database = journal::sqlite::Database::open(path_, journal::sqlite::Access::write).value();
    std::vector<std::pair<std::int64_t, std::int64_t>> sums;
    journal::sqlite::Statement groups(database, "SELECT number, lines, replies FROM log");
    while (groups.step().value()) {
      const std::int64_t number = groups.integer(0);
      sums.emplace_back(number, journal::journal_tables::former_sum_of_group(number, groups.text(1), groups.text(2)));
    }
    journal::sqlite::Statement update(database, "UPDATE log SET sum = ? WHERE number = ?");
    for (const auto& [number, sum] : sums) ASSERT_TRUE(update.bind(1, sum).bind(2, number).run().has_value());
  }
  static std::vector<Datum> facts_of(const store::Store& store) {
    std::vector<Datum> facts;
    const Result<Answers> answers = store.ask(query("(goal ? ?)"));
    if (!answers) return {};
    for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front().datum);
    return facts;
  }
};

// Every bit of the first row that begins so, wherever SQLite has kept it.
TEST_F(JournalDamageTest, ABitThatFlipsWhereItBeginsOrInARelationIsNoticed) {
  const std::vector<Datum> expected = keep_a_past();
  const std::string whole = contents();
  store::Store sound;
  ASSERT_TRUE(recover(whole, sound).has_value());
  constexpr std::size_t time_bytes = 4;  // of 350 s in microseconds
  const std::vector<std::pair<std::string, std::size_t>> rows = {
      {"(relation goal ((n integer)", 0}, {"(relation seen ((name", 0}, {"horizon-time", time_bytes}, {"next-fact", 2}};
  for (const auto& [row, more] : rows) {
    const std::size_t begin = whole.find(row);
    ASSERT_NE(begin, std::string::npos) << row;
    int refused = 0;
    const std::size_t bits = 8 * (row.size() + more);
    for (std::size_t bit = 0; bit < bits; ++bit) {
      std::string damaged = whole;
      damaged[begin + bit / 8] = static_cast<char>(damaged[begin + bit / 8] ^ (1 << bit % 8));
      store::Store store;
      const Result<void> recovered = recover(damaged, store);
      if (recovered) {
        ADD_FAILURE() << "bit " << bit << " of " << row << " went unnoticed";
        break;
      }
      refused += recovered.error().symbol == "bad-journal" ? 1 : 0;
      ASSERT_NE(recovered.error().sentence.find(path_), std::string::npos) << recovered.error().sentence;
    }
    EXPECT_EQ(refused, static_cast<int>(bits)) << row;
  }
  EXPECT_EQ(facts_of(sound), expected);
}

TEST_F(JournalDamageTest, AMomentThatAnEntryDoesNotEndAtIsNoticed) {
  {
    Life life(path_);
    ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
    life.tell("(goal 1 x)");
    life.keep();
  }
  for (const char* column : {"revision", "time"}) {
    journal::sqlite::Database database = journal::sqlite::Database::open(path_, journal::sqlite::Access::write).value();
    const std::string change = std::string("UPDATE log SET ") + column + " = " + column;
    ASSERT_TRUE(database.run((change + " + 1").c_str()).has_value());
    store::Store store;
    EXPECT_EQ(journal::read_journal(path_, store).error().symbol, "bad-journal") << column;
    ASSERT_TRUE(database.run((change + " - 1").c_str()).has_value());
  }
  store::Store store;
  EXPECT_TRUE(journal::read_journal(path_, store).has_value());
}

TEST_F(JournalDamageTest, AJournalOfAFormerFormatIsTakenAsItIsAndHasItsSumsFromThenOn) {
  const std::vector<Datum> expected = keep_a_past();
  const std::string whole = contents();
  for (const int format : {1, 2, 3}) {
    SCOPED_TRACE("format " + std::to_string(format));
    std::filesystem::remove(path_ + "-kept");
    std::ofstream(path_, std::ios::binary) << whole;
    make_format(format);
    store::Store read_only;
    EXPECT_TRUE(journal::read_journal(path_, read_only).has_value());
    EXPECT_EQ(Life(path_).facts("(goal ? ?)"), expected);
    const std::string anew = contents();
    std::string damaged = anew;
    damaged[damaged.find("(relation goal ((n integer)") + 1] ^= 1;
    store::Store store;
    EXPECT_EQ(recover(damaged, store).error().symbol, "bad-journal");
    std::ofstream(path_, std::ios::binary) << anew;
    change("DELETE FROM facts WHERE id = (SELECT max(id) FROM facts)");
    EXPECT_EQ(recover(contents(), store).error().symbol, "bad-journal");
  }
}

TEST_F(JournalDamageTest, AJournalOfALaterFormatIsRefused) {
  keep_a_past();
  change("PRAGMA user_version = 5");
  const auto opened = journal::JournalFile::open(path_, {});
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().symbol, "bad-journal");
  EXPECT_NE(opened.error().sentence.find("another format, 5"), std::string::npos) << opened.error().sentence;
}

TEST_F(JournalDamageTest, ARowThatIsMissingIsNoticed) {
  keep_a_past();
  const std::string whole = contents();
  for (const char* some :
       {"facts WHERE id = (SELECT min(id) FROM facts)", "facts WHERE id = (SELECT max(id) FROM facts)", "facts",
        "log WHERE number = (SELECT min(number) FROM log)", "log WHERE number = (SELECT max(number) - 1 FROM log)"}) {
    std::ofstream(path_, std::ios::binary) << whole;
    change(std::string("DELETE FROM ") + some);
    store::Store store;
    EXPECT_EQ(journal::read_journal(path_, store).error().symbol, "bad-journal") << some;
  }
}

TEST_F(JournalDamageTest, WhenTheHorizonMovesAFactThatIsMissingIsNotForgotten) {
  keep_a_past();
  change("DELETE FROM facts");
  const std::shared_ptr<journal::JournalFile> file = journal::JournalFile::open(path_, {.revisions = 1}).value();
  const Result<std::size_t> compacted = file->compact(Time(86400s));
  ASSERT_FALSE(compacted.has_value());
  EXPECT_EQ(compacted.error().symbol, "bad-journal");
  EXPECT_NE(compacted.error().sentence.find("is missing"), std::string::npos) << compacted.error().sentence;
}

// The horizon must not take up what it cannot trust, nor stumble over what a fact may be.
TEST_F(JournalDamageTest, AFactOfManyElementsThatWasTakenPassesTheHorizon) {
  const journal::History history{.revisions = 1};
  Life life(path_, history);
  ASSERT_TRUE(life.board->declare("alice", relations_).has_value());
  Transaction large;
  large.tell(list("goal"_sym, 1, Datum::list(std::vector<Datum>(150'000, "x"_sym))));
  ASSERT_TRUE(life.board->transact("alice", large).has_value());
  const auto pass_the_horizon = [&] {
    for (int n = 0; n < 200; ++n) {
      life.tell(write(list("goal"_sym, 7, list(n, std::string(3000, 'x')))));
      life.executor.run_for(1s);
    }
  };
  pass_the_horizon();
  const LeaseId lease = life.board->lease(86400s).value();
  ASSERT_TRUE(life.board->take("bob", read("(goal 1 ?)"), lease).has_value());
  const Revision taken = life.board->store().revision();
  pass_the_horizon();
  EXPECT_FALSE(life.writer->failure().has_value());
  EXPECT_TRUE(facts_at({.revision = taken}, "(goal ?n ?)").is_symbol("forgotten"));
}

TEST_F(JournalDamageTest, WhatIsNoJournalIsRefusedByName) {
  for (const std::string& text : {std::string("hello"), std::string(5000, 'x'), std::string("SQLite format 3\0", 16)}) {
    std::ofstream(path_, std::ios::binary) << text;
    const auto opened = journal::JournalFile::open(path_, {});
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().symbol, "bad-journal") << opened.error().sentence;
    EXPECT_NE(opened.error().sentence.find(path_), std::string::npos) << opened.error().sentence;
  }
}

// A board that was killed leaves its file and SQLite's beside it as they are; damage must not pass for less.
TEST_F(JournalDamageTest, DamageIsAFailureAndNeverAWrongBoard) {
  constexpr std::uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::vector<Datum> expected = keep_a_past();
  const std::string whole = contents();
  Random random(seed);
  int found = 0;
  for (int round = 0; round < 120; ++round) {
    std::string text = whole;
    if (round % 3 == 0) {
      text.resize(random.below(text.size()));
    } else {
      for (int n = 0; n < 8; ++n) text[random.below(text.size())] ^= static_cast<char>(1 + random.below(255));
    }
    store::Store store;
    const Result<void> recovered = recover(text, store);
    if (!recovered) {
      ++found;
      EXPECT_TRUE(recovered.error().symbol == "bad-journal" || recovered.error().symbol == "journal-file")
          << recovered.error().symbol << ": " << recovered.error().sentence;
      continue;
    }
    if (store.tables().empty() && text.empty()) continue;
    EXPECT_EQ(facts_of(store), expected) << "round " << round;
  }
  EXPECT_GT(found, 60) << "most damage meets something";
}

// SQLite takes the first damaged page of its log for the end of it.
TEST_F(JournalDamageTest, DamageWithinWhatWasKeptIsSaidAndNothingBehindItDroppedSilently) {
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
    journal::remove_journal(copy);
    for (const char* part : {"", "-kept"}) std::filesystem::copy_file(path_ + part, copy + part);
    std::ofstream(copy + "-wal", std::ios::binary) << log;
    return journal::JournalFile::open(copy, {});
  };
  const std::string log = whole_file(path_ + "-wal");
  // What SQLite has not come to yet is nothing.
  const std::size_t written = log.find_last_not_of('\0');
  ASSERT_GT(written, 100'000U);
  EXPECT_TRUE(restart_with(log).has_value()) << "killed, it goes on";
  Random random(seed);
  for (int round = 0; round < 30; ++round) {
    std::string damaged = log;
    damaged[random.below(written * 9 / 10)] ^= static_cast<char>(1U << random.below(8));
    const auto opened = restart_with(damaged);
    // The counters of the header, which SQLite never reads, may have any value.
    if (opened && (*opened)->append({"(1000 1 \"a\" (retract 1))\n", "", true})) continue;
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().symbol, "bad-journal");
    EXPECT_NE(opened.error().sentence.find("up to entry 1"), std::string::npos) << opened.error().sentence;
    store::Store store;
    EXPECT_EQ(journal::read_journal(copy, store).error().symbol, "bad-journal");
    // Who would rather have less than nothing says so.
    std::filesystem::remove(copy + "-kept");
    EXPECT_TRUE(journal::JournalFile::open(copy, {}).has_value());
  }
}

TEST_F(JournalDamageTest, WhatIsLeftOfAJournalWhoseFileIsGoneIsNotBegunAnew) {
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
    const auto opened = journal::JournalFile::open(gone, {});
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().symbol, "bad-journal");
    EXPECT_NE(opened.error().sentence.find(gone + part), std::string::npos) << opened.error().sentence;
    EXPECT_FALSE(std::filesystem::exists(gone));
    EXPECT_TRUE(std::filesystem::exists(gone + part));
    std::filesystem::remove(gone + part);
  }
  EXPECT_TRUE(journal::JournalFile::open(gone, {}).has_value());
}

}  // namespace
}  // namespace pizarra
