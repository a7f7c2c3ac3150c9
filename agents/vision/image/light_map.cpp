#include "agents/vision/image/light_map.hpp"

namespace pizarra::vision {
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
  const int usual = all_.median();
  const std::vector<int> light = levels(usual);
  for (int i = 0; i < columns_ * rows_; ++i) {
    const cv::Rect cell(i % columns_ * cell_px, i / columns_ * cell_px, cell_px, cell_px);
    const auto unit = static_cast<std::uint64_t>((1 << reciprocal_bits) / light[static_cast<std::size_t>(i)] + 1);
    const std::uint64_t factor = static_cast<std::uint64_t>(usual) * unit;
    const cv::Rect within = cell & cv::Rect({0, 0}, pixels.size());
    for (int y = within.y; y < within.br().y; ++y) {
      std::uint8_t* row = pixels.ptr<std::uint8_t>(y);
      for (int x = within.x; x < within.br().x; ++x) {
        row[x] = static_cast<std::uint8_t>(std::min<std::uint64_t>(255, row[x] * factor >> reciprocal_bits));
      }
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

}  // namespace pizarra::vision
