#pragma once

// Lives of a board that keeps its journal in a file of the test's own.
//
//   Life life(path_);                    // recovers what the last one left
//   life.tell("(goal 1 (on a b))");
//   life.keep();                         // until everything is written

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {

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
    explicit Life(const std::string& path, const journal::History& history = {}) {
      auto store = std::make_unique<store::Store>();
      file = journal::JournalFile::open(path, history).value();
      remembered = file->recover(*store).value();
      writer = std::make_unique<journal::JournalWriter>(executor, file);
      board = std::make_unique<memory::MemoryBoard>(executor, std::move(store));
      board->set_journal([this](std::string_view line) { writer->append(line); });
      board->resume();
    }
    std::vector<Datum> facts(const std::string& pattern) {
      std::vector<Datum> facts;
      const Answers answers = board->ask(query(pattern)).value();
      for (const Answer& answer : answers.answers) facts.push_back(answer.facts.front().datum);
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
    std::shared_ptr<journal::JournalFile> file;
    std::vector<journal::RememberedReply> remembered;
    std::unique_ptr<journal::JournalWriter> writer;
    std::unique_ptr<memory::MemoryBoard> board;
  };

  Datum facts_at(const Moment& until, const std::string& pattern) {
    store::Store store;
    const Result<journal::PlayedBack> later = journal::read_journal(path_, store, until);
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

}  // namespace pizarra
