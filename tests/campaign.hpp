#pragma once

// How many cases a campaign tries: a few whenever the tests run, all of them in `./pizarra test --nightly`. The few
// come first, so that both try the same ones.
//
//   for (std::uint64_t seed = 1; seed <= campaign(40, 400); ++seed) ...

namespace pizarra {

// PIZARRA_NIGHTLY is set.
bool is_nightly();

template <typename Number>
Number campaign(Number few, Number all) {
  return is_nightly() ? all : few;
}

}  // namespace pizarra
