#include "blackboard/store/fitting.hpp"

#include "blackboard/store/looking.hpp"
#include "blackboard/store/narrowing.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::store {

namespace {

template <class Counts>
const Fact* first_of(const FactTable& table, const Datum& pattern, std::size_t& examined, const Counts& counts) {
  const Fact* first = nullptr;
  Looking looking(examined);
  table.visit(pattern, [&](const Fact& fact) {
    Bindings bindings;
    if (match(pattern, fact.datum, bindings) && counts(fact)) first = &fact;
    return first == nullptr && looking.at_one_more();
  });
  return first;
}

}  // namespace

const Fact* first_fit(const FactTable& table, const Datum& pattern, std::size_t& examined) {
  return first_of(table, pattern, examined, [](const Fact&) { return true; });
}

const Fact* first_fit(const FactTable& table, const Datum& pattern, std::size_t& examined,
                      const std::function<bool(const Fact&)>& counts) {
  return first_of(table, pattern, examined, counts);
}

bool is_unchanged(const FactTable& table, const Datum& pattern, Revision since, std::size_t& examined) {
  Looking looking(examined);
  return table.unchanged_since(pattern, since, looking);
}

bool compares_much(const Datum& pattern) {
  const auto arguments = pattern.items().subspan(1);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_named = is_variable(arguments[i]) && !arguments[i].is_symbol("?");
    if (arguments[i].is_list() || (is_named && argument_of(arguments[i], pattern) != i)) return true;
  }
  return false;
}

std::size_t look_for_all(const FactTable& table, const Datum& pattern, std::size_t& examined) {
  if (!compares_much(pattern)) {
    examined += table.candidates(pattern);
    return table.candidates(pattern);
  }
  std::size_t fitting = 0;
  Looking looking(examined);
  table.visit(pattern, [&](const Fact& fact) {
    Bindings bindings;
    if (match(pattern, fact.datum, bindings)) ++fitting;
    return looking.at_one_more();
  });
  return fitting;
}

}  // namespace pizarra::store
