#include "blackboard/journal/journal.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

using Kind = Commit::Entry::Kind;

namespace {

// A commit may remove everything there is at once.
constexpr ReadLimits line_limits = {.bytes = 64 << 20, .depth = 64, .elements = 4'000'000};

std::vector<Datum> line_start(Revision revision, Time when, const std::string& teller) {
  return {to_datum(revision), to_datum(when.time_since_epoch().count()), to_datum(teller)};
}

Datum entry_to_datum(const Commit::Entry& entry) {
  const Fact& fact = entry.fact;
  switch (entry.kind) {
    case Kind::retracted:
      return list("retract"_sym, fact.id);
    case Kind::taken:
      return list("take"_sym, fact.id);
    case Kind::settled:
      return list("settle"_sym, fact.id);
    case Kind::returned:
      if (entry.under_lease) return list("return"_sym, entry.former, fact.id, "leased"_sym);
      return list("return"_sym, entry.former, fact.id);
    case Kind::leased:
      return list("leased"_sym, fact.id);
    case Kind::kept:
      return list("kept"_sym, fact.id);
    case Kind::told:
      break;
  }
  std::vector<Datum> told = {"tell"_sym, to_datum(fact.id), fact.datum};
  if (!fact.because.empty()) {
    std::vector<Datum> because = {"because"_sym};
    for (const FactId id : fact.because) because.push_back(to_datum(id));
    told.push_back(Datum::list(std::move(because)));
  }
  if (entry.under_lease) told.push_back("leased"_sym);
  return Datum::list(std::move(told));
}

bool is_id(const Datum& datum) { return datum.is_integer() && datum.integer() > 0; }

bool read_told(const Datum& form, const Commit& commit, Commit::Entry& entry) {
  Fact& fact = entry.fact;
  entry.under_lease = form.size() > 3 && form[form.size() - 1].is_symbol("leased");
  const std::size_t size = form.size() - (entry.under_lease ? 1 : 0);
  if (size < 3 || size > 4) return false;
  fact.datum = form[2];
  fact.teller = commit.teller;
  fact.when = commit.when;
  fact.revision = commit.revision;
  if (size == 3) return true;
  if (!form[3].is_form("because")) return false;
  for (const Datum& id : form[3].items().subspan(1)) {
    if (!is_id(id)) return false;
    fact.because.push_back(static_cast<FactId>(id.integer()));
  }
  return true;
}

bool read_entry(const Datum& form, const Commit& commit, Commit::Entry& entry) {
  if (form.size() < 2 || !is_id(form[1])) return false;
  entry.fact.id = static_cast<FactId>(form[1].integer());
  if (form.is_form("tell")) {
    entry.kind = Kind::told;
    return read_told(form, commit, entry);
  }
  if (form.is_form("return")) {
    entry.under_lease = form.size() == 4 && form[3].is_symbol("leased");
    if (form.size() != (entry.under_lease ? 4 : 3) || !is_id(form[2])) return false;
    entry.kind = Kind::returned;
    entry.former = entry.fact.id;
    entry.fact.id = static_cast<FactId>(form[2].integer());
    return true;
  }
  constexpr std::array<std::pair<std::string_view, Kind>, 5> plain = {{{"retract", Kind::retracted},
                                                                       {"take", Kind::taken},
                                                                       {"settle", Kind::settled},
                                                                       {"leased", Kind::leased},
                                                                       {"kept", Kind::kept}}};
  const auto kind = std::ranges::find(plain, form.head(), &std::pair<std::string_view, Kind>::first);
  if (kind == plain.end() || form.size() != 2) return false;
  entry.kind = kind->second;
  return true;
}

Result<std::vector<Relation>> read_declaration(const Datum& form) {
  std::vector<Relation> relations;
  for (const Datum& item : form.items().subspan(1)) {
    Result<Relation> relation = relation_from_datum(item);
    if (!relation) return fail(relation);
    relations.push_back(std::move(*relation));
  }
  return relations;
}

std::unexpected<Failure> bad_line(const Datum& line) { return fail("bad-journal", "not a line of a journal", line); }

}  // namespace

std::string journal_line(const Commit& commit) {
  std::vector<Datum> line = line_start(commit.revision, commit.when, commit.teller);
  for (const Commit::Entry& entry : commit.entries) line.push_back(entry_to_datum(entry));
  return write(Datum::list(std::move(line)));
}

std::string journal_line(Revision revision, Time when, const std::string& teller,
                         const std::vector<Relation>& declared) {
  std::vector<Datum> declaration = {"declare"_sym};
  for (const Relation& relation : declared) declaration.push_back(relation_to_datum(relation));
  std::vector<Datum> line = line_start(revision, when, teller);
  line.push_back(Datum::list(std::move(declaration)));
  return write(Datum::list(std::move(line)));
}

LineStart start_of_line(std::string_view line) {
  LineStart start;
  const char* const end = line.data() + line.size();
  const auto revision = std::from_chars(line.data() + std::min<std::size_t>(1, line.size()), end, start.revision);
  Duration::rep microseconds = 0;
  if (revision.ptr != end) std::from_chars(revision.ptr + 1, end, microseconds);
  start.when = Time(Duration(microseconds));
  return start;
}

LineStart start_of_last_line(std::string_view lines) {
  if (!lines.empty()) lines.remove_suffix(1);
  return start_of_line(lines.substr(lines.rfind('\n') + 1));
}

Result<std::variant<Declaration, Commit>> read_journal_line(std::string_view line) {
  const Result<Datum> read = read_one(line, line_limits, "journal");
  if (!read) return fail(read);
  const Datum& form = *read;
  if (form.size() < 4 || !form[0].is_integer() || form[0].integer() < 0 || !form[1].is_integer() ||
      !form[2].is_string()) {
    return bad_line(form);
  }
  if (form[3].is_form("declare")) {
    if (form.size() != 4) return bad_line(form);
    Result<std::vector<Relation>> relations = read_declaration(form[3]);
    if (!relations) return fail(relations);
    return Declaration{std::move(*relations)};
  }
  Commit commit;
  commit.revision = static_cast<Revision>(form[0].integer());
  commit.when = Time(Duration(form[1].integer()));
  commit.teller = form[2].text();
  for (const Datum& item : form.items().subspan(3)) {
    Commit::Entry entry{};
    if (!read_entry(item, commit, entry)) return bad_line(item);
    commit.entries.push_back(std::move(entry));
  }
  return commit;
}

Result<void> replay_line(std::string_view line, Store& store) {
  const auto read = read_journal_line(line);
  if (!read) return fail(read);
  if (const auto* commit = std::get_if<Commit>(&*read)) return store.apply(*commit);
  const Result<std::vector<Relation>> declared = store.declare(std::get<Declaration>(*read).relations);
  if (!declared) return fail(declared);
  return {};
}

Result<std::string_view> replay(std::string_view text, Store& store, const Moment& until) {
  std::size_t number = 0;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    const std::string_view line = text.substr(0, end);
    if (is_beyond(start_of_line(line), until)) return text;
    text.remove_prefix(end + 1);
    ++number;
    Result<void> replayed = replay_line(line, store);
    if (replayed) continue;
    Failure failure = replayed.error();
    failure.sentence = "line " + std::to_string(number) + " of the journal: " + failure.sentence;
    return fail(failure);
  }
  return std::string_view();
}

}  // namespace pizarra
