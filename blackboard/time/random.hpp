#pragma once

// Seeded random numbers that are the same on every machine (the standard's distributions are not).
//
//   Random random(seed);
//   Random noise = random.split("camera");    // a stream of its own, which others' draws do not disturb

#include <cstdint>
#include <string_view>

namespace pizarra {

class Random {
 public:
  explicit Random(std::uint64_t seed);
  Random split(std::string_view purpose) const;
  std::uint64_t bits();
  // Uniform in [low, high).
  double uniform(double low, double high);
  // Uniform in 0..bound-1; bound at least 1.
  std::uint64_t below(std::uint64_t bound);
  // Normal with mean 0 and standard deviation 1.
  double normal();

 private:
  std::uint64_t seed_;
  std::uint64_t state_[4];
};

}  // namespace pizarra
