#include "blackboard/wire/wire.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "blackboard/limits.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::wire {

namespace {

constexpr ReadLimits frame_limits = {
    .bytes = limits::frame_bytes, .depth = limits::frame_depth, .elements = limits::frame_elements};

std::unexpected<Failure> bad_frame(const char* sentence, const Datum& form) {
  return fail("bad-frame", sentence, form);
}

Result<std::vector<FactId>> ids_from(std::span<const Datum> forms) {
  std::vector<FactId> ids;
  for (const Datum& form : forms) {
    const std::optional<std::uint64_t> id = count_from(form);
    if (!id) return bad_frame("a cause is the id of a fact", form);
    ids.push_back(*id);
  }
  return ids;
}

Result<Transaction::Precondition> precondition_from_datum(const Datum& form) {
  if (form.is_form("present") && form.size() == 2) return Transaction::Present{form[1]};
  if (form.is_form("absent") && form.size() == 2) return Transaction::Absent{form[1]};
  if (form.is_form("unchanged") && form.size() == 3) {
    if (const auto revision = count_from(form[2])) return Transaction::Unchanged{form[1], *revision};
  }
  return bad_frame("not a precondition", form);
}

Result<Transaction::Step> step_from_datum(const Datum& form) {
  if (form.is_form("retract") && form.size() == 2) return Transaction::Retract{form[1]};
  if (form.is_form("settle") && form.size() == 2) {
    if (const auto taken = count_from(form[1])) return Transaction::Settle{*taken};
  }
  if (form.is_form("tell") && form.size() >= 3) {
    const std::optional<std::uint64_t> lease = count_from(form[2]);
    Result<std::vector<FactId>> because = ids_from(form.items().subspan(3));
    if (!because) return fail(because);
    if (lease) return Transaction::Tell{form[1], std::move(*because), *lease};
  }
  return bad_frame("not a step of a transaction", form);
}

// What `(ID DATUM CAUSE ...)` says after `before`, which was told at the same time by the same.
Result<Fact> fact_like(const Fact& before, const Datum& form) {
  const std::optional<FactId> id = count_from(form[0]);
  Result<std::vector<FactId>> because = ids_from(form.items().subspan(2));
  if (!id || *id == 0 || !because) return bad_frame("not a fact like the one before it", form);
  return Fact{.datum = form[1],
              .id = *id,
              .teller = before.teller,
              .when = before.when,
              .revision = before.revision,
              .because = std::move(*because)};
}

// To a client that keeps what it was sent, of a query whose answers are one fact.
Result<Delta::Side> kept_side_from_datum(const Datum& form) {
  Delta::Side side;
  side.answers = form.size();
  side.facts.reserve(form.size());
  for (const Datum& item : form.items()) {
    if (const auto id = count_from(item)) {
      side.facts.push_back({.datum = {}, .id = *id, .teller = {}, .because = {}});
      continue;
    }
    const bool alike = item.size() > 1 && item[1].is_list() && !side.facts.empty();
    Result<Fact> fact = alike ? fact_like(side.facts.back(), item) : fact_from_datum(item);
    if (!fact) return fail(fact);
    side.facts.push_back(std::move(*fact));
  }
  return side;
}

Result<Delta::Side> side_from_datum(std::size_t width, const Datum& form) {
  Delta::Side side;
  side.answers = form.size();
  side.facts.reserve(side.answers * width);
  for (const Datum& answer : form.items()) {
    if (!answer.is_list() || answer.size() != width) return bad_frame("an answer has another number of facts", answer);
    for (const Datum& item : answer.items()) {
      Result<Fact> fact = fact_from_datum(item);
      if (!fact) return fail(fact);
      side.facts.push_back(std::move(*fact));
    }
  }
  return side;
}

constexpr std::array<std::string_view, 5> kind_names = {"no", "yes", "first", "more", "last"};

// Each precondition and step as a form, one after another.
struct TransactionWriter {
  explicit TransactionWriter(std::string& text) : out(text) {}

  void operator()(const Transaction::Present& present) { write_form("(present ", present.pattern); }
  void operator()(const Transaction::Absent& absent) { write_form("(absent ", absent.pattern); }
  void operator()(const Transaction::Unchanged& unchanged) {
    write_form("(unchanged ", unchanged.pattern);
    add_number(unchanged.revision);
  }
  void operator()(const Transaction::Tell& tell) {
    write_form("(tell ", tell.fact);
    add_number(tell.lease);
    for (const FactId cause : tell.because) add_number(cause);
  }
  void operator()(const Transaction::Retract& retract) { write_form("(retract ", retract.pattern); }
  void operator()(const Transaction::Settle& settle) {
    out += "(settle)";
    add_number(settle.taken);
  }

  std::string& out;
  Weight weight;

 private:
  void write_form(std::string_view head, const Datum& datum) {
    out += head;
    write_to(out, datum);
    out += ')';
    weight += weigh(datum);
    weight.elements += 2;
  }
  // Into the form that was written last.
  void add_number(std::uint64_t number) {
    out.back() = ' ';
    write_number_to(out, number);
    out += ')';
    ++weight.elements;
  }
};

bool told_alike(const Fact& a, const Fact& b) {
  return a.revision == b.revision && a.when == b.when && a.teller == b.teller;
}

// `before` is the one that was written before it, where a fact told like that need not say so again.
void write_fact(std::string& out, const Fact& fact, const Fact* before = nullptr) {
  out += '(';
  write_number_to(out, fact.id);
  out += ' ';
  if (before == nullptr || !told_alike(*before, fact)) {
    write_number_to(out, fact.revision);
    out += ' ';
    write_number_to(out, fact.when.time_since_epoch().count());
    out += ' ';
    write_string_to(out, fact.teller);
    out += ' ';
  }
  write_to(out, fact.datum);
  for (const FactId cause : fact.because) {
    out += ' ';
    write_number_to(out, cause);
  }
  out += ')';
}

void write_facts(std::string& out, const Delta::Side& side) {
  out += " (";
  const Fact* before = nullptr;
  for (const Fact& fact : side.facts) write_fact(out, fact, std::exchange(before, &fact));
  out += ')';
}

void write_ids(std::string& out, const Delta::Side& side) {
  out += " (";
  for (const Fact& fact : side.facts) {
    write_number_to(out, fact.id);
    out += ' ';
  }
  out += ')';
}

void write_answers(std::string& out, std::size_t width, const Delta::Side& side) {
  out += " (";
  auto next = side.facts.begin();
  for (std::size_t answer = 0; answer < side.answers; ++answer) {
    out += '(';
    for (std::size_t i = 0; i < width; ++i) write_fact(out, *next++);
    out += ')';
  }
  out += ')';
}

Result<Answer> answer_from_datum(const Query& query, const Datum& form) {
  Answer answer;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind != Query::Clause::Kind::fact) continue;
    if (answer.facts.size() >= form.size()) return bad_frame("an answer lacks a fact", form);
    Result<Fact> fact = fact_from_datum(form[answer.facts.size()]);
    if (!fact) return fail(fact);
    if (!match(clause.form, fact->datum, answer.bindings)) return bad_frame("a fact does not fit the query", form);
    answer.facts.push_back(std::move(*fact));
  }
  if (!form.is_list() || answer.facts.size() != form.size()) return bad_frame("an answer has a fact too many", form);
  return answer;
}

}  // namespace

Result<Datum> read_frame(std::string_view text) { return read_one(text, frame_limits, "frame"); }

Result<std::vector<Datum>> read_messages(std::string_view frame) {
  Result<std::vector<Datum>> messages = read_all(frame, frame_limits, "frame");
  if (!messages || messages->size() <= most_messages) return messages;
  return fail("too-many", "a frame holds at most " + std::to_string(most_messages) + " messages");
}

std::optional<RequestId> request_begun(std::string_view frame, SessionId session) {
  const std::string begin = "(request " + std::to_string(session) + ' ';
  if (!frame.starts_with(begin)) return std::nullopt;
  frame.remove_prefix(begin.size());
  std::int64_t number = 0;
  const auto read = std::from_chars(frame.data(), frame.data() + frame.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr != frame.data() + frame.size() && *read.ptr == ' ';
  if (!whole || number < 0) return std::nullopt;
  return static_cast<RequestId>(number);
}

std::optional<std::uint64_t> count_from(const Datum& datum) {
  if (!datum.is_integer() || datum.integer() < 0) return std::nullopt;
  return static_cast<std::uint64_t>(datum.integer());
}

std::optional<std::uint64_t> count_at(const Datum& form, std::size_t index) {
  if (index >= form.size()) return std::nullopt;
  return count_from(form[index]);
}

Weight write_transaction(std::string& out, const Transaction& transaction) {
  TransactionWriter writer(out);
  out += "(transact (";
  for (const auto& precondition : transaction.preconditions) std::visit(writer, precondition);
  out += ") (";
  for (const Transaction::Step& step : transaction.steps) std::visit(writer, step);
  out += "))";
  return writer.weight;
}

Result<Transaction> transaction_from_datum(const Datum& body) {
  if (body.size() != 3 || !body[1].is_list() || !body[2].is_list()) return bad_frame("not a transaction", body);
  Transaction transaction;
  for (const Datum& form : body[1].items()) {
    Result<Transaction::Precondition> precondition = precondition_from_datum(form);
    if (!precondition) return fail(precondition);
    transaction.preconditions.push_back(std::move(*precondition));
  }
  transaction.steps.reserve(body[2].size());
  for (const Datum& form : body[2].items()) {
    Result<Transaction::Step> step = step_from_datum(form);
    if (!step) return fail(step);
    transaction.steps.push_back(std::move(*step));
  }
  return transaction;
}

Datum fact_to_datum(const Fact& fact) {
  std::vector<Datum> form = {to_datum(fact.id), to_datum(fact.revision), to_datum(fact.when.time_since_epoch().count()),
                             to_datum(fact.teller), fact.datum};
  for (const FactId cause : fact.because) form.push_back(to_datum(cause));
  return Datum::list(std::move(form));
}

Result<Fact> fact_from_datum(const Datum& form) {
  if (form.size() < 5 || !form[2].is_integer() || !form[3].is_string() || !form[4].is_list()) {
    return bad_frame("not a fact with its provenance", form);
  }
  const std::optional<std::uint64_t> id = count_from(form[0]);
  const std::optional<std::uint64_t> revision = count_from(form[1]);
  Result<std::vector<FactId>> because = ids_from(form.items().subspan(5));
  if (!id || *id == 0 || !revision || !because) return bad_frame("not a fact with its provenance", form);
  Fact fact;
  fact.id = *id;
  fact.revision = *revision;
  fact.when = Time(Duration(form[2].integer()));
  fact.teller = form[3].text();
  fact.datum = form[4];
  fact.because = std::move(*because);
  return fact;
}

Datum answer_to_datum(const Answer& answer) {
  std::vector<Datum> facts;
  facts.reserve(answer.facts.size());
  for (const Fact& fact : answer.facts) facts.push_back(fact_to_datum(fact));
  return Datum::list(std::move(facts));
}

Result<std::vector<Answer>> answers_from_datum(const Query& query, std::span<const Datum> forms) {
  std::vector<Answer> answers;
  answers.reserve(forms.size());
  for (const Datum& form : forms) {
    Result<Answer> answer = answer_from_datum(query, form);
    if (!answer) return fail(answer);
    answers.push_back(std::move(*answer));
  }
  return answers;
}

void write_change(std::string& out, WatchId watch, std::uint64_t sequence, std::size_t width, bool kept,
                  const Delta& delta) {
  out += "(change ";
  write_number_to(out, watch);
  out += ' ';
  write_number_to(out, sequence);
  out += ' ';
  write_number_to(out, delta.revision);
  out += ' ';
  out += kind_names[static_cast<std::size_t>(delta.kind)];
  if (kept && width == 1) {
    write_facts(out, delta.added);
    write_ids(out, delta.removed);
  } else {
    write_answers(out, width, delta.added);
    write_answers(out, width, delta.removed);
  }
  out += ')';
}

Result<Delta> delta_from_datum(const Query& query, bool kept, const Datum& form) {
  const auto name = std::ranges::find(kind_names, form.size() == 7 ? form[4].text() : std::string_view());
  const std::optional<std::uint64_t> revision = count_at(form, 3);
  if (name == kind_names.end() || !revision || !form[4].is_symbol()) return bad_frame("not a change", form);
  if (!form[5].is_list() || !form[6].is_list()) return bad_frame("not two lists of answers", form);
  const std::size_t width = width_of(query);
  const auto read_side = [&](const Datum& side) {
    return kept && width == 1 ? kept_side_from_datum(side) : side_from_datum(width, side);
  };
  Result<Delta::Side> added = read_side(form[5]);
  if (!added) return fail(added);
  Result<Delta::Side> removed = read_side(form[6]);
  if (!removed) return fail(removed);
  Delta delta;
  delta.revision = *revision;
  delta.kind = static_cast<Delta::Kind>(name - kind_names.begin());
  delta.added = std::move(*added);
  delta.removed = std::move(*removed);
  return delta;
}

}  // namespace pizarra::wire
