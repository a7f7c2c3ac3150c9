#include "lisp/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace pizarra {

namespace {

// Two whole numbers below 2^53, the lower one a power of ten that a double holds exactly, are divided with one
// rounding: the quotient is the double nearest to the decimal (Clinger 1990, "How to read floating point numbers
// accurately").
constexpr std::size_t most_digits = 15;
constexpr std::array<double, most_digits + 1> powers_of_ten = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Adds the digits that `text` begins with to `value`, takes them off, and says how many they are: of more than `most`,
// one more than that.
std::size_t take_digits(std::string_view& text, std::size_t most, std::int64_t& value) {
  std::size_t count = 0;
  while (count < text.size() && count <= most && is_digit(text[count])) value = value * 10 + (text[count++] - '0');
  text.remove_prefix(count);
  return count;
}

}  // namespace

bool read_decimal(std::string_view token, Datum& number) {
  const bool negative = token.starts_with('-');
  if (negative || token.starts_with('+')) token.remove_prefix(1);
  std::int64_t value = 0;
  const std::size_t whole = take_digits(token, most_digits, value);
  if (whole == 0 || whole > most_digits) return false;
  if (token.empty()) {
    number = Datum::integer(negative ? -value : value);
    return true;
  }
  if (token.front() != '.') return false;
  token.remove_prefix(1);
  const std::size_t behind = take_digits(token, most_digits - whole, value);
  if (behind == 0 || whole + behind > most_digits || !token.empty()) return false;
  const double real = static_cast<double>(value) / powers_of_ten[behind];
  number = Datum::real(negative ? -real : real);
  return true;
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
