#include "blackboard/journal/sqlite.hpp"

#include <array>
#include <cstring>
#include <sqlite3.h>
#include <utility>

namespace pizarra::journal::sqlite {

namespace {

const char* symbol_of(int code) {
  switch (code) {
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
      return "disk-full";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return "damaged";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "busy";
    default:
      return "unusable";
  }
}

Failure failure_of(sqlite3* handle) {
  std::string sentence = sqlite3_errmsg(handle);
  // It may quote what a damaged file holds.
  if (!is_string_text(sentence)) sentence = sqlite3_errstr(sqlite3_errcode(handle));
  const int cause = sqlite3_system_errno(handle);
  if (cause != 0) sentence += std::string(" (") + std::strerror(cause) + ")";
  return {symbol_of(sqlite3_errcode(handle) & 0xff), std::move(sentence), {}, {}};
}

}  // namespace

Result<Database> Database::open(const std::string& path, Access access, const char* vfs) {
  sqlite3* handle = nullptr;
  const int flags = access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  const int code = sqlite3_open_v2(path.c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX, vfs);
  Database database(handle);
  if (code != SQLITE_OK) return fail(database.failure());
  return database;
}

Database::Database(Database&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}

Database& Database::operator=(Database&& other) noexcept {
  std::swap(handle_, other.handle_);
  return *this;
}

Database::~Database() { sqlite3_close(handle_); }

Result<void> Database::run(const char* sql) {
  if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) return fail(failure());
  return {};
}

Result<std::int64_t> Database::ask(const char* sql) {
  Statement statement(*this, sql);
  const Result<bool> row = statement.step();
  if (!row) return fail(row);
  return statement.integer(0);
}

Failure Database::failure() const { return failure_of(handle_); }

bool is_database(const std::string& path, const char* vfs) {
  constexpr std::string_view begins_with = "SQLite format 3";
  sqlite3* handle = nullptr;
  sqlite3_file* file = nullptr;
  std::array<char, begins_with.size()> begin{};
  const bool is_open =
      sqlite3_open_v2(path.c_str(), &handle, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, vfs) == SQLITE_OK;
  if (is_open) sqlite3_file_control(handle, "main", SQLITE_FCNTL_FILE_POINTER, static_cast<void*>(&file));
  const bool is_read = file != nullptr && file->pMethods != nullptr &&
                       file->pMethods->xRead(file, begin.data(), static_cast<int>(begin.size()), 0) == SQLITE_OK;
  sqlite3_close(handle);
  return is_read && std::string_view(begin.data(), begin.size()) == begins_with;
}

Statement::Statement(Database& database, const char* sql) : database_(database) {
  sqlite3_prepare_v2(database.handle_, sql, -1, &handle_, nullptr);
}

Statement::~Statement() { sqlite3_finalize(handle_); }

Statement& Statement::bind(int parameter, std::int64_t value) {
  sqlite3_bind_int64(handle_, parameter, value);
  return *this;
}

Statement& Statement::bind_real(int parameter, double value) {
  sqlite3_bind_double(handle_, parameter, value);
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  sqlite3_bind_text64(handle_, parameter, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8);
  return *this;
}

Result<bool> Statement::step() {
  if (handle_ == nullptr) return fail(database_.failure());
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return fail(database_.failure());
}

Result<void> Statement::run() {
  Result<bool> row = step();
  while (row && *row) row = step();
  reset();
  if (!row) return fail(row);
  return {};
}

void Statement::reset() { sqlite3_reset(handle_); }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(handle_, column); }

double Statement::real(int column) const { return sqlite3_column_double(handle_, column); }

std::string_view Statement::text(int column) const {
  const auto* text = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  return {text, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))};
}

Transaction::~Transaction() {
  // A rollback that fails leaves nothing open either.
  if (open_) [[maybe_unused]]
    const Result<void> undone = database_.run("ROLLBACK");
}

Result<void> Transaction::begin() {
  Result<void> begun = database_.run("BEGIN IMMEDIATE");
  open_ = begun.has_value();
  return begun;
}

Result<void> Transaction::begin_reading() {
  Result<void> begun = database_.run("BEGIN");
  open_ = begun.has_value();
  return begun;
}

Result<void> Transaction::commit() {
  Result<void> committed = database_.run("COMMIT");
  if (committed) open_ = false;
  return committed;
}

}  // namespace pizarra::journal::sqlite
