#include "blackboard/store/compare_values.hpp"

#include <cmath>

namespace pizarra::store {

namespace {

// An integer and a real, exactly: a double does not hold every integer.
std::strong_ordering compare_numbers(std::int64_t integer, double real) {
  if (std::isnan(real)) return std::signbit(real) ? std::strong_ordering::greater : std::strong_ordering::less;
  if (real >= beyond_integers) return std::strong_ordering::less;
  if (real < -beyond_integers) return std::strong_ordering::greater;
  const double whole = std::floor(real);
  const std::strong_ordering order = integer <=> static_cast<std::int64_t>(whole);
  return order == 0 && real > whole ? std::strong_ordering::less : order;
}

}  // namespace

std::strong_ordering compare_values(const Datum& a, const Datum& b) {
  if (a.is_integer() && b.is_real()) return compare_numbers(a.integer(), b.number());
  if (a.is_real() && b.is_integer()) return 0 <=> compare_numbers(b.integer(), a.number());
  // Zero is zero whatever its sign.
  if (a.is_real() && b.is_real()) return std::strong_order(a.number() + 0.0, b.number() + 0.0);
  return a <=> b;
}

}  // namespace pizarra::store
