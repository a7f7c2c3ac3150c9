#include "blackboard/journal/journal_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "blackboard/journal/journal_compaction.hpp"
#include "blackboard/journal/journal_tables.hpp"
#include "blackboard/journal/log_ahead.hpp"

namespace pizarra::journal {

namespace {

constexpr std::uintmax_t longest_line = 64 << 20;
constexpr std::int64_t page = 4096;  // bytes, of SQLite's files
constexpr const char* bytes_of_log =
    "SELECT coalesce(sum(length(CAST(lines AS BLOB)) + length(CAST(replies AS BLOB))), 0) FROM log";

std::unexpected<Failure> refused(const std::string& what, const std::string& path) {
  return fail("journal-file", what + " " + path + ": " + std::strerror(errno));
}

// A journal in text, as `demo --journal` writes it: the last of it at least, where it has more than `most` bytes.
Result<std::string> text_of(const std::string& path, std::uintmax_t most = std::numeric_limits<std::uintmax_t>::max()) {
  std::error_code unseen;
  if (std::filesystem::is_directory(path, unseen)) return fail("journal-file", path + " is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) return refused("cannot read", path);
  const std::uintmax_t size = std::filesystem::file_size(path, unseen);
  if (!unseen && size > most) file.seekg(static_cast<std::streamoff>(size - most));
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

PlayedBack played_back(std::string_view text, std::string_view rest) {
  return {start_of_last_line(text.substr(0, text.size() - rest.size())), std::string(rest)};
}

Result<PlayedBack> read_text(const std::string& path, store::Store& store, const Moment& until) {
  const Result<std::string> text = text_of(path);
  if (!text) return fail(text);
  const Result<std::string_view> rest = replay(*text, store, until);
  if (rest) return played_back(*text, *rest);
  return fail("bad-journal", path + ": " + rest.error().sentence, rest.error().subject);
}

std::string mark_beside(const std::string& path) { return path + "-kept"; }

Result<LineStart> end_of(sqlite::Database& database) {
  sqlite::Statement row(
      database,
      "SELECT revision, time FROM log UNION ALL SELECT (SELECT value FROM about WHERE name = 'horizon'), "
      "(SELECT value FROM about WHERE name = 'horizon-time') ORDER BY 1 DESC LIMIT 1");
  const Result<bool> found = row.step();
  if (!found) return fail(found);
  return LineStart{static_cast<Revision>(row.integer(0)), Time(Duration(row.integer(1)))};
}

// The number of the last group, which compaction may have let go.
Result<std::int64_t> last_group(sqlite::Database& database) {
  return database.ask(
      "SELECT max((SELECT coalesce(max(number), 0) FROM log), "
      "coalesce((SELECT value FROM about WHERE name = 'forgotten'), 0))");
}

// Whether all that the mark knows of is there.
Result<void> check_end(sqlite::Database& database, const KeptMark& mark) {
  const std::optional<std::int64_t> kept = mark.get();
  const Result<std::int64_t> last = last_group(database);
  if (!last) return fail(last);
  if (!kept || *last >= *kept) return {};
  const Result<LineStart> end = end_of(database);
  if (!end) return fail(end);
  return fail("damaged", "it ends with entry " + std::to_string(*last) + ", revision " + std::to_string(end->revision) +
                             ", but was kept up to entry " + std::to_string(*kept) +
                             ": what comes between is damaged or missing; without " + mark.path() +
                             " it is taken as it is");
}

// A journal whose file is gone is not begun anew over what is left of it: SQLite's log may hold most of it.
Result<void> check_together(const Disk& disk, const std::string& path) {
  if (disk.status(path)) return {};
  for (const std::string& part : {path + "-wal", mark_beside(path)}) {
    if (!disk.status(part)) continue;
    return fail("bad-journal", path + " is gone, but " + part + " is there: bring it back, or remove " + part +
                                   " as well to begin anew");
  }
  return {};
}

}  // namespace

Result<PlayedBack> check_reached(Result<PlayedBack> played, const Moment& until) {
  const bool bounded = until.revision != Moment().revision;
  if (!played || !bounded || !played->later.empty() || played->to.revision >= until.revision) return played;
  return fail("not-yet",
              "there is no revision " + std::to_string(until.revision) + " yet: the newest is " +
                  std::to_string(played->to.revision),
              to_datum(until.revision));
}

Result<std::shared_ptr<JournalFile>> JournalFile::open(const std::string& path, const History& history, Disk& disk) {
  const Result<void> together = check_together(disk, path);
  if (!together) return fail(together);
  Result<std::unique_ptr<Disk::Lock>> lock = disk.lock(path);
  if (!lock) return fail(lock);
  // A killed board's reserved space may be needed to begin.
  disk.remove(path + "-reserve");
  Result<sqlite::Database> database = journal_tables::open(disk, path, sqlite::Access::write);
  if (!database) return fail(journal_tables::failure_of(database.error(), path));
  write_log_ahead(disk, path + "-wal");
  std::shared_ptr<JournalFile> file(new JournalFile(disk, path, history, std::move(*lock), std::move(*database)));
  const Result<void> whole = check_end(file->database_, file->mark_);
  if (!whole) return fail(journal_tables::failure_of(whole.error(), path));
  const Result<std::int64_t> last = last_group(file->database_);
  if (!last) return fail(journal_tables::failure_of(last.error(), path));
  file->next_group_ = *last + 1;
  const Result<std::int64_t> past = file->database_.ask(bytes_of_log);
  if (!past) return fail(journal_tables::failure_of(past.error(), path));
  file->past_bytes_ = static_cast<std::size_t>(*past);
  return file;
}

JournalFile::JournalFile(Disk& disk, std::string path, History history, std::unique_ptr<Disk::Lock> lock,
                         sqlite::Database database)
    : disk_(disk),
      path_(std::move(path)),
      history_(history),
      lock_(std::move(lock)),
      reserve_(disk, path_ + "-reserve"),
      mark_(disk, mark_beside(path_)),
      database_(std::move(database)),
      insert_(database_, "INSERT INTO log VALUES (?, ?, ?, ?, ?, ?)"),
      place_(disk, path_),
      log_place_(disk, path_ + "-wal") {}

JournalFile::~JournalFile() = default;

Result<std::vector<RememberedReply>> JournalFile::recover(store::Store& store) {
  const std::scoped_lock lock(mutex_);
  const Result<PlayedBack> restored = journal_tables::restore(database_, store, {});
  if (!restored) return fail(journal_tables::failure_of(restored.error(), path_));
  Result<std::vector<RememberedReply>> replies = journal_tables::remembered(database_, replies_kept);
  if (!replies) return fail(journal_tables::failure_of(replies.error(), path_));
  return replies;
}

Result<void> JournalFile::begin_with(const store::Store& store, const LineStart& end) {
  const std::scoped_lock lock(mutex_);
  if (next_group_ != 1) return fail("journal-file", path_ + " has been begun already");
  const Result<void> begun = journal_tables::begin_at(database_, store, end);
  return begun ? begun : fail(journal_tables::failure_of(begun.error(), path_));
}

Result<void> JournalFile::append(const JournalGroup& group, bool may_spend) {
  const std::scoped_lock lock(mutex_);
  const Result<void> in_place = check_place();
  if (!in_place) return in_place;
  if (!may_spend && group.bytes() > room_.for_passing) return fail("journal-full", path_ + ": the disk is full");
  Result<void> written = write(group);
  if (!written && may_spend && spend_if_full(written.error())) written = write(group);
  if (!written) return fail(journal_tables::failure_of(written.error(), path_));
  if (group.durable) mark_.set(next_group_);
  log_bytes_ = log_place_.bytes();
  past_bytes_ += group.bytes();
  ++next_group_;
  return {};
}

// Writes to a removed file are lost. Writes to a moved file are not found again, nor are those behind the end of a log
// that was cut short.
Result<void> JournalFile::check_place() const {
  if (place_.is_there() && log_place_.is_there(log_bytes_)) return {};
  return fail("journal-full", path_ + ": it was moved or removed, or its " + path_ +
                                  "-wal was, or was cut short, since the board opened it; bring it back, or end the "
                                  "board in order (SIGTERM, Ctrl-C), which writes back a log that was removed");
}

// Whether what failed may be tried once more.
bool JournalFile::spend_if_full(const Failure& failure) {
  if (failure.symbol != "disk-full" || !reserve_.spend()) return false;
  spent_ = true;
  return true;
}

Result<void> JournalFile::write(const JournalGroup& group) {
  if (waits_for_disk_ != group.durable) {
    const Result<void> set = database_.run(group.durable ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
    if (!set) return set;
    waits_for_disk_ = group.durable;
  }
  const LineStart last = start_of_last_line(group.lines);
  insert_.bind(1, next_group_).bind(2, static_cast<std::int64_t>(last.revision));
  insert_.bind(3, last.when.time_since_epoch().count()).bind(4, group.lines).bind(5, group.replies);
  return insert_.bind(6, journal_tables::sum_of_group(next_group_, group.lines, group.replies)).run();
}

// SQLite copies its log to where it belongs when that has so many bytes: the file grows then, by as much at most.
void JournalFile::copy_log_at(std::int64_t bytes) {
  constexpr std::int64_t most_pages = 1000;
  const std::int64_t pages = std::clamp<std::int64_t>(bytes / page, 1, most_pages);
  if (pages == log_pages_) return;
  const Result<void> set = database_.run(("PRAGMA wal_autocheckpoint = " + std::to_string(pages)).c_str());
  if (set) log_pages_ = pages;
}

// Copies SQLite's log at once, so that the disk has its space again; while somebody reads it, that must wait.
void JournalFile::give_log_back() {
  constexpr const char* copy = "PRAGMA wal_checkpoint(TRUNCATE)";
  [[maybe_unused]] Result<void> set = database_.run("PRAGMA busy_timeout = 0");
  Result<std::int64_t> copied = database_.ask(copy);
  if (!copied && spend_if_full(copied.error())) copied = database_.ask(copy);
  log_bytes_ = log_place_.bytes();
  set = database_.run(journal_tables::wait_for_others);
}

JournalRoom JournalFile::room() {
  const std::scoped_lock lock(mutex_);
  const Result<void> in_place = check_place();
  // Whatever stands there now is nobody's to fill.
  if (!in_place) return {.lacking = in_place.error().sentence};
  if (spent_ || room_.is_scarce) give_log_back();
  spent_ = false;
  const std::int64_t set_aside = reserve_.fill();
  copy_log_at(set_aside / 8);
  const Result<std::int64_t> free_pages =
      is_ample(set_aside) ? Result<std::int64_t>(0) : database_.ask("PRAGMA freelist_count");
  room_ = room_with(set_aside, page * free_pages.value_or(0));
  room_.past_goes = room_.is_scarce || past_bytes_ > history_.bytes;
  return room_;
}

Result<std::size_t> JournalFile::compact(Time now) {
  const std::scoped_lock lock(mutex_);
  Result<std::size_t> gone = compact_slice(now);
  if (!gone && spend_if_full(gone.error())) gone = compact_slice(now);
  // Work that lacks the space to be done at once is done in smaller slices.
  const bool full = !gone && gone.error().symbol == "disk-full";
  slice_bytes_ = full ? std::max<std::size_t>(slice_bytes_ / 4, 1) : std::min(2 * slice_bytes_, largest_slice);
  if (!gone) return fail(journal_tables::failure_of(gone.error(), path_));
  past_bytes_ -= std::min(*gone, past_bytes_);
  return gone;
}

Result<std::size_t> JournalFile::compact_slice(Time now) {
  const Result<LineStart> end = end_of(database_);
  if (!end) return fail(end);
  if (room_.past_goes) {
    return journal_tables::advance_horizon(database_, end->revision + 1, now - replies_kept, slice_bytes_);
  }
  const Revision kept = history_.time ? 0 : history_.revisions;
  if (end->revision < kept) return std::size_t{0};
  const Time oldest = now - std::max(replies_kept, history_.time.value_or(replies_kept));
  return journal_tables::advance_horizon(database_, end->revision - kept, oldest, slice_bytes_);
}

void remove_journal(const std::string& path, Disk& disk) {
  for (const char* part : {"", "-wal", "-shm", "-reserve", "-kept"}) disk.remove(path + part);
}

Result<LineStart> end_of_journal(const std::string& path, Disk& disk) {
  if (!sqlite::is_database(path, disk.vfs())) {
    const Result<std::string> text = text_of(path, longest_line);
    if (!text) return fail(text);
    return start_of_last_line(std::string_view(*text).substr(0, text->rfind('\n') + 1));
  }
  Result<sqlite::Database> database = journal_tables::open(disk, path, sqlite::Access::read);
  if (!database) return fail(journal_tables::failure_of(database.error(), path));
  const Result<LineStart> end = end_of(*database);
  if (!end) return fail(journal_tables::failure_of(end.error(), path));
  return end;
}

Result<PlayedBack> JournalFile::read(store::Store& store, const Moment& until) const {
  return read_journal(path_, store, until, disk_);
}

Result<PlayedBack> read_journal(const std::string& path, store::Store& store, const Moment& until, Disk& disk) {
  if (!sqlite::is_database(path, disk.vfs())) return check_reached(read_text(path, store, until), until);
  Result<sqlite::Database> database = journal_tables::open(disk, path, sqlite::Access::read);
  if (!database) return fail(journal_tables::failure_of(database.error(), path));
  // The mark is read first: the journal may grow meanwhile.
  Result<void> whole = check_end(*database, KeptMark(disk, mark_beside(path)));
  if (!whole) return fail(journal_tables::failure_of(whole.error(), path));
  Result<PlayedBack> rest = journal_tables::restore(*database, store, until);
  if (!rest) return fail(journal_tables::failure_of(rest.error(), path));
  return check_reached(std::move(rest), until);
}

}  // namespace pizarra::journal
