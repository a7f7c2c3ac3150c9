#include "blackboard/journal/journal_compaction.hpp"

#include <map>

#include "blackboard/journal/journal_tables.hpp"
#include "blackboard/store/durable_facts.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "lisp/writer.hpp"

namespace pizarra::journal::journal_tables {

namespace {

using Kind = store::Commit::Entry::Kind;

std::unexpected<Failure> missing(FactId id) { return fail("damaged", "fact " + std::to_string(id) + " is missing"); }

// The horizon while it moves: what comes and goes within one slice never reaches the table.
class Horizon {
 public:
  explicit Horizon(sqlite::Database& database) : database_(database) {}

  Result<void> read_about();
  // Of a new file: its horizon is this store.
  Result<void> begin_with(const store::Store& store, const LineStart& end);
  Result<void> apply(std::string_view lines);
  Result<void> write();

 private:
  struct Standing {
    Fact fact;
    store::Restored state = store::Restored::standing;
  };

  Result<void> apply_line(std::string_view line);
  Result<void> declare(const std::vector<Relation>& relations);
  Result<void> apply_entry(const store::Commit& commit, const store::Commit::Entry& entry);
  void remove(FactId id);
  // Brings the fact into memory.
  Result<Standing*> standing(FactId id);

  sqlite::Database& database_;
  LineStart at_;
  FactId next_fact_ = 1;
  std::map<FactId, Standing> standing_;
  std::vector<FactId> removed_;  // from the table
};

Result<void> Horizon::read_about() {
  const Result<std::int64_t> revision = about(database_, "horizon");
  const Result<std::int64_t> next_fact = about(database_, "next-fact");
  if (!revision) return fail(revision);
  if (!next_fact) return fail(next_fact);
  at_.revision = static_cast<Revision>(*revision);
  next_fact_ = static_cast<FactId>(*next_fact);
  return {};
}

Result<void> Horizon::begin_with(const store::Store& store, const LineStart& end) {
  at_ = end;
  next_fact_ = store.next_fact();
  for (auto& [fact, state] : store::durable_facts(store)) {
    const FactId id = fact.id;
    standing_[id] = {std::move(fact), state};
  }
  std::vector<Relation> relations;
  for (const auto& [name, table] : store.tables()) relations.push_back(table.relation());
  return declare(relations);
}

Result<void> Horizon::apply(std::string_view lines) {
  for (std::size_t end = lines.find('\n'); end != std::string_view::npos; end = lines.find('\n')) {
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end + 1);
    const Result<void> applied = apply_line(line);
    if (!applied) return applied;
    at_ = start_of_line(line);
  }
  return {};
}

Result<void> Horizon::apply_line(std::string_view line) {
  const auto read = read_journal_line(line);
  if (!read) return fail(read);
  if (const auto* declaration = std::get_if<Declaration>(&*read)) return declare(declaration->relations);
  const auto& commit = std::get<store::Commit>(*read);
  for (const store::Commit::Entry& entry : commit.entries) {
    const Result<void> applied = apply_entry(commit, entry);
    if (!applied) return applied;
  }
  return {};
}

Result<void> Horizon::declare(const std::vector<Relation>& relations) {
  sqlite::Statement insert(database_, "INSERT OR REPLACE INTO relations VALUES (?, ?)");
  for (const Relation& relation : relations) {
    const std::string form = pizarra::write(relation_to_datum(relation));
    const Result<void> inserted = insert.bind(1, relation.name).bind(2, form).run();
    if (!inserted) return inserted;
  }
  return {};
}

Result<void> Horizon::apply_entry(const store::Commit& commit, const store::Commit::Entry& entry) {
  const FactId id = entry.kind == Kind::returned ? entry.former : entry.fact.id;
  if (entry.kind == Kind::told) {
    standing_[id] = {entry.fact, entry.under_lease ? store::Restored::leased : store::Restored::standing};
    next_fact_ = id + 1;
    return {};
  }
  if (entry.kind == Kind::retracted || entry.kind == Kind::settled) {
    remove(id);
    return {};
  }
  const Result<Standing*> found = standing(id);
  if (!found) return fail(found);
  if (entry.kind == Kind::taken) {
    const bool leased = (*found)->state == store::Restored::leased;
    (*found)->state = leased ? store::Restored::taken_leased : store::Restored::taken;
    return {};
  }
  if (entry.kind != Kind::returned) {
    (*found)->state = entry.kind == Kind::leased ? store::Restored::leased : store::Restored::standing;
    return {};
  }
  Fact fact = (*found)->fact;
  remove(id);
  fact.id = entry.fact.id;
  fact.revision = commit.revision;
  next_fact_ = fact.id + 1;
  const FactId returned = fact.id;
  standing_[returned] = {std::move(fact), entry.under_lease ? store::Restored::leased : store::Restored::standing};
  return {};
}

void Horizon::remove(FactId id) {
  if (standing_.erase(id) == 0) removed_.push_back(id);
}

Result<Horizon::Standing*> Horizon::standing(FactId id) {
  const auto known = standing_.find(id);
  if (known != standing_.end()) return &known->second;
  sqlite::Statement row(database_, "SELECT form, taken, sum FROM facts WHERE id = ?");
  const Result<bool> found = row.bind(1, static_cast<std::int64_t>(id)).step();
  if (!found) return fail(found);
  if (!*found) return missing(id);
  const auto state = static_cast<store::Restored>(row.integer(1));
  Result<Fact> fact = fact_from_row(id, state, row.text(0), row.integer(2));
  if (!fact) return fail(fact);
  removed_.push_back(id);
  return &(standing_[id] = {std::move(*fact), state});
}

Result<void> Horizon::write() {
  const Result<std::int64_t> facts = about(database_, "facts");
  if (!facts) return fail(facts);
  std::int64_t all = *facts;
  sqlite::Statement erase(database_, "DELETE FROM facts WHERE id = ? RETURNING sum");
  for (const FactId id : removed_) {
    const Result<bool> erased = erase.bind(1, static_cast<std::int64_t>(id)).step();
    if (!erased) return fail(erased);
    if (!*erased) return missing(id);
    all -= added_to_facts(erase.integer(0));
    erase.reset();
  }
  sqlite::Statement insert(database_, "INSERT INTO facts VALUES (?, ?, ?, ?)");
  for (const auto& [id, standing] : standing_) {
    const std::string form = pizarra::write(wire::fact_to_datum(standing.fact));
    insert.bind(1, static_cast<std::int64_t>(id)).bind(2, static_cast<std::int64_t>(standing.state)).bind(3, form);
    const std::int64_t sum = sum_of_fact(id, standing.state, form);
    const Result<void> inserted = insert.bind(4, sum).run();
    if (!inserted) return inserted;
    all += added_to_facts(sum);
  }
  Result<void> set = set_about(database_, "facts", all);
  if (set) set = set_about(database_, "horizon", static_cast<std::int64_t>(at_.revision));
  if (set) set = set_about(database_, "horizon-time", at_.when.time_since_epoch().count());
  if (set) set = set_about(database_, "next-fact", static_cast<std::int64_t>(next_fact_));
  if (set) set = seal_head(database_);
  return set;
}

}  // namespace

Result<void> begin_at(sqlite::Database& database, const store::Store& store, const LineStart& end) {
  sqlite::Transaction transaction(database);
  Result<void> done = transaction.begin();
  Horizon horizon(database);
  if (done) done = horizon.begin_with(store, end);
  if (done) done = horizon.write();
  if (done) done = transaction.commit();
  return done;
}

Result<std::size_t> advance_horizon(sqlite::Database& database, Revision before_revision, Time before_time,
                                    std::size_t slice_bytes) {
  sqlite::Transaction transaction(database);
  const Result<void> begun = transaction.begin();
  if (!begun) return fail(begun);
  // What is damaged must not be summed up anew.
  const Result<void> whole = check_head(database);
  if (!whole) return fail(whole);
  Horizon horizon(database);
  const Result<void> read = horizon.read_about();
  if (!read) return fail(read);
  std::int64_t last = 0;
  std::size_t bytes = 0;
  {
    sqlite::Statement groups(database, "SELECT number, revision, time, lines, replies, sum FROM log ORDER BY number");
    for (Result<bool> group = groups.step(); bytes < slice_bytes; group = groups.step()) {
      if (!group) return fail(group);
      if (!*group || static_cast<Revision>(groups.integer(1)) >= before_revision) break;
      if (Time(Duration(groups.integer(2))) >= before_time) break;
      last = groups.integer(0);
      if (!is_sum_of_group(groups.integer(5), last, groups.text(3), groups.text(4))) {
        return fail("damaged", "entry " + std::to_string(last) + " is damaged: its checksum does not fit");
      }
      bytes += groups.text(3).size() + groups.text(4).size();
      const Result<void> applied = horizon.apply(groups.text(3));
      if (!applied) return fail(applied);
    }
  }
  if (last == 0) return std::size_t{0};
  sqlite::Statement forget(database, "DELETE FROM log WHERE number <= ?");
  Result<void> done = forget.bind(1, last).run();
  if (done) done = set_about(database, "forgotten", last);
  if (done) done = horizon.write();
  if (done) done = transaction.commit();
  if (!done) return fail(done);
  return bytes;
}

}  // namespace pizarra::journal::journal_tables
