#include "lisp/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace pizarra {
namespace {

std::string as_the_library_writes(double value) {
  std::array<char, 32> buffer;
  std::string text(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string written(double value) {
  std::array<char, longest_decimal> buffer;
  char* end = write_decimal(buffer.data(), value);
  return end == nullptr ? "" : std::string(buffer.data(), end);
}

// Most have few digits behind the point; the others are of any size, or next to one that has few.
double random_real(std::mt19937_64& random) {
  const auto digits = static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 63));
  const double few = digits / std::array{1.0, 10.0, 100.0, 1000.0, 1e4, 1e8}[random() % 6];
  if (random() % 4 != 0) return few;
  if (random() % 2 != 0) return std::nextafter(few, random() % 2 != 0 ? 1e300 : -1e300);
  const double any = std::bit_cast<double>(random());
  return std::isfinite(any) ? any : few;
}

TEST(Decimal, IsWrittenAsTheLibraryWritesIt) {
  std::mt19937_64 random(1);
  int written_here = 0;
  for (int i = 0; i < 300'000; ++i) {
    const double value = random_real(random);
    const std::string text = written(value == 0 ? 0 : value);
    if (text.empty()) continue;
    ++written_here;
    ASSERT_EQ(text, as_the_library_writes(value == 0 ? 0 : value));
  }
  EXPECT_GT(written_here, 50'000);
}

TEST(Decimal, OfFewDigitsIsWrittenHere) {
  EXPECT_EQ(written(0), "0.0");
  EXPECT_EQ(written(-0.001), "-0.001");
  EXPECT_EQ(written(112.25), "112.25");
  EXPECT_EQ(written(10000), "10000.0");
  EXPECT_EQ(written(99999.999), "99999.999");
  for (const double other : {100000.0, 0.0001, 1.0 / 3, 1e300, 99'999'999'999'999.5}) {
    EXPECT_EQ(written(other), "") << other;
  }
}

TEST(Decimal, IsReadAsTheLibraryReadsIt) {
  std::mt19937_64 random(2);
  int read_here = 0;
  for (int i = 0; i < 300'000; ++i) {
    std::string text(random() % 3, "+-"[random() % 2]);
    for (auto digits = random() % 21; digits > 0; --digits) text += static_cast<char>('0' + random() % 10);
    if (random() % 3 != 0) text.insert(random() % (text.size() + 1), 1, '.');
    const auto [number, length] = read_decimal(text + " 7");
    if (length == 0) continue;
    ++read_here;
    ASSERT_EQ(length, text.size());
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    if (number.is_integer()) {
      std::int64_t value = 0;
      ASSERT_EQ(std::from_chars(begin, end, value).ptr, end) << text;
      ASSERT_EQ(number.integer(), value) << text;
    } else {
      double value = 0;
      ASSERT_EQ(std::from_chars(begin, end, value).ptr, end) << text;
      ASSERT_EQ(number.number(), value) << text;
    }
  }
  EXPECT_GT(read_here, 50'000);
}

TEST(Decimal, OfOtherFormsIsNotReadHere) {
  for (const char* text : {"", "+", ".", ".5", "5.", "-", "--1", "1e3", "1.5e3", "1.2.3", "1x", "1.5x",
                           "1234567890123456789", "123456789012.3456", "0.1234567890123456789012345678901234567890"}) {
    EXPECT_EQ(read_decimal(text).length, 0U) << text;
  }
}

TEST(Decimal, EndsWhereNoSymbolGoesOn) {
  for (const char* text : {"1 2", "1)", "1,5", "1\"", "1"}) {
    const Decimal read = read_decimal(text);
    EXPECT_EQ(read.length, 1U) << text;
    EXPECT_EQ(read.number, Datum::integer(1)) << text;
  }
  const Decimal real = read_decimal("-2.5)");
  EXPECT_EQ(real.length, 4U);
  EXPECT_EQ(real.number, Datum::real(-2.5));
}

}  // namespace
}  // namespace pizarra
