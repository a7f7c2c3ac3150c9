#include "blackboard/limits.hpp"

#include <string>

namespace pizarra {

Weight weigh(const Fact& fact) {
  constexpr std::size_t envelope_bytes = 120;
  constexpr std::size_t envelope_elements = 8;
  Weight weight = weigh(fact.datum);
  weight.bytes += envelope_bytes + 2 * fact.teller.size() + limits::id_bytes * fact.because.size();
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
              "this takes looking at more than " + std::to_string(limits::examined) +
                  " facts, or comparing as much of them, one after another",
              subject);
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
