#pragma once

// The levels of some pixels: their median, and which share of them lies near it.
//
//   GreyLevels levels;
//   levels.add(image.ptr<std::uint8_t>(y), first, end);
//   levels.median();

#include <algorithm>
#include <array>
#include <cstdint>

namespace pizarra::vision {

// At most 65535 pixels.
class GreyLevels {
 public:
  void add(const std::uint8_t* row, int first, int end) {
    for (int x = first; x < end; ++x) ++counts_[row[x]];
    total_ += end - first;
  }
  void add(std::uint8_t level) {
    ++counts_[level];
    ++total_;
  }
  int total() const { return total_; }
  int median() const {
    int level = 0;
    int seen = 0;
    // Whole blocks first: their sums are quick.
    for (; level + block < 256; level += block) {
      const int sum = sum_of_block(level);
      if (2 * (seen + sum) >= total_) break;
      seen += sum;
    }
    while (level < 255 && 2 * (seen += counts_[static_cast<std::size_t>(level)]) < total_) ++level;
    return level;
  }
  bool are_near(int level, int tolerance, double share) const {
    int near = 0;
    for (int i = std::max(0, level - tolerance); i <= std::min(255, level + tolerance); ++i) {
      near += counts_[static_cast<std::size_t>(i)];
    }
    return near >= share * total_;
  }

 private:
  static constexpr int block = 16;
  int sum_of_block(int first) const {
    std::uint16_t sum = 0;
    for (int i = first; i < first + block; ++i) sum += counts_[static_cast<std::size_t>(i)];
    return sum;
  }

  std::array<std::uint16_t, 256> counts_{};
  int total_ = 0;
};

}  // namespace pizarra::vision
