#include "agents/vision/image/tone_split.hpp"

#include <algorithm>
#include <opencv2/core/hal/intrin.hpp>

namespace pizarra::vision {
namespace {

constexpr int least_local_contrast = 30;
// Of the noise: the lightest and the darkest pixels nearby differ by less where there is nothing else.
constexpr double noise_contrast = 8;
// Nine tiles reach past the edge of an ordinary mark from anywhere in it; the inside of a larger one has no tone.
constexpr int tiles_a_row = 20;
constexpr int least_tile_px = 16;
constexpr int rows_a_threshold = 4;

struct Extremes {
  std::uint8_t lowest = 255;
  std::uint8_t highest = 0;
};

class Tiles {
 public:
  // Those from which the thresholds of this part of the image come.
  Tiles(const cv::Mat1b& image, int side, cv::Range rows, cv::Range columns)
      : columns_((image.cols + side - 1) / side), rows_((image.rows + side - 1) / side) {
    first_row_ = std::max(0, rows.start / side - 2);
    end_row_ = std::min(rows_, rows.end / side + 3);
    const int first_x = std::max(0, columns.start / side - 2) * side;
    const int end_x = std::min(image.cols, (columns.end / side + 3) * side);
    std::vector<std::uint8_t> lowest(static_cast<std::size_t>(image.cols));
    std::vector<std::uint8_t> highest(lowest.size());
    for (int row = first_row_; row < end_row_; ++row) {
      std::ranges::fill(lowest, 255);
      std::ranges::fill(highest, 0);
      for (int y = row * side; y < std::min((row + 1) * side, image.rows); ++y) {
        narrow(image.ptr<std::uint8_t>(y) + first_x, end_x - first_x, lowest.data() + first_x,
               highest.data() + first_x);
      }
      for (int column = 0; column < columns_; ++column) {
        const int first = column * side;
        const int end = std::min(first + side, image.cols);
        extremes_.push_back({*std::min_element(lowest.begin() + first, lowest.begin() + end),
                             *std::max_element(highest.begin() + first, highest.begin() + end)});
      }
    }
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }
  // Of the tile and its eight neighbours.
  Extremes nearby(int column, int row) const {
    Extremes out;
    for (int y = std::max(first_row_, row - 1); y <= std::min(end_row_ - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
        const std::size_t row_start = static_cast<std::size_t>(y - first_row_) * static_cast<std::size_t>(columns_);
        const Extremes& tile = extremes_[row_start + static_cast<std::size_t>(x)];
        out.lowest = std::min(out.lowest, tile.lowest);
        out.highest = std::max(out.highest, tile.highest);
      }
    }
    return out;
  }

 private:
  static void narrow(const std::uint8_t* __restrict row, int width, std::uint8_t* __restrict lowest,
                     std::uint8_t* __restrict highest) {
    for (int x = 0; x < width; ++x) {
      lowest[x] = std::min(lowest[x], row[x]);
      highest[x] = std::max(highest[x], row[x]);
    }
  }

  int columns_;
  int rows_;
  int first_row_;
  int end_row_;
  std::vector<Extremes> extremes_;  // from the first row
};

// The threshold of one row of tiles, for every column of the image.
class ThresholdRow {
 public:
  ThresholdRow(const std::vector<int>& middles, int side, int width) : levels_(static_cast<std::size_t>(width)) {
    const int last = static_cast<int>(middles.size()) - 1;
    for (int x = 0; x < width; ++x) {
      const int from_first = 2 * x + 1 - side;  // from the first tile's middle, half px
      const int tile = std::clamp(from_first / (2 * side), 0, last);
      const int next = std::min(tile + 1, last);
      const int part = std::max(0, from_first - 2 * side * tile);
      const int a = middles[static_cast<std::size_t>(tile)];
      const int b = middles[static_cast<std::size_t>(next)];
      levels_[static_cast<std::size_t>(x)] = static_cast<std::uint16_t>(a + (b - a) * part / (2 * side));
    }
  }
  const std::uint16_t* levels() const { return levels_.data(); }

 private:
  std::vector<std::uint16_t> levels_;
};

void mix(const std::uint16_t* __restrict a, const std::uint16_t* __restrict b, int part_of_256, int width,
         std::uint8_t* __restrict out) {
  const auto second = static_cast<std::uint16_t>(part_of_256);
  const auto first = static_cast<std::uint16_t>(256 - part_of_256);
  for (int x = 0; x < width; ++x) {
    out[x] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(a[x] * first + b[x] * second) >> 8);
  }
}

// A bit for every pixel below its threshold.
void compare(const std::uint8_t* row, const std::uint8_t* threshold, int width, std::uint64_t* below) {
  std::uint64_t word = 0;
  int x = 0;
  for (; x + 16 <= width; x += 16) {
    const cv::v_uint8x16 less = cv::v_load(row + x) < cv::v_load(threshold + x);
    word |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(cv::v_signmask(less))) << (x % 64);
    if (x % 64 == 48) {
      *below++ = word;
      word = 0;
    }
  }
  for (; x < width; ++x) {
    word |= static_cast<std::uint64_t>(row[x] < threshold[x]) << (x % 64);
    if (x % 64 == 63) {
      *below++ = word;
      word = 0;
    }
  }
  if (width % 64 != 0) *below = word;
}

}  // namespace

ToneSplit split_tones(const cv::Mat1b& image, double noise, std::optional<cv::Rect> wanted) {
  const int width = image.cols;
  const int height = image.rows;
  const cv::Rect whole({0, 0}, image.size());
  const cv::Rect area = wanted ? *wanted & whole : whole;
  const cv::Range rows(area.y - area.y % rows_a_threshold, area.br().y);
  // Whole words of bits.
  const cv::Range words(area.x / 64, (area.br().x + 63) / 64);
  const cv::Range columns(64 * words.start, std::min(width, 64 * words.end));
  const int side = std::max(least_tile_px, width / tiles_a_row);
  const double least_contrast = std::max<double>(least_local_contrast, noise_contrast * noise);
  const Tiles tiles(image, side, rows, columns);
  std::vector<ThresholdRow> thresholds;  // from the tiles' first row
  BitImage structured(width, tiles.rows());
  for (int row = tiles.first_row(); row < tiles.end_row(); ++row) {
    std::vector<int> middles;
    for (int column = 0; column < tiles.columns(); ++column) {
      const Extremes nearby = tiles.nearby(column, row);
      middles.push_back((nearby.lowest + nearby.highest + 1) / 2);
      if (nearby.highest - nearby.lowest < least_contrast) continue;
      for (int x = column * side; x < std::min((column + 1) * side, width); ++x) {
        structured.row(row)[x / 64] |= std::uint64_t{1} << (x % 64);
      }
    }
    thresholds.emplace_back(middles, side, width);
  }

  ToneSplit out{BitImage(width, height), BitImage(width, height)};
  std::vector<std::uint8_t> threshold(static_cast<std::size_t>(width));
  const auto threshold_of = [&](int row) {
    return thresholds[static_cast<std::size_t>(row - tiles.first_row())].levels();
  };
  for (int y = rows.start; y < rows.end; ++y) {
    if (y % rows_a_threshold == 0) {
      const int from_first = std::max(0, 2 * y + rows_a_threshold - side);  // from the first tiles' middle, half px
      const int upper = std::min(from_first / (2 * side), tiles.rows() - 1);
      const int lower = std::min(upper + 1, tiles.rows() - 1);
      const int part = 256 * (from_first - 2 * side * upper) / (2 * side);
      mix(threshold_of(upper), threshold_of(lower), std::clamp(part, 0, 256), width, threshold.data());
    }
    compare(image.ptr<std::uint8_t>(y) + columns.start, threshold.data() + columns.start, columns.size(),
            out.dark.row(y) + words.start);
    const std::uint64_t* there = structured.row(std::min(y / side, tiles.rows() - 1));
    for (int i = words.start; i < words.end; ++i) {
      out.light.row(y)[i] = ~out.dark.row(y)[i] & there[i];
      out.dark.row(y)[i] &= there[i];
    }
  }
  return out;
}

}  // namespace pizarra::vision
