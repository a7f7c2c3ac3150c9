#include "blackboard/wire/answer_form.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::wire {

namespace {

std::unexpected<Failure> bad_answer(const char* sentence, const Datum& form) {
  return fail("bad-frame", sentence, form);
}

constexpr std::array<std::string_view, 5> kind_names = {"no", "yes", "first", "more", "last"};

// Reads the end of `(ID DATUM CAUSE ...)`, a fact told with `before`, at the same time by the same teller.
Result<Fact> fact_like(const Fact& before, const Datum& form) {
  const std::optional<FactId> id = count_from(form[0]);
  Result<std::vector<FactId>> because = ids_from(form.items().subspan(2));
  if (!id || *id == 0 || !because) return bad_answer("not a fact like the one before it", form);
  return Fact{.datum = form[1],
              .id = *id,
              .teller = before.teller,
              .when = before.when,
              .revision = before.revision,
              .because = std::move(*because)};
}

// To a client that keeps what it was sent, of a query whose answers are one fact.
Result<Delta::Side> kept_added_from_datum(const Datum& form) {
  Delta::Side side;
  side.answers = form.size();
  side.facts.reserve(form.size());
  for (const Datum& item : form.items()) {
    const bool alike = item.size() > 1 && item[1].is_list() && !side.facts.empty();
    Result<Fact> fact = alike ? fact_like(side.facts.back(), item) : fact_from_datum(item);
    if (!fact) return fail(fact);
    side.facts.push_back(std::move(*fact));
  }
  return side;
}

// And of what it keeps.
Result<Delta::Side> kept_removed_from_datum(const Datum& form) {
  Delta::Side side;
  side.answers = form.size();
  side.facts.reserve(form.size());
  for (const Datum& item : form.items()) {
    const std::optional<FactId> id = count_from(item);
    if (!id) return bad_answer("not the number of a fact that was sent", item);
    side.facts.push_back({.datum = {}, .id = *id, .teller = {}, .because = {}});
  }
  return side;
}

Result<Delta::Side> side_from_datum(std::size_t width, const Datum& form) {
  Delta::Side side;
  side.answers = form.size();
  side.facts.reserve(side.answers * width);
  for (const Datum& answer : form.items()) {
    if (!answer.is_list() || answer.size() != width) return bad_answer("an answer has another number of facts", answer);
    for (const Datum& item : answer.items()) {
      Result<Fact> fact = fact_from_datum(item);
      if (!fact) return fail(fact);
      side.facts.push_back(std::move(*fact));
    }
  }
  return side;
}

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
    if (answer.facts.size() >= form.size()) return bad_answer("an answer lacks a fact", form);
    Result<Fact> fact = fact_from_datum(form[answer.facts.size()]);
    if (!fact) return fail(fact);
    if (!match(clause.form, fact->datum, answer.bindings)) return bad_answer("a fact does not fit the query", form);
    answer.facts.push_back(std::move(*fact));
  }
  if (!form.is_list() || answer.facts.size() != form.size()) return bad_answer("an answer has a fact too many", form);
  return answer;
}

}  // namespace

Datum fact_to_datum(const Fact& fact) {
  std::vector<Datum> form = {to_datum(fact.id), to_datum(fact.revision), to_datum(fact.when.time_since_epoch().count()),
                             to_datum(fact.teller), fact.datum};
  for (const FactId cause : fact.because) form.push_back(to_datum(cause));
  return Datum::list(std::move(form));
}

Result<Fact> fact_from_datum(const Datum& form) {
  if (form.size() < 5 || !form[2].is_integer() || !form[3].is_string() || !form[4].is_list()) {
    return bad_answer("not a fact with its provenance", form);
  }
  const std::optional<std::uint64_t> id = count_from(form[0]);
  const std::optional<std::uint64_t> revision = count_from(form[1]);
  Result<std::vector<FactId>> because = ids_from(form.items().subspan(5));
  if (!id || *id == 0 || !revision || !because) return bad_answer("not a fact with its provenance", form);
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

Datum answers_to_datum(const Answers& answers) {
  std::vector<Datum> value = {to_datum(answers.revision)};
  value.reserve(answers.answers.size() + 1);
  for (const Answer& answer : answers.answers) value.push_back(answer_to_datum(answer));
  return Datum::list(std::move(value));
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
  if (name == kind_names.end() || !revision || !form[4].is_symbol()) return bad_answer("not a change", form);
  if (!form[5].is_list() || !form[6].is_list()) return bad_answer("not two lists of answers", form);
  const std::size_t width = width_of(query);
  const bool short_form = kept && width == 1;
  Result<Delta::Side> added = short_form ? kept_added_from_datum(form[5]) : side_from_datum(width, form[5]);
  if (!added) return fail(added);
  Result<Delta::Side> removed = short_form ? kept_removed_from_datum(form[6]) : side_from_datum(width, form[6]);
  if (!removed) return fail(removed);
  Delta delta;
  delta.revision = *revision;
  delta.kind = static_cast<Delta::Kind>(name - kind_names.begin());
  delta.added = std::move(*added);
  delta.removed = std::move(*removed);
  return delta;
}

}  // namespace pizarra::wire
