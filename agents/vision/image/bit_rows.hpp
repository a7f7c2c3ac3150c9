#pragma once

// Sets of pixels, a bit each: rows of a fixed number of 64-bit words (for a mark), and whole images.
//
//   BitRow<1> row;
//   row.flip(3); row.flip(9); row.fill_between_flips();      // 3..8
//   row.for_each_run([](int first, int end) { ... });        // once, with 3 and 9

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace pizarra::vision {

// Calls run(first, end) for each stretch of set bits among `count` words.
template <typename Run>
void for_each_run_of_bits(const std::uint64_t* words, int count, Run&& run) {
  int first = -1;  // of the run that the words before this one left open
  for (int i = 0; i < count; ++i) {
    std::uint64_t word = words[i];
    if (first >= 0) {
      const int length = std::countr_one(word);
      if (length == 64) continue;
      run(first, 64 * i + length);
      first = -1;
      word &= ~std::uint64_t{0} << length;
    }
    while (word != 0) {
      const int begin = std::countr_zero(word);
      const int length = std::countr_one(word >> begin);
      if (begin + length == 64) {
        first = 64 * i + begin;
        break;
      }
      run(64 * i + begin, 64 * i + begin + length);
      word &= ~std::uint64_t{0} << (begin + length);
    }
  }
  if (first >= 0) run(first, 64 * count);
}

template <int words>
struct BitRow {
  std::array<std::uint64_t, words> bits;  // not set at first: these are made by the hundred

  void set(int x) { word_of(x) |= std::uint64_t{1} << (x & 63); }
  void flip(int x) { word_of(x) ^= std::uint64_t{1} << (x & 63); }

  // Every bit becomes the parity of the set ones up to it.
  void fill_between_flips() {
    std::uint64_t carried = 0;
    for (std::uint64_t& word : bits) {
      for (int step = 1; step < 64; step *= 2) word ^= word << step;
      word ^= carried;
      carried = (word >> 63) != 0 ? ~std::uint64_t{0} : 0;
    }
  }
  BitRow shifted_right() const {
    BitRow out;
    for (int i = 0; i < words; ++i) out.bits[i] = bits[i] << 1 | (i > 0 ? bits[i - 1] >> 63 : 0);
    return out;
  }
  BitRow shifted_left() const {
    BitRow out;
    for (int i = 0; i < words; ++i) out.bits[i] = bits[i] >> 1 | (i + 1 < words ? bits[i + 1] << 63 : 0);
    return out;
  }
  BitRow operator|(const BitRow& other) const {
    BitRow out;
    for (int i = 0; i < words; ++i) out.bits[i] = bits[i] | other.bits[i];
    return out;
  }
  BitRow operator&(const BitRow& other) const {
    BitRow out;
    for (int i = 0; i < words; ++i) out.bits[i] = bits[i] & other.bits[i];
    return out;
  }
  BitRow without(const BitRow& other) const {
    BitRow out;
    for (int i = 0; i < words; ++i) out.bits[i] = bits[i] & ~other.bits[i];
    return out;
  }
  template <typename Run>
  void for_each_run(Run&& run) const {
    for_each_run_of_bits(bits.data(), words, run);
  }
  // Quicker where few are set, and these apart.
  template <typename Bit>
  void for_each(Bit&& bit) const {
    for (int i = 0; i < words; ++i) {
      for (std::uint64_t word = bits[i]; word != 0; word &= word - 1) bit(64 * i + std::countr_zero(word));
    }
  }

 private:
  // Of pixels there are only those from 0 on: no sign need be looked at, and of one word no number.
  std::uint64_t& word_of(int x) { return bits[words == 1 ? 0 : static_cast<unsigned>(x) / 64]; }
};

class BitImage {
 public:
  BitImage(int width, int height)
      : width_(width),
        height_(height),
        words_a_row_((width + 63) / 64),
        words_(static_cast<std::size_t>(words_a_row_ * height)) {}

  int cols() const { return width_; }
  int rows() const { return height_; }
  int words_a_row() const { return words_a_row_; }
  std::uint64_t* row(int y) { return words_.data() + static_cast<std::ptrdiff_t>(y) * words_a_row_; }
  const std::uint64_t* row(int y) const { return words_.data() + static_cast<std::ptrdiff_t>(y) * words_a_row_; }
  // Of pixels by number, row by row.
  std::ptrdiff_t stride() const { return std::ptrdiff_t{64} * words_a_row_; }
  bool inside(std::ptrdiff_t index) const {
    const auto bit = static_cast<std::size_t>(index);
    return (words_[bit / 64] >> (bit % 64) & 1) != 0;
  }
  bool inside(int x, int y) const { return inside(y * stride() + x); }

 private:
  int width_;
  int height_;
  int words_a_row_;
  std::vector<std::uint64_t> words_;
};

}  // namespace pizarra::vision
