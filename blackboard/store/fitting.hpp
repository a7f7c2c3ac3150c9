#pragma once

// The checks of a transaction against a table, before it is done. All add to `examined` what they looked at
// (looking.hpp), and give up beyond its bound, for check_looking() to refuse.
//
//   std::size_t examined = 0;
//   const Fact* fact = first_fit(table, pattern, examined);
//   const Result<void> cheap = check_looking(examined, pattern);

#include <functional>

#include "blackboard/store/fact_table.hpp"

namespace pizarra::store {

// The one with the lowest id; null where none fits.
const Fact* first_fit(const FactTable& table, const Datum& pattern, std::size_t& examined);
// The first of those that count.
const Fact* first_fit(const FactTable& table, const Datum& pattern, std::size_t& examined,
                      const std::function<bool(const Fact&)>& counts);
// Whether none that fits came or went after the revision.
bool is_unchanged(const FactTable& table, const Datum& pattern, Revision since, std::size_t& examined);
// As finding all that fit will; answers how many these are, at most.
std::size_t look_for_all(const FactTable& table, const Datum& pattern, std::size_t& examined);
// Whether matching takes more than a glance at each argument.
bool compares_much(const Datum& pattern);

}  // namespace pizarra::store
