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
//   Result<void> done = database->apply(RenameObject{"circle", "disc"});
//
// Failures: `damaged` (not a database, or not one of ours any more), `disk-full`, `busy` (another agent is writing:
// try again), `unusable`; of a change also `full`, `not-learned` and `name-taken`.

#include <filesystem>
#include <vector>

#include "agents/vision/memory/object_change.hpp"
#include "blackboard/journal/sqlite.hpp"

namespace pizarra {

// What was read. A sample whose row or bitmap is damaged is left out, and a failure says why; its subject is the
// bitmap's name.
struct KeptObjects {
  LearnedObjects objects;
  std::vector<Failure> damaged;
};

class ObjectDatabase {
 public:
  static Result<ObjectDatabase> open(const std::string& directory);

  Result<KeptObjects> read();
  Result<void> apply(const ObjectChange& change);
  // Another number once another agent has changed it.
  Result<std::int64_t> version() { return database_.ask("PRAGMA data_version"); }

 private:
  ObjectDatabase(std::filesystem::path directory, sqlite::Database database)
      : directory_(std::move(directory)), database_(std::move(database)) {}

  Result<void> prepare();
  Result<LearnedSample> sample_of(sqlite::Statement& row, const std::string& name) const;
  struct Row {
    std::string name;  // as it was spelt first
    std::int64_t number;
  };
  using Rows = std::vector<Row>;
  std::filesystem::path bitmap(const Row& row) const;
  Result<Rows> rows_of(const std::string& name);
  // Failure `not-learned` where there are none.
  Result<Rows> known_rows(const std::string& name);
  // Files that a change, once committed, leaves without a row.
  using Leftover = std::vector<std::filesystem::path>;
  Result<Leftover> change(const KeepSample& keep);
  Result<Leftover> change(const WithdrawSample& withdraw);
  Result<Leftover> change(const ForgetObject& forget);
  Result<Leftover> change(const RenameObject& rename);

  std::filesystem::path directory_;
  sqlite::Database database_;
};

}  // namespace pizarra
