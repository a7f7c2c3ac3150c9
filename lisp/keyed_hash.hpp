#pragma once

// Hashes that nobody outside this process can foresee, so that no choice of values makes a table slow: every step folds
// a product with numbers that were drawn when the process first hashed. No hash may leave the process, and no order of
// hashes may be seen.
//
//   std::uint64_t hash = keyed_mix(keyed_mix(0, x), y);
//   std::uint64_t hash = keyed_hash("some text of at least sixteen bytes");

#include <cstdint>
#include <string_view>

namespace pizarra {

std::uint64_t keyed_mix(std::uint64_t a, std::uint64_t b);
// Shorter text than 16 bytes is the caller's to mix.
std::uint64_t keyed_hash(std::string_view text);

}  // namespace pizarra
