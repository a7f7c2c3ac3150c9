#pragma once

// Hashes that nobody outside this process can foresee, so that no choice of values makes a table slow: every step folds
// a product with numbers that were drawn when the process first hashed. No hash may leave the process, and no order of
// hashes may be seen.
//
//   std::uint64_t hash = keyed_mix(keyed_mix(0, x), y);
//   std::uint64_t hash = keyed_hash("some text of at least sixteen bytes");

#include <array>
#include <cstdint>
#include <string_view>

namespace pizarra {

using HashKey = std::array<std::uint64_t, 2>;

HashKey draw_hash_key();

// In line, for whatever is told is hashed.
inline std::uint64_t keyed_mix(std::uint64_t a, std::uint64_t b) {
  static const HashKey key = draw_hash_key();
  __extension__ using Product = unsigned __int128;
  const auto product = Product{a ^ key[0]} * (b ^ key[1]);
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

// Shorter text than 16 bytes is the caller's to mix.
std::uint64_t keyed_hash(std::string_view text);

}  // namespace pizarra
