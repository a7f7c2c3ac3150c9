#include "agents/console/change_text.hpp"

#include <fmt/format.h>

#include "lisp/shortened.hpp"
#include "lisp/writer.hpp"

namespace pizarra::console {

namespace {

void add_item(std::string& items, const std::string& item) {
  if (!items.empty()) items += ',';
  items += item;
}

std::string fact_text(const Fact& fact) {
  std::string because;
  for (const FactId id : fact.because) add_item(because, std::to_string(id));
  return fmt::format("{{\"text\":{},\"teller\":{},\"when\":{},\"because\":[{}]}}", json_string(write(fact.datum)),
                     json_string(fact.teller), fact.when.time_since_epoch().count(), because);
}

std::string ids_of(const Answer& answer) {
  std::string ids;
  for (const Fact& fact : answer.facts) add_item(ids, std::to_string(fact.id));
  return ids;
}

std::string added_text(const Answer& answer) {
  std::string bindings;
  for (const auto& [variable, value] : answer.bindings.all()) {
    add_item(bindings, fmt::format("{}:{}", json_string(variable.text()), json_string(write(value))));
  }
  std::string facts;
  for (const Fact& fact : answer.facts) add_item(facts, fact_text(fact));
  return fmt::format("{{\"ids\":[{}],\"bindings\":{{{}}},\"facts\":[{}]}}", ids_of(answer), bindings, facts);
}

// A failure may repeat the question several times. Cut texts keep the answer to a long question short.
Failure in_short(const Failure& failure) {
  Failure said{shortened(failure.symbol, 100), shortened(failure.sentence, 700), failure.subject,
               shortened(failure.place, 300)};
  const std::string subject = write(failure.subject);
  if (subject.size() > 200) said.subject = Datum::string(shortened(subject, 200));
  return said;
}

// `of`: what is refused, a watch or a request.
std::string failed_text(std::string_view of, std::int64_t number, const Failure& failure) {
  const Failure said = in_short(failure);
  return fmt::format("{{\"{}\":{},\"error\":{},\"said\":{}}}", of, number, json_failure(said),
                     json_string(describe(said)));
}

}  // namespace

std::string change_text(std::int64_t watch, const Change& change) {
  std::string added;
  std::size_t told = 0;
  for (const Answer& answer : change.added) {
    if (told == most_answers || added.size() > most_answer_bytes) break;
    add_item(added, added_text(answer));
    ++told;
  }
  // A removed answer has a place in the page or has none; its identity is enough.
  std::string removed;
  for (const Answer& answer : change.removed) add_item(removed, fmt::format("[{}]", ids_of(answer)));
  return fmt::format(
      "{{\"watch\":{},\"revision\":{},\"resynchronised\":{},\"cut\":{},\"removed\":[{}],\"added\":[{}]}}", watch,
      change.revision, change.resynchronised, change.added.size() - told, removed, added);
}

std::string told_text(const Fact& fact) { return added_text(Answer{.bindings = {}, .facts = {fact}}); }

std::string failed_watch_text(std::int64_t watch, const Failure& failure) {
  return failed_text("watch", watch, failure);
}

std::string reply_text(std::int64_t request, const Datum& values) {
  std::string items;
  for (const Datum& value : values.items()) {
    add_item(items, json_string(value.is_string() ? std::string(value.text()) : write(value)));
  }
  return fmt::format("{{\"reply\":{},\"values\":[{}]}}", request, items);
}

std::string refusal_text(std::int64_t request, const Failure& failure) {
  return failed_text("reply", request, failure);
}

std::string of_the_past(std::string text, const std::string& past) {
  return past.empty() ? text : fmt::format("{{\"past\":{},{}", past, text.substr(1));
}

}  // namespace pizarra::console
