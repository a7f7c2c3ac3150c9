#include "blackboard/time/random.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace pizarra {

namespace {

// SplitMix64 (Steele, Lea and Flood 2014): spreads a seed over the generator's state.
std::uint64_t split_mix(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

std::uint64_t rotate(std::uint64_t value, int by) { return (value << by) | (value >> (64 - by)); }

}  // namespace

Random::Random(std::uint64_t seed) : seed_(seed) {
  for (std::uint64_t& word : state_) word = split_mix(seed);
}

Random Random::split(std::string_view purpose) const {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : purpose) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::uint64_t mixed = seed_ ^ hash;
  return Random(split_mix(mixed));
}

// xoshiro256** (Blackman and Vigna 2018).
std::uint64_t Random::bits() {
  const std::uint64_t result = rotate(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = rotate(state_[3], 45);
  return result;
}

double Random::uniform(double low, double high) {
  const double unit = static_cast<double>(bits() >> 11) * 0x1p-53;
  return low + (high - low) * unit;
}

std::uint64_t Random::below(std::uint64_t bound) {
  assert(bound > 0);
  // Draws from the incomplete last stretch would favour small numbers.
  const std::uint64_t uneven = -bound % bound;
  std::uint64_t draw = bits();
  while (draw < uneven) draw = bits();
  return draw % bound;
}

// Box and Muller 1958; the second number is left, so that every draw stands for itself.
double Random::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0, 1)));
  return radius * std::cos(2.0 * std::numbers::pi * uniform(0, 1));
}

}  // namespace pizarra
