#include "agents/vision/image/light_map.hpp"

namespace pizarra {
namespace {

constexpr int cell_px = 16;
constexpr int least_pixels = 6;  // of a cell, for it to tell
// So many make quotients of products of two levels exact.
constexpr int reciprocal_bits = 24;

}  // namespace

LightMap::LightMap(cv::Size size)
    : columns_((size.width + cell_px - 1) / cell_px),
      rows_((size.height + cell_px - 1) / cell_px),
      cells_(static_cast<std::size_t>(columns_ * rows_)) {}

std::size_t LightMap::cell_at(int x, int y) const {
  return static_cast<std::size_t>(y / cell_px * columns_ + x / cell_px);
}

void LightMap::add(const std::uint8_t* row, int y, int first, int end) {
  all_.add(row, first, end);
  for (int x = first; x < end;) {
    const int cell_end = std::min((x / cell_px + 1) * cell_px, end);
    cells_[cell_at(x, y)].add(row, x, cell_end);
    x = cell_end;
  }
}

void LightMap::divide_out(cv::Mat1b& pixels) const {
  const auto usual = static_cast<std::uint64_t>(all_.median());
  std::vector<std::uint64_t> reciprocals;
  for (const int light : levels(static_cast<int>(usual))) {
    reciprocals.push_back((1 << reciprocal_bits) / static_cast<std::uint64_t>(light) + 1);
  }
  for (int y = 0; y < pixels.rows; ++y) {
    std::uint8_t* row = pixels.ptr<std::uint8_t>(y);
    for (int x = 0; x < pixels.cols; ++x) {
      const std::uint64_t level = row[x] * usual * reciprocals[cell_at(x, y)] >> reciprocal_bits;
      row[x] = static_cast<std::uint8_t>(std::min<std::uint64_t>(255, level));
    }
  }
}

std::vector<int> LightMap::levels(int usual) const {
  std::vector<int> out;
  for (const GreyLevels& cell : cells_) {
    const int level = cell.total() < least_pixels ? 0 : cell.median();
    out.push_back(2 * level > usual && level < 2 * usual ? level : 0);
  }
  for (int step = 0; step < std::max(columns_, rows_); ++step) {
    const std::vector<int> known = out;
    for (int i = 0; i < columns_ * rows_; ++i) {
      int& level = out[static_cast<std::size_t>(i)];
      if (level == 0) level = mean_around(known, i);
    }
  }
  for (int& level : out) level = level == 0 ? std::max(1, usual) : level;
  return out;
}

int LightMap::mean_around(const std::vector<int>& known, int cell) const {
  const int column = cell % columns_;
  const int row = cell / columns_;
  int sum = 0;
  int count = 0;
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y) {
    for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
      const int level = known[static_cast<std::size_t>(y * columns_ + x)];
      sum += level;
      count += level > 0 ? 1 : 0;
    }
  }
  return count == 0 ? 0 : sum / count;
}

}  // namespace pizarra
