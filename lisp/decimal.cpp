#include "lisp/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "lisp/characters.hpp"

namespace pizarra {

namespace {

// Two whole numbers below 2^53, the lower one a power of ten that a double holds exactly, are divided with one
// rounding: the quotient is the double nearest to the decimal (Clinger 1990, "How to read floating point numbers
// accurately").
constexpr std::ptrdiff_t most_digits = 15;
constexpr std::array<double, most_digits + 1> powers_of_ten = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

// Beyond so many, a sum of digits may not fit 64 bits.
constexpr std::ptrdiff_t most_whole_digits = 18;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Adds the digits from `at` on to `value`, and answers where they end.
const char* take_digits(const char* at, const char* end, std::uint64_t& value) {
  for (; at != end && is_digit(*at); ++at) value = value * 10 + static_cast<std::uint64_t>(*at - '0');
  return at;
}

bool ends_token(const char* at, const char* end) { return at == end || !is_symbol_char(*at); }

}  // namespace

Decimal read_decimal(std::string_view text) {
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const bool negative = begin != end && *begin == '-';
  const char* const whole = begin + (negative || (begin != end && *begin == '+') ? 1 : 0);
  std::uint64_t value = 0;
  const char* const whole_end = take_digits(whole, end, value);
  const std::ptrdiff_t whole_digits = whole_end - whole;
  if (whole_digits == 0 || whole_digits > most_whole_digits) return {};
  if (ends_token(whole_end, end)) {
    const auto integer = static_cast<std::int64_t>(value);
    return {Datum::integer(negative ? -integer : integer), static_cast<std::size_t>(whole_end - begin)};
  }
  if (*whole_end != '.') return {};
  const char* const behind = whole_end + 1;
  const char* const behind_end = take_digits(behind, end, value);
  const std::ptrdiff_t behind_digits = behind_end - behind;
  if (behind_digits == 0 || whole_digits + behind_digits > most_digits || !ends_token(behind_end, end)) return {};
  const auto digits = static_cast<double>(static_cast<std::int64_t>(value));
  const double real = digits / powers_of_ten[static_cast<std::size_t>(behind_digits)];
  return {Datum::real(negative ? -real : real), static_cast<std::size_t>(behind_end - begin)};
}

// A decimal of at most 15 digits that reads as the value is its shortest one: no other of so few digits reads the same.
char* write_decimal(char* out, double value) {
  constexpr int behind = 3;
  constexpr std::int64_t scale = 1000;
  constexpr double largest_scaled = 1e14;
  constexpr std::int64_t smallest_that_may_have_an_exponent = 100'000;
  const double scaled = std::abs(value) * scale;
  if (!(scaled < largest_scaled)) return nullptr;
  const auto digits = static_cast<std::int64_t>(scaled + 0.5);
  if (static_cast<double>(digits) / scale != std::abs(value)) return nullptr;
  const std::int64_t whole = digits / scale;
  std::int64_t fraction = digits % scale;
  if (fraction == 0 && whole >= smallest_that_may_have_an_exponent) return nullptr;
  if (value < 0) *out++ = '-';
  out = std::to_chars(out, out + longest_decimal, whole).ptr;
  *out++ = '.';
  for (int i = 0; i < behind && (i == 0 || fraction != 0); ++i) {
    *out++ = static_cast<char>('0' + fraction / 100);
    fraction = fraction % 100 * 10;
  }
  return out;
}

}  // namespace pizarra
