#include "blackboard/limits.hpp"

#include <algorithm>
#include <string>

#include "lisp/escapes.hpp"

namespace pizarra {

Weight& Weight::operator+=(const Weight& other) {
  bytes += other.bytes;
  elements += other.elements;
  depth = std::max(depth, other.depth);
  return *this;
}

namespace {

std::size_t escapes_in(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += static_cast<std::size_t>(needs_escape(c));
  return count;
}

// Of a datum that is no list.
std::size_t bytes_of(const Datum& datum) {
  constexpr std::size_t longest_number = 26;
  const Datum::Kind kind = datum.kind();
  if (kind == Datum::Kind::integer || kind == Datum::Kind::real) return longest_number;
  const std::string_view text = datum.text();
  return kind == Datum::Kind::symbol ? text.size() + 1 : text.size() + escapes_in(text) + 3;
}

// Adds what the list weighs, inside `depth` others.
void add_list(const Datum& list, std::size_t depth, Weight& whole) {
  const std::span<const Datum> items = list.items();
  std::size_t bytes = 3;
  for (const Datum& item : items) {
    if (item.is_list()) {
      add_list(item, depth + 1, whole);
    } else {
      bytes += bytes_of(item);
    }
  }
  whole.bytes += bytes;
  whole.elements += items.size();
  whole.depth = std::max(whole.depth, depth + 1);
}

}  // namespace

Weight weigh(const Datum& datum) {
  Weight whole{.bytes = 0, .elements = 1, .depth = 0};
  if (datum.is_list()) {
    add_list(datum, 0, whole);
  } else {
    whole.bytes = bytes_of(datum);
  }
  return whole;
}

Weight weigh(const Fact& fact) {
  constexpr std::size_t envelope_bytes = 120;
  constexpr std::size_t envelope_elements = 8;
  constexpr std::size_t id_bytes = 21;
  Weight weight = weigh(fact.datum);
  weight.bytes += envelope_bytes + 2 * fact.teller.size() + id_bytes * fact.because.size();
  weight.elements += envelope_elements + fact.because.size();
  return weight;
}

std::size_t footprint(const Fact& fact, const Weight& of_its_datum) {
  constexpr std::size_t of_any_fact = 128;
  return of_any_fact + of_its_datum.bytes + sizeof(Datum) * of_its_datum.elements + fact.teller.size() +
         sizeof(FactId) * fact.because.size();
}

Result<void> check_examined(std::size_t examined, const Datum& subject) {
  if (examined <= limits::examined) return {};
  return fail("too-costly",
              "this takes looking at more than 250000 facts, or comparing as much of them, one after another", subject);
}

Result<void> check_weight(const Weight& weight, const char* what) {
  const auto refuse = [&](const char* measure, std::size_t value, std::size_t bound) {
    return fail("too-large", std::string(what) + " takes up to " + std::to_string(value) + " " + measure + ", and " +
                                 std::to_string(bound) + " are the most");
  };
  if (weight.depth > limits::depth) return refuse("levels of lists", weight.depth, limits::depth);
  if (weight.bytes > limits::bytes) return refuse("bytes", weight.bytes, limits::bytes);
  if (weight.elements > limits::elements) return refuse("elements", weight.elements, limits::elements);
  return {};
}

}  // namespace pizarra
