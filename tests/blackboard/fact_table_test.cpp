#include "blackboard/store/fact_table.hpp"

#include <bit>
#include <gtest/gtest.h>
#include <unordered_set>

#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

// A hash without a key, as whoever floods a table would foresee it: of integers, and one after the other rotated in.
class Foreseen {
 public:
  static std::uint64_t hash(std::uint64_t value) { return mix(mix(0, value), integer); }
  static std::uint64_t value_with(std::uint64_t hash) { return std::rotr(hash * inverse ^ integer, 5) * inverse; }

 private:
  static constexpr std::uint64_t factor = 0x9e3779b97f4a7c15;
  static constexpr std::uint64_t inverse = 0xf1de83e19937733d;
  static_assert(factor * inverse == 1);
  static constexpr std::uint64_t integer = std::uint64_t{5} << 60;  // the second word of an integer
  static std::uint64_t mix(std::uint64_t seed, std::uint64_t value) { return (std::rotl(seed, 5) ^ value) * factor; }
};

TEST(FactTable, KeysChosenToShareAHashWithoutTheProcesssOwnNumbersShareNone) {
  const store::FactTable table(relation("(relation p ((x integer) (y integer)))"));
  std::unordered_set<std::size_t> hashes;
  constexpr std::uint64_t shared = 0x123456789abcdef0;
  for (std::uint64_t x = 0; x < 1000; ++x) {
    const std::uint64_t y = Foreseen::value_with(shared ^ std::rotl(Foreseen::hash(x), 7));
    ASSERT_EQ(std::rotl(Foreseen::hash(x), 7) ^ Foreseen::hash(y), shared);
    hashes.insert(table.key_hash(list("p"_sym, x, y)));
  }
  EXPECT_EQ(hashes.size(), 1000U);
}

}  // namespace
}  // namespace pizarra
