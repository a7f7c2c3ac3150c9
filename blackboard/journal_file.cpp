#include "blackboard/journal_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

#include "blackboard/journal_compaction.hpp"
#include "blackboard/journal_tables.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr std::string_view sqlite_files_begin_with = "SQLite format 3";

std::unexpected<Failure> refused(const std::string& what, const std::string& path) {
  return fail("journal-file", what + " " + path + ": " + std::strerror(errno));
}

std::string_view last_line(std::string_view lines) {
  if (!lines.empty()) lines.remove_suffix(1);
  return lines.substr(lines.rfind('\n') + 1);
}

// A journal in text, as `demo --journal` writes it.
Result<std::string> read_text(std::ifstream& file, const std::string& path, Store& store, const Moment& until) {
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const Result<std::string_view> rest = replay(text, store, until);
  if (rest) return std::string(*rest);
  return fail("bad-journal", path + ": " + rest.error().sentence, rest.error().subject);
}

}  // namespace

std::string reply_line(const RememberedReply& reply) {
  return write(pizarra::list(reply.session, reply.teller, reply.request, reply.result)) + "\n";
}

JournalFile::Lock::~Lock() { close(file_); }

Result<std::shared_ptr<JournalFile>> JournalFile::open(const std::string& path, const History& history) {
  const int lock = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) return refused("cannot open", path);
  if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    const auto taken = refused("another board keeps", path);
    close(lock);
    return taken;
  }
  Result<sqlite::Database> database = journal_tables::open(path, sqlite::Access::write);
  if (!database) {
    close(lock);
    return fail(journal_tables::failure_of(database.error(), path));
  }
  std::shared_ptr<JournalFile> file(new JournalFile(path, history, lock, std::move(*database)));
  const Result<std::int64_t> last = file->database_.ask("SELECT coalesce(max(number), 0) FROM log");
  if (!last) return fail(journal_tables::failure_of(last.error(), path));
  file->next_group_ = *last + 1;
  file->reserve_.fill();
  return file;
}

JournalFile::JournalFile(std::string path, History history, int lock, sqlite::Database database)
    : path_(std::move(path)),
      history_(history),
      lock_(lock),
      reserve_(path_ + "-reserve"),
      database_(std::move(database)) {}

JournalFile::~JournalFile() = default;

Result<std::vector<RememberedReply>> JournalFile::recover(Store& store) {
  const std::scoped_lock lock(mutex_);
  const Result<std::string> restored = journal_tables::restore(database_, store, {});
  if (!restored) return fail(journal_tables::failure_of(restored.error(), path_));
  Result<std::vector<RememberedReply>> replies = journal_tables::remembered(database_, replies_kept);
  if (!replies) return fail(journal_tables::failure_of(replies.error(), path_));
  return replies;
}

Result<void> JournalFile::append(const JournalGroup& group) {
  const std::scoped_lock lock(mutex_);
  Result<void> written = write(group);
  if (!written && written.error().symbol == "disk-full" && reserve_.spend()) written = write(group);
  if (!written) return fail(journal_tables::failure_of(written.error(), path_));
  ++next_group_;
  return {};
}

Result<void> JournalFile::write(const JournalGroup& group) {
  if (waits_for_disk_ != group.durable) {
    const Result<void> set = database_.run(group.durable ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
    if (!set) return set;
    waits_for_disk_ = group.durable;
  }
  const LineStart last = start_of_line(last_line(group.lines));
  sqlite::Statement insert(database_, "INSERT INTO log VALUES (?, ?, ?, ?, ?, ?)");
  insert.bind(1, next_group_).bind(2, static_cast<std::int64_t>(last.revision));
  insert.bind(3, last.when.time_since_epoch().count()).bind(4, group.lines).bind(5, group.replies);
  return insert.bind(6, journal_tables::sum_of_group(next_group_, group.lines, group.replies)).run();
}

bool JournalFile::has_room() {
  const std::scoped_lock lock(mutex_);
  return reserve_.fill();
}

Result<bool> JournalFile::compact(Time now) {
  const std::scoped_lock lock(mutex_);
  const Result<std::int64_t> newest =
      database_.ask("SELECT coalesce((SELECT revision FROM log ORDER BY number DESC LIMIT 1), 0)");
  if (!newest) return fail(journal_tables::failure_of(newest.error(), path_));
  const auto revision = static_cast<Revision>(*newest);
  // The newest group stays, and says where the numbers go on.
  const Revision kept = history_.time ? 0 : history_.revisions;
  const Time oldest_time = now - std::max(replies_kept, history_.time.value_or(replies_kept));
  if (revision < kept) return false;
  Result<bool> more = journal_tables::advance_horizon(database_, revision - kept, oldest_time);
  if (!more) return fail(journal_tables::failure_of(more.error(), path_));
  return more;
}

Result<std::string> read_journal(const std::string& path, Store& store, const Moment& until) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(sqlite_files_begin_with.size(), '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (!file && !file.eof()) return refused("cannot read", path);
  if (begin != sqlite_files_begin_with) {
    file.clear();
    file.seekg(0);
    return read_text(file, path, store, until);
  }
  Result<sqlite::Database> database = journal_tables::open(path, sqlite::Access::read);
  if (!database) return fail(journal_tables::failure_of(database.error(), path));
  Result<std::string> rest = journal_tables::restore(*database, store, until);
  if (!rest) return fail(journal_tables::failure_of(rest.error(), path));
  return rest;
}

}  // namespace pizarra
