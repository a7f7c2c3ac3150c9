#pragma once

// Sets of small numbers as rows of machine words: facts and actions of one planning problem.
//
//   Bits facts(problem.facts.size());
//   facts.set(3);
//   facts |= other;
//   facts.for_each([&](std::size_t fact) { ... });      // ascending
//
// Two sets that are combined have the same size: anything else is a bug.

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pizarra::planner {

class Bits {
 public:
  Bits() = default;
  explicit Bits(std::size_t size) : words_((size + 63) / 64) {}

  void set(std::size_t index) { words_[index / 64] |= std::uint64_t{1} << (index % 64); }
  void reset(std::size_t index) { words_[index / 64] &= ~(std::uint64_t{1} << (index % 64)); }
  bool test(std::size_t index) const { return (words_[index / 64] >> (index % 64) & 1) != 0; }
  void clear() { words_.assign(words_.size(), 0); }

  Bits& operator|=(const Bits& other) {
    assert(words_.size() == other.words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
  }
  Bits& operator&=(const Bits& other) {
    assert(words_.size() == other.words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
  }
  // Removes what stands in the other.
  Bits& operator-=(const Bits& other) {
    assert(words_.size() == other.words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
    return *this;
  }

  bool any() const {
    for (const std::uint64_t word : words_) {
      if (word != 0) return true;
    }
    return false;
  }
  std::size_t count() const {
    std::size_t total = 0;
    for (const std::uint64_t word : words_) total += static_cast<std::size_t>(std::popcount(word));
    return total;
  }
  bool intersects(const Bits& other) const {
    assert(words_.size() == other.words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if ((words_[i] & other.words_[i]) != 0) return true;
    }
    return false;
  }
  bool subset_of(const Bits& other) const {
    assert(words_.size() == other.words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if ((words_[i] & ~other.words_[i]) != 0) return false;
    }
    return true;
  }

  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::uint64_t word = words_[i]; word != 0; word &= word - 1) {
        visit(i * 64 + static_cast<std::size_t>(std::countr_zero(word)));
      }
    }
  }

  // Ascending.
  std::vector<std::size_t> members() const {
    std::vector<std::size_t> all;
    for_each([&](std::size_t index) { all.push_back(index); });
    return all;
  }

  const std::vector<std::uint64_t>& words() const { return words_; }
  auto operator<=>(const Bits&) const = default;

 private:
  std::vector<std::uint64_t> words_;
};

struct HashBits {
  std::size_t operator()(const Bits& bits) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15;
    for (const std::uint64_t word : bits.words()) {
      hash = (hash ^ word) * 0xff51afd7ed558ccd;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

}  // namespace pizarra::planner
