#pragma once

// SQLite with this house's failures: `disk-full` (also a quota, a limit, a disk that cannot be written), `damaged`,
// `busy` (another process has it), `unusable` for everything else.
//
//   Result<sqlite::Database> database = sqlite::Database::open("cell.journal", sqlite::Access::write);
//   sqlite::Statement insert(*database, "INSERT INTO facts VALUES (?, ?)");
//   insert.bind(1, 7).bind(2, "(on a b)");
//   Result<bool> row = insert.step();            // whether there is a row to read
//   insert.reset();
//
// One thread at a time uses a database and its statements; a statement ends before its database.

#include <cstdint>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace pizarra::journal::sqlite {

enum class Access : std::uint8_t { read, write };

class Database {
 public:
  // `vfs`: how SQLite calls the disk; null: this machine's.
  static Result<Database> open(const std::string& path, Access access, const char* vfs = nullptr);
  Database(Database&& other) noexcept;
  Database& operator=(Database&& other) noexcept;
  ~Database();

  // Statements that answer nothing.
  Result<void> run(const char* sql);
  // The one integer that a statement answers.
  Result<std::int64_t> ask(const char* sql);
  Failure failure() const;

 private:
  friend class Statement;
  explicit Database(sqlite3* handle) : handle_(handle) {}
  sqlite3* handle_ = nullptr;
};

// Whether the file is one of SQLite's. It is read through SQLite: a process that opens and closes the file by itself
// gives up the locks that SQLite has on it, and another program that closes it then removes its log.
bool is_database(const std::string& path, const char* vfs = nullptr);

class Statement {
 public:
  // Text that SQLite cannot prepare is a damaged file or a bug; step() then fails.
  Statement(Database& database, const char* sql);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  // Parameters count from 1. Text must live until the statement is reset.
  Statement& bind(int parameter, std::int64_t value);
  Statement& bind_real(int parameter, double value);
  Statement& bind(int parameter, std::string_view text);
  Result<bool> step();
  // Steps to the end and makes it ready for the next values.
  Result<void> run();
  void reset();

  // Columns count from 0. Text is valid until the next step.
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string_view text(int column) const;

 private:
  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

// Several statements, all or nothing: what is not committed when it is destroyed is undone.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {}
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  Result<void> begin();
  // One view of everything, that hinders no writer.
  Result<void> begin_reading();
  Result<void> commit();

 private:
  Database& database_;
  bool open_ = false;
};

}  // namespace pizarra::journal::sqlite
