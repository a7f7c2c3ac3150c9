#include "agents/vision/database/object_schema.hpp"

namespace pizarra::vision {
namespace {

constexpr std::int64_t application = 0x506f626a;  // "Pobj"
constexpr std::int64_t format = 6;

// A row's id is never given again; the number of a sample is, once its object is forgotten.
constexpr const char* schema = R"(
  CREATE TABLE samples (id INTEGER PRIMARY KEY AUTOINCREMENT, name TEXT COLLATE NOCASE, num INTEGER, tone TEXT,
                        area REAL, perimeter INTEGER, nf INTEGER, m0 REAL, m1 REAL, m2 REAL, height REAL, slimness REAL,
                        roundness REAL, roundness_spread REAL, size REAL, sum INTEGER, size_by INTEGER, focal REAL,
                        contrast REAL, axis REAL, UNIQUE (name, num));
  PRAGMA application_id = 1349476970;
  PRAGMA user_version = 6;
)";

// The first format had no ids, the second did not say which sizes were guesses, the third knew none but along y; none
// of them said by which focal length a sample was learned. The fourth did not say how bold the print was, nor the fifth
// how a slim mark lies in its template.
constexpr const char* put_away_first_format = "ALTER TABLE samples RENAME TO samples_1";
constexpr const char* take_first_format = R"(
  INSERT INTO samples SELECT NULL, *, 0, 0, 0, 0 FROM samples_1 ORDER BY rowid;
  DROP TABLE samples_1;
)";
constexpr const char* from_second_to_fourth = R"(
  ALTER TABLE samples ADD COLUMN size_by INTEGER DEFAULT 0;
  ALTER TABLE samples ADD COLUMN focal REAL DEFAULT 0;
)";
constexpr const char* from_third_to_fourth = R"(
  ALTER TABLE samples RENAME COLUMN guessed TO size_by;
  ALTER TABLE samples ADD COLUMN focal REAL DEFAULT 0;
)";
constexpr const char* take_fourth_format = R"(
  ALTER TABLE samples ADD COLUMN contrast REAL DEFAULT 0;
)";
constexpr const char* take_fifth_format = R"(
  ALTER TABLE samples ADD COLUMN axis REAL DEFAULT 0;
  PRAGMA user_version = 6;
)";

Result<bool> is_ours(journal::sqlite::Database& database) {
  const Result<std::int64_t> whose = database.ask("PRAGMA application_id");
  if (!whose) return fail(whose);
  return *whose == application;
}

// The format of ours that it has; 0: none.
Result<std::int64_t> format_of(journal::sqlite::Database& database) {
  const Result<bool> ours = is_ours(database);
  if (!ours) return fail(ours);
  return *ours ? database.ask("PRAGMA user_version") : 0;
}

Result<void> take_from_first_format(journal::sqlite::Database& database) {
  const Result<void> put_away = database.run(put_away_first_format);
  if (!put_away) return put_away;
  const Result<void> made = database.run(schema);
  if (!made) return made;
  return database.run(take_first_format);
}

Result<void> take_later_format(journal::sqlite::Database& database, std::int64_t is) {
  if (is < 4) {
    const Result<void> as_fourth = database.run(is == 2 ? from_second_to_fourth : from_third_to_fourth);
    if (!as_fourth) return as_fourth;
  }
  if (is < 5) {
    const Result<void> as_fifth = database.run(take_fourth_format);
    if (!as_fifth) return as_fifth;
  }
  return database.run(take_fifth_format);
}

Result<void> make_table(journal::sqlite::Database& database) {
  const Result<std::int64_t> tables = database.ask("SELECT count(*) FROM sqlite_schema");
  if (!tables) return fail(tables);
  // Another agent may just have made it.
  const Result<std::int64_t> is = format_of(database);
  if (!is) return fail(is);
  if (*is == format) return {};
  if (*tables == 0) return database.run(schema);
  if (*is == 1) return take_from_first_format(database);
  if (*is > 1 && *is < format) return take_later_format(database, *is);
  return fail("unusable", "the file is no database of objects that this version knows");
}

}  // namespace

Result<void> prepare_objects(journal::sqlite::Database& database) {
  const Result<std::int64_t> is = format_of(database);
  if (!is) return fail(is);
  if (*is == format) return {};
  journal::sqlite::Transaction making(database);
  const Result<void> begun = making.begin();
  if (!begun) return begun;
  const Result<void> made = make_table(database);
  if (!made) return made;
  return making.commit();
}

Result<void> prepare_objects_again(journal::sqlite::Database& database) {
  const Result<bool> ours = is_ours(database);
  if (!ours) return fail(ours);
  if (*ours) return prepare_objects(database);
  return fail("damaged", "the file in the place of the database of the objects is no such database");
}

}  // namespace pizarra::vision
