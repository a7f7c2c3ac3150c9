#include "blackboard/limits.hpp"

#include <algorithm>
#include <string>

namespace pizarra {

Weight& Weight::operator+=(const Weight& other) {
  bytes += other.bytes;
  elements += other.elements;
  depth = std::max(depth, other.depth);
  return *this;
}

namespace {

// Adds what the datum weighs, inside `depth` lists.
void add(const Datum& datum, std::size_t depth, Weight& whole) {
  constexpr std::size_t longest_number = 26;
  ++whole.elements;
  switch (datum.kind()) {
    case Datum::Kind::symbol:
      whole.bytes += datum.text().size() + 1;
      return;
    case Datum::Kind::string:
      whole.bytes += 2 * datum.text().size() + 3;
      return;
    case Datum::Kind::integer:
    case Datum::Kind::real:
      whole.bytes += longest_number;
      return;
    case Datum::Kind::list:
      break;
  }
  whole.bytes += 3;
  whole.depth = std::max(whole.depth, depth + 1);
  for (const Datum& item : datum.items()) add(item, depth + 1, whole);
}

}  // namespace

Weight weigh(const Datum& datum) {
  Weight whole;
  add(datum, 0, whole);
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

Result<void> check_weight(const Weight& weight, const char* what) {
  const auto refuse = [&](const char* measure, std::size_t value, std::size_t bound) {
    return fail("too-large", std::string(what) + " takes " + std::to_string(value) + " " + measure + ", and " +
                                 std::to_string(bound) + " are the most");
  };
  if (weight.depth > limits::depth) return refuse("levels of lists", weight.depth, limits::depth);
  if (weight.bytes > limits::bytes) return refuse("bytes", weight.bytes, limits::bytes);
  if (weight.elements > limits::elements) return refuse("elements", weight.elements, limits::elements);
  return {};
}

}  // namespace pizarra
