#pragma once

// The learned objects as files, which outlive board and agent, which several vision agents of one machine share, and
// which are copied to another cell as one folder: `objects.sqlite` with a row a sample, named as the thesis' Table C.1
// names it, and beside it each sample's template as a bitmap, NAME-NUM.pgm.
//
// Lifecycle: opened, which makes the folder and an empty database where there are none; read; changed, each change all
// or nothing and on the disk when it returns; read again when version() has moved, for then another agent has changed
// it.
//
//   Result<ObjectDatabase> database = ObjectDatabase::open("objects");
//   Result<KeptObjects> kept = database->read();
//   Result<std::int64_t> row = database->apply(RenameObject{"circle", "disc"});
//   if (!database->in_place()) ...                  // another file is there now, or none: open_again()
//
// Failures: `missing` (of open_again()), `damaged` (not a database, or not one of ours any more), `disk-full`,
// `cannot-write` (a bitmap), `busy` (another agent is writing: try again), `unusable`; of a change also `full`,
// `not-learned`, `name-taken` and `bad-name`.

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "agents/vision/database/file_states.hpp"
#include "agents/vision/database/object_change.hpp"
#include "blackboard/journal/sqlite.hpp"

namespace pizarra::vision {

// What keeps something learned from being used; its subject is where the damage is.
struct MemoryTrouble {
  std::string object;  // its name; empty: any
  Failure why;
};

// What was read. A sample whose row or bitmap is damaged is left out, with why; its subject is the bitmap's name, or,
// where the row has no object's name, the row.
struct KeptObjects {
  LearnedObjects objects;
  std::vector<MemoryTrouble> damaged;
};

class ObjectDatabase {
 public:
  static Result<ObjectDatabase> open(const std::string& directory);
  // Makes nothing: where nothing is at the moment, what was moved away may be on its way back. Failure `missing`.
  static Result<ObjectDatabase> open_again(const std::string& directory);

  Result<KeptObjects> read();
  // The id of the sample that was kept; 0 where none was to be.
  Result<std::int64_t> apply(const ObjectChange& change);
  // Whether the file at its path is the one that was opened.
  bool in_place() const { return file_now() == file_; }
  // Whether the bitmaps are as they were when they were read: a damaged one is so soon known.
  bool bitmaps_in_place() const { return bitmaps_.unchanged(); }
  // Another number once another agent has changed it.
  Result<std::int64_t> version() { return database_.ask("PRAGMA data_version"); }

 private:
  ObjectDatabase(std::filesystem::path directory, journal::sqlite::Database database)
      : directory_(std::move(directory)), database_(std::move(database)) {}

  static Result<ObjectDatabase> open_prepared(const std::string& directory,
                                              Result<void> (*prepare)(journal::sqlite::Database&));
  // Device and inode; nothing where there is no file.
  using FileId = std::optional<std::pair<std::uint64_t, std::uint64_t>>;
  FileId file_now() const;
  Result<LearnedSample> sample_of(journal::sqlite::Statement& row, const std::string& name) const;
  struct Row {
    std::string name;  // as it was spelt first
    std::int64_t number;
  };
  using Rows = std::vector<Row>;
  std::filesystem::path bitmap(const Row& row) const;
  // Failure `bad-name`.
  Result<Rows> rows_of(const std::string& name);
  // Failure `not-learned` where there are none.
  Result<Rows> known_rows(const std::string& name);
  // The bitmaps that a change has written, those that it, once committed, leaves without a row, and the sample it kept.
  struct Outcome {
    Rows written = {};
    Rows left_over = {};
    std::int64_t kept = 0;
  };
  Result<void> change(const KeepSample& keep, Outcome& outcome);
  Result<void> change(const WithdrawSample& withdraw, Outcome& outcome);
  Result<void> change(const ForgetObject& forget, Outcome& outcome);
  Result<void> change(const RenameObject& rename, Outcome& outcome);
  // Those that have no row, while nobody writes.
  void remove(const Rows& bitmaps);

  std::filesystem::path directory_;
  journal::sqlite::Database database_;
  FileId file_;
  FileStates bitmaps_;  // of those that were read last
};

}  // namespace pizarra::vision
