#include "blackboard/journal/journal_tables.hpp"

#include <algorithm>
#include <map>

#include "blackboard/journal/checksum.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "lisp/reader.hpp"

namespace pizarra::journal::journal_tables {

namespace {

constexpr std::int64_t application = 0x50697a61;  // "Piza"
constexpr std::int64_t format = 4;
constexpr std::int64_t format_without_head_sum = 1;
constexpr std::int64_t format_that_misses_nothing = 3;  // since which the head tells of all facts and groups
constexpr std::size_t replies_of_session = 256;
constexpr std::size_t most_replies = 1 << 18;
constexpr ReadLimits fact_limits = {.bytes = 4 << 20, .depth = 70, .elements = 400'000};

constexpr const char* schema = R"(
  CREATE TABLE about (name TEXT PRIMARY KEY, value INTEGER) WITHOUT ROWID;
  CREATE TABLE relations (name TEXT PRIMARY KEY, form TEXT) WITHOUT ROWID;
  CREATE TABLE facts (id INTEGER PRIMARY KEY, taken INTEGER, form TEXT, sum INTEGER);
  CREATE TABLE log (number INTEGER PRIMARY KEY, revision INTEGER, time INTEGER, lines TEXT, replies TEXT, sum INTEGER);
  INSERT INTO about VALUES ('horizon', 0), ('horizon-time', 0), ('next-fact', 1), ('facts', 0), ('forgotten', 0);
  PRAGMA application_id = 1349089889;
  PRAGMA user_version = 4;
)";

constexpr const char* to_this_format = "PRAGMA user_version = 4";
// What is there of a former format is believed.
constexpr const char* to_this_format_from_the_first = R"(
  INSERT OR REPLACE INTO about SELECT 'facts', coalesce(sum(sum & 0xffffffff), 0) FROM facts;
  INSERT OR REPLACE INTO about SELECT 'forgotten', coalesce(min(number) - 1, 0) FROM log;
  PRAGMA user_version = 4;
)";

std::unexpected<Failure> damaged(std::string sentence) { return fail("bad-journal", std::move(sentence)); }

std::unexpected<Failure> damaged_fact(FactId id, const std::string& why) {
  return damaged("fact " + std::to_string(id) + " is damaged: " + why);
}

// Of `about` and `relations`, whose rows have none of their own.
Result<std::int64_t> sum_of_head(sqlite::Database& database) {
  sqlite::Statement rows(database,
                         "SELECT name, value, '' FROM (SELECT * FROM about WHERE name <> 'sum' ORDER BY name) "
                         "UNION ALL SELECT name, 0, form FROM (SELECT * FROM relations ORDER BY name)");
  Checksum sum;
  for (Result<bool> row = rows.step(); !row || *row; row = rows.step()) {
    if (!row) return fail(row);
    sum.add(rows.text(0).size()).add(rows.text(0)).add(static_cast<std::uint64_t>(rows.integer(1)));
    sum.add(rows.text(2).size()).add(rows.text(2));
  }
  return sum.value();
}

// Runs the statements and sums up the head that they leave: all of it, or nothing.
Result<void> run_and_seal(sqlite::Database& database, const char* sql) {
  sqlite::Transaction transaction(database);
  Result<void> done = transaction.begin();
  if (done) done = database.run(sql);
  if (done) done = seal_head(database);
  if (done) done = transaction.commit();
  return done;
}

// Of a file whose format does not say it, nothing.
Result<std::optional<std::int64_t>> about_if_said(sqlite::Database& database, std::string_view name) {
  const Result<std::int64_t> version = database.ask("PRAGMA user_version");
  if (!version) return fail(version);
  if (*version < format_that_misses_nothing) return std::nullopt;
  const Result<std::int64_t> said = about(database, name);
  if (!said) return fail(said);
  return *said;
}

Result<void> restore_relations(sqlite::Database& database, store::Store& store) {
  sqlite::Statement rows(database, "SELECT form FROM relations ORDER BY name");
  std::vector<Relation> relations;
  for (Result<bool> row = rows.step(); !row || *row; row = rows.step()) {
    if (!row) return fail(row);
    const Result<Datum> form = read_one(rows.text(0));
    if (!form) return damaged("a relation is damaged: " + form.error().sentence);
    Result<Relation> relation = relation_from_datum(*form);
    if (!relation) return damaged("a relation is damaged: " + relation.error().sentence);
    relations.push_back(std::move(*relation));
  }
  const Result<std::vector<Relation>> declared = store.declare(relations);
  if (!declared) return fail(declared);
  return {};
}

Result<void> restore_facts(sqlite::Database& database, store::Store& store) {
  sqlite::Statement rows(database, "SELECT id, taken, form, sum FROM facts ORDER BY id");
  std::int64_t all = 0;
  for (Result<bool> row = rows.step(); !row || *row; row = rows.step()) {
    if (!row) return fail(row);
    const auto id = static_cast<FactId>(rows.integer(0));
    const auto state = static_cast<store::Restored>(rows.integer(1));
    Result<Fact> fact = fact_from_row(id, state, rows.text(2), rows.integer(3));
    if (!fact) return fail(fact);
    const Result<void> restored = store.restore(std::move(*fact), state);
    if (!restored) return damaged_fact(id, restored.error().sentence);
    all += added_to_facts(rows.integer(3));
  }
  const Result<std::optional<std::int64_t>> said = about_if_said(database, "facts");
  if (!said) return fail(said);
  if (said->value_or(all) != all) return damaged("facts are missing of those that stood where it begins");
  return {};
}

Result<PlayedBack> restore_log(sqlite::Database& database, store::Store& store, const Moment& until, LineStart to) {
  sqlite::Statement rows(database, "SELECT number, lines, replies, sum, revision, time FROM log ORDER BY number");
  const Result<std::optional<std::int64_t>> forgotten = about_if_said(database, "forgotten");
  if (!forgotten) return fail(forgotten);
  std::optional<std::int64_t> expected = forgotten->transform([](std::int64_t number) { return number + 1; });
  std::string later;
  for (Result<bool> row = rows.step(); !row || *row; row = rows.step()) {
    if (!row) return fail(row);
    const std::int64_t number = rows.integer(0);
    if (expected && number != *expected) return damaged("entry " + std::to_string(*expected) + " is missing");
    expected = number + 1;
    const auto bad = [number](const std::string& why) {
      return damaged("entry " + std::to_string(number) + " is damaged: " + why);
    };
    if (!is_sum_of_group(rows.integer(3), number, rows.text(1), rows.text(2))) return bad("its checksum does not fit");
    const LineStart last = start_of_last_line(rows.text(1));
    const LineStart said{static_cast<Revision>(rows.integer(4)), Time(Duration(rows.integer(5)))};
    if (last.revision != said.revision || last.when != said.when) return bad("it ends at another moment than it says");
    if (!later.empty()) {
      later += rows.text(1);
      continue;
    }
    const Result<std::string_view> rest = replay(rows.text(1), store, until);
    if (!rest) return bad(rest.error().sentence);
    later = *rest;
    const std::string_view played = rows.text(1).substr(0, rows.text(1).size() - rest->size());
    if (!played.empty()) to = start_of_last_line(played);
  }
  return PlayedBack{to, std::move(later)};
}

}  // namespace

Result<sqlite::Database> open(const Disk& disk, const std::string& path, sqlite::Access access) {
  Result<sqlite::Database> database = sqlite::Database::open(path, access, disk.vfs());
  if (!database) return database;
  Result<void> set = database->run(wait_for_others);
  if (set) set = database->run("PRAGMA cell_size_check = ON; PRAGMA cache_size = -8000");
  if (!set) return fail(set);
  // A board that was killed while it began leaves a file with nothing in it.
  const Result<std::int64_t> tables = database->ask("SELECT count(*) FROM sqlite_master");
  if (!tables) return fail(tables);
  if (*tables == 0 && access == sqlite::Access::write) {
    set = database->run("PRAGMA journal_mode = WAL");
    if (set) set = run_and_seal(*database, schema);
    if (!set) return fail(set);
  }
  const Result<std::int64_t> kind = database->ask("PRAGMA application_id");
  if (!kind) return fail(kind);
  if (*kind != application) return fail("damaged", "it is not a journal");
  const Result<std::int64_t> version = database->ask("PRAGMA user_version");
  if (!version) return fail(version);
  if (*version == format) return database;
  if (*version < format_without_head_sum || *version > format) {
    return fail("damaged", "it is a journal of another format, " + std::to_string(*version));
  }
  if (access == sqlite::Access::write) {
    // What is damaged must not be summed up anew.
    set = check_head(*database);
    const bool believed = *version < format_that_misses_nothing;
    if (set) set = run_and_seal(*database, believed ? to_this_format_from_the_first : to_this_format);
  }
  if (!set) return fail(set);
  return database;
}

Result<void> check_head(sqlite::Database& database) {
  const Result<std::int64_t> version = database.ask("PRAGMA user_version");
  if (!version) return fail(version);
  if (*version == format_without_head_sum) return {};
  const Result<std::int64_t> said = about(database, "sum");
  if (!said) return fail(said);
  const Result<std::int64_t> sum = sum_of_head(database);
  if (!sum) return fail(sum);
  if (*sum == *said) return {};
  return damaged("where it begins, or a relation, is damaged: their checksum does not fit");
}

Result<void> seal_head(sqlite::Database& database) {
  const Result<std::int64_t> sum = sum_of_head(database);
  if (!sum) return fail(sum);
  sqlite::Statement row(database, "INSERT OR REPLACE INTO about VALUES ('sum', ?)");
  return row.bind(1, *sum).run();
}

std::int64_t sum_of_fact(FactId id, store::Restored state, std::string_view form) {
  return Checksum().add(id).add(static_cast<std::uint64_t>(state)).add(form).value();
}

Result<Fact> fact_from_row(FactId id, store::Restored state, std::string_view form, std::int64_t sum) {
  if (sum_of_fact(id, state, form) != sum) return damaged_fact(id, "its checksum does not fit");
  const Result<Datum> read = read_one(form, fact_limits, "journal");
  if (!read) return damaged_fact(id, read.error().sentence);
  Result<Fact> fact = wire::fact_from_datum(*read);
  if (!fact) return damaged_fact(id, fact.error().sentence);
  return fact;
}

std::int64_t sum_of_group(std::int64_t number, std::string_view lines, std::string_view replies) {
  return Checksum().add(static_cast<std::uint64_t>(number)).add_words(lines).add_words(replies).value();
}

std::int64_t former_sum_of_group(std::int64_t number, std::string_view lines, std::string_view replies) {
  return Checksum().add(static_cast<std::uint64_t>(number)).add(lines.size()).add(lines).add(replies).value();
}

bool is_sum_of_group(std::int64_t sum, std::int64_t number, std::string_view lines, std::string_view replies) {
  return sum == sum_of_group(number, lines, replies) || sum == former_sum_of_group(number, lines, replies);
}

Result<std::int64_t> about(sqlite::Database& database, std::string_view name) {
  sqlite::Statement row(database, "SELECT value FROM about WHERE name = ?");
  const Result<bool> found = row.bind(1, name).step();
  if (!found) return fail(found);
  if (!*found) return fail("damaged", "it does not say its " + std::string(name));
  return row.integer(0);
}

Result<void> set_about(sqlite::Database& database, std::string_view name, std::int64_t value) {
  sqlite::Statement row(database, "UPDATE about SET value = ? WHERE name = ?");
  return row.bind(1, value).bind(2, name).run();
}

Result<PlayedBack> restore(sqlite::Database& database, store::Store& store, const Moment& until) {
  // One view of the file, whatever is written meanwhile.
  sqlite::Transaction reading(database);
  const Result<void> begun = reading.begin_reading();
  if (!begun) return fail(begun);
  const Result<void> whole = check_head(database);
  if (!whole) return fail(whole);
  const Result<std::int64_t> horizon = about(database, "horizon");
  if (!horizon) return fail(horizon);
  const Result<std::int64_t> horizon_time = about(database, "horizon-time");
  if (!horizon_time) return fail(horizon_time);
  const Result<std::int64_t> next_fact = about(database, "next-fact");
  if (!next_fact) return fail(next_fact);
  const auto oldest = static_cast<Revision>(*horizon);
  if (is_beyond({oldest, Time(Duration(*horizon_time))}, until)) {
    return fail("forgotten", "the journal goes back to revision " + std::to_string(oldest) + " only", to_datum(oldest));
  }
  Result<void> restored = restore_relations(database, store);
  if (restored) restored = restore_facts(database, store);
  if (!restored) return fail(restored);
  store.restore_counters(oldest, static_cast<FactId>(*next_fact));
  return restore_log(database, store, until, {oldest, Time(Duration(*horizon_time))});
}

Result<std::vector<RememberedReply>> remembered(sqlite::Database& database, Duration length) {
  sqlite::Statement rows(database, "SELECT time, replies FROM log ORDER BY number DESC");
  std::vector<RememberedReply> replies;
  std::map<std::uint64_t, std::size_t> of_session;
  std::optional<std::int64_t> newest;
  for (Result<bool> row = rows.step(); !row || *row; row = rows.step()) {
    if (!row) return fail(row);
    if (!newest) newest = rows.integer(0);
    if (rows.integer(0) < *newest - length.count() || replies.size() > most_replies) break;
    std::optional<std::vector<RememberedReply>> group = replies_from(rows.text(1));
    if (!group) return damaged("a remembered reply is damaged");
    for (auto reply = group->rbegin(); reply != group->rend(); ++reply) {
      if (++of_session[reply->session] <= replies_of_session) replies.push_back(std::move(*reply));
    }
  }
  std::ranges::reverse(replies);
  return replies;
}

Failure failure_of(const Failure& failure, const std::string& path) {
  Failure told = failure;
  told.sentence = path + ": " + failure.sentence;
  if (failure.symbol == "disk-full") told.symbol = "journal-full";
  if (failure.symbol == "damaged") told.symbol = "bad-journal";
  if (failure.symbol == "busy" || failure.symbol == "unusable") told.symbol = "journal-file";
  return told;
}

}  // namespace pizarra::journal::journal_tables
