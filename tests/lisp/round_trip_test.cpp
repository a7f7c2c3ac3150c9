#include <gtest/gtest.h>
#include <limits>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/lisp/random_datum.hpp"

namespace pizarra {
namespace {

TEST(RoundTrip, WhatIsWrittenReadsBackEqual) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Datum datum = RandomDatum(seed).any(6);
    const std::string text = write(datum);
    const auto back = read_one(text);
    ASSERT_TRUE(back) << text << "\n" << describe(back.error());
    EXPECT_EQ(*back, datum) << text;
    EXPECT_EQ(back->hash(), datum.hash());
    EXPECT_EQ(*back <=> datum, std::strong_ordering::equal);
    EXPECT_EQ(write(*back), text);
  }
}

TEST(RoundTrip, WhatIsNoDatumIsWrittenLikeOne) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Datum datum = RandomDatum(seed).any(0);
    std::string text = "(";
    if (datum.is_string()) write_string_to(text, datum.text());
    if (datum.is_integer()) write_number_to(text, datum.integer());
    if (datum.is_string() || datum.is_integer()) {
      EXPECT_EQ(text, "(" + write(datum));
    }
  }
  std::string text;
  write_number_to(text, std::numeric_limits<std::uint64_t>::max());
  write_number_to(text, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(text, "18446744073709551615-9223372036854775808");
}

TEST(RoundTrip, DamagedTextIsReadOrFailsOnceWithAPlace) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RandomDatum random(seed);
    std::string text = write(random.any(6));
    for (auto changes = 1 + random.below(3); changes > 0 && !text.empty(); --changes) {
      const std::size_t at = random.below(text.size());
      switch (random.below(4)) {
        case 0:
          text.resize(at);
          break;
        case 1:
          text[at] = static_cast<char>(random.below(256));
          break;
        case 2:
          text.insert(at, 1, "()\"\\;,.\xC3"[random.below(8)]);
          break;
        default:
          text.erase(at, 1);
      }
    }
    const auto read = read_one(text);
    if (read) {
      EXPECT_EQ(read_one(write(*read)), *read);
    } else {
      EXPECT_TRUE(read.error().place.starts_with("input:")) << describe(read.error());
      EXPECT_TRUE(is_string_text(describe(read.error())));
    }
    EXPECT_EQ(read_source(text, "input").has_value() || read_source(text, "input").error() == read.error(), true);
  }
}

TEST(RoundTrip, OrderIsTotalAndAgreesWithEquality) {
  RandomDatum random(11);
  for (int i = 0; i < 3000; ++i) {
    const Datum a = random.any(2);
    const Datum b = random.any(2);
    EXPECT_EQ(a == b, (a <=> b) == 0);
    EXPECT_EQ(a<b, b> a);
  }
}

}  // namespace
}  // namespace pizarra
