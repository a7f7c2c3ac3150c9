#include "blackboard/journal/journal.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "blackboard/limits.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::journal {

using Kind = store::Commit::Entry::Kind;

namespace {

// A commit may put back everything there is at once, or remove it and tell as much as a frame holds.
constexpr std::size_t most_bytes_of_a_former = std::string_view(" (return  leased)").size() + 2 * 20;
constexpr std::size_t most_elements_of_a_former = 5;
constexpr ReadLimits line_limits = {.bytes = limits::facts * most_bytes_of_a_former + limits::frame_bytes,
                                    .depth = limits::frame_depth,
                                    .elements = limits::facts * most_elements_of_a_former + limits::frame_elements};

// By the kind of the entry.
constexpr std::array<std::string_view, 7> words = {"tell", "retract", "take", "settle", "return", "leased", "kept"};

constexpr std::size_t most_lines_fit = 256;

std::string line_start(Revision revision, Time when, const std::string& teller) {
  std::string line;
  line.reserve(most_lines_fit);
  write_number_to(line += '(', revision);
  write_number_to(line += ' ', when.time_since_epoch().count());
  write_string_to(line += ' ', teller);
  return line;
}

void write_id(std::string& out, FactId id) { write_number_to(out += ' ', id); }

void write_entry(std::string& out, const store::Commit::Entry& entry) {
  const Fact& fact = entry.fact;
  out += " (";
  out += words[static_cast<std::size_t>(entry.kind)];
  if (entry.kind == Kind::returned) write_id(out, entry.former);
  write_id(out, fact.id);
  if (entry.kind == Kind::told) {
    write_to(out += ' ', fact.datum);
    if (!fact.because.empty()) out += " (because";
    for (const FactId id : fact.because) write_id(out, id);
    if (!fact.because.empty()) out += ')';
  }
  out += entry.under_lease ? " leased)" : ")";
}

bool is_id(const Datum& datum) { return datum.is_integer() && datum.integer() > 0; }

bool read_told(const Datum& form, const store::Commit& commit, store::Commit::Entry& entry) {
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
    // 0 stands for no fact: a board takes it as a cause, and must read it back.
    if (!id.is_integer() || id.integer() < 0) return false;
    fact.because.push_back(static_cast<FactId>(id.integer()));
  }
  return true;
}

bool read_entry(const Datum& form, const store::Commit& commit, store::Commit::Entry& entry) {
  if (form.size() < 2 || !is_id(form[1])) return false;
  const auto word = std::ranges::find(words, form.head());
  if (word == words.end()) return false;
  entry.kind = static_cast<Kind>(word - words.begin());
  entry.fact.id = static_cast<FactId>(form[1].integer());
  if (entry.kind == Kind::told) return read_told(form, commit, entry);
  if (entry.kind == Kind::returned) {
    entry.under_lease = form.size() == 4 && form[3].is_symbol("leased");
    if (form.size() != (entry.under_lease ? 4 : 3) || !is_id(form[2])) return false;
    entry.former = entry.fact.id;
    entry.fact.id = static_cast<FactId>(form[2].integer());
    return true;
  }
  return form.size() == 2;
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

std::string journal_line(const store::Commit& commit) {
  std::string line = line_start(commit.revision, commit.when, commit.teller);
  for (const store::Commit::Entry& entry : commit.entries) write_entry(line, entry);
  line += ')';
  return line;
}

std::string journal_line(Revision revision, Time when, const std::string& teller,
                         const std::vector<Relation>& declared) {
  std::vector<Datum> declaration = {"declare"_sym};
  for (const Relation& relation : declared) declaration.push_back(relation_to_datum(relation));
  return line_start(revision, when, teller) + ' ' + write(Datum::list(std::move(declaration))) + ')';
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

Result<std::variant<Declaration, store::Commit>> read_journal_line(std::string_view line) {
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
  store::Commit commit;
  commit.revision = static_cast<Revision>(form[0].integer());
  commit.when = Time(Duration(form[1].integer()));
  commit.teller = form[2].text();
  for (const Datum& item : form.items().subspan(3)) {
    store::Commit::Entry entry{};
    if (!read_entry(item, commit, entry)) return bad_line(item);
    commit.entries.push_back(std::move(entry));
  }
  return commit;
}

Result<void> replay_line(std::string_view line, store::Store& store) {
  const auto read = read_journal_line(line);
  if (!read) return fail(read);
  if (const auto* commit = std::get_if<store::Commit>(&*read)) return store.apply(*commit);
  const Result<std::vector<Relation>> declared = store.declare(std::get<Declaration>(*read).relations);
  if (!declared) return fail(declared);
  return {};
}

Result<std::string_view> replay(std::string_view text, store::Store& store, const Moment& until) {
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

Failure failure_at(Revision revision, Failure failure) {
  if (failure.symbol != "undeclared-relation") return failure;
  const std::string when = revision == 0 ? ", before the first change of all, " : ", ";
  failure.sentence = "at revision " + std::to_string(revision) + when + failure.sentence;
  return failure;
}

}  // namespace pizarra::journal
