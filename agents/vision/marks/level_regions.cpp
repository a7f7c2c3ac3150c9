#include "agents/vision/marks/level_regions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "agents/vision/image/regions.hpp"
#include "agents/vision/marks/segmentation.hpp"

namespace pizarra::vision {
namespace {

// Each level is so many times the one before. Print is at least two and a half times as dark as its paper, in a shadow
// too, so that several levels lie between them.
constexpr double level_ratio = 1.22;
constexpr double least_level = 9;
constexpr double most_level = 235;
// Far away a mark is small, and still has an outline.
constexpr int least_area_px = 40;
constexpr int slimmest = 5;
// Of two levels' regions that are one, each side differs by no more, px and as a part of it.
constexpr int same_px = 2;
constexpr double same_share = 0.08;
// A steep border moves no farther from one level to the next, px.
constexpr double steep_px = 0.3;
constexpr double about_as_steep = 1.3;  // times the least

struct Seen {
  Region region;
  int level;
};

BitImage darker_than(const cv::Mat1b& pixels, int level, MarkTone tone) {
  BitImage out(pixels.cols, pixels.rows);
  for (int y = 0; y < pixels.rows; ++y) {
    const std::uint8_t* p = pixels.ptr<std::uint8_t>(y);
    std::uint64_t* words = out.row(y);
    for (int first = 0; first < pixels.cols; first += 64) {
      const int end = std::min(64, pixels.cols - first);
      std::uint64_t word = 0;
      for (int i = 0; i < end; ++i) word |= static_cast<std::uint64_t>(p[first + i] < level) << i;
      if (tone == MarkTone::light) word = ~word & (end == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << end) - 1);
      words[first / 64] = word;
    }
  }
  return out;
}

bool may_be_a_mark(const Region& region, cv::Size image) {
  const cv::Rect& box = region.box;
  return region.area_px >= least_area_px && 5 * region.area_px >= box.area() && box.width <= slimmest * box.height &&
         box.height <= slimmest * box.width && !is_too_large_for_a_mark(box.size(), image) && box.x > 0 && box.y > 0 &&
         box.br().x < image.width && box.br().y < image.height;
}

bool are_one(const cv::Rect& a, const cv::Rect& b) {
  const double slack = same_px + same_share * std::max(a.width, a.height);
  return std::abs(a.x - b.x) <= slack && std::abs(a.y - b.y) <= slack && std::abs(a.br().x - b.br().x) <= slack &&
         std::abs(a.br().y - b.br().y) <= slack;
}

// How far the border moves from each level to the next, px.
std::vector<double> moves_of(const std::vector<Seen>& seen) {
  std::vector<double> out;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    const double grown = std::abs(seen[i].region.area_px - seen[i - 1].region.area_px);
    out.push_back(grown / (2 * std::sqrt(std::numbers::pi * seen[i].region.area_px)));
  }
  return out;
}

// The middle one of its levels is far from either side of its border. But where light falls off within a mark, lower
// levels show a part of it: then the middle one of the longest run over which the border hardly moves.
const Seen& clearest(const std::vector<Seen>& seen) {
  const std::vector<double> moves = moves_of(seen);
  const std::size_t middle = seen.size() / 2;
  if (moves.empty()) return seen[middle];
  const double most_px = std::max(steep_px, about_as_steep * *std::ranges::min_element(moves));
  if (moves[middle - 1] <= most_px) return seen[middle];
  std::size_t begin = 0;
  std::size_t best_begin = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i] > most_px) begin = i + 1;
    if (i + 1 - begin <= most) continue;
    most = i + 1 - begin;
    best_begin = begin;
  }
  return seen[best_begin + (most + 1) / 2];
}

}  // namespace

std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone, const LevelSteps& steps) {
  // Each group is one region as more and more levels show it.
  std::vector<std::vector<Seen>> groups;
  for (double at = least_level; at < most_level; at = std::min(level_ratio * at, at + steps.most)) {
    const int level = cvRound(at);
    for (const Region& region : regions_of(darker_than(pixels, level, tone))) {
      if (!may_be_a_mark(region, pixels.size())) continue;
      const auto group = std::ranges::find_if(
          groups, [&](const std::vector<Seen>& seen) { return are_one(seen.back().region.box, region.box); });
      if (group == groups.end()) {
        groups.push_back({{region, level}});
      } else if (group->back().level != level) {
        group->push_back({region, level});
      }
    }
  }
  const auto area = [](const std::vector<Seen>& seen) { return clearest(seen).region.area_px; };
  std::ranges::stable_sort(groups, std::ranges::greater(), area);
  std::vector<LevelRegion> out;
  const std::size_t longest = longest_contour_px(pixels.size());
  for (const std::vector<Seen>& seen : groups) {
    if (out.size() >= most_level_regions) break;
    if (seen.size() < 2) continue;
    const Seen& middle = clearest(seen);
    // Light is what is not below the level.
    std::optional<MarkContour> contour =
        follow_contour(ToneField(pixels, middle.level - (tone == MarkTone::dark ? 0 : 1), tone == MarkTone::dark),
                       middle.region.start, longest);
    if (!contour || contour->size() < 12) continue;
    std::optional<Reach> reach = reach_of(std::vector<cv::Point2d>(contour->begin(), contour->end()));
    if (reach) out.push_back({std::move(*contour), middle.region.box, *reach});
  }
  return out;
}

std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone, const cv::Rect& area,
                                       const LevelSteps& steps) {
  if (area.empty()) return {};
  std::vector<LevelRegion> out = level_regions(pixels(area), tone, steps);
  for (LevelRegion& region : out) {
    for (cv::Point& p : region.contour) p += area.tl();
    region.box += area.tl();
    region.reach.middle += cv::Point2d(area.tl());
  }
  return out;
}

}  // namespace pizarra::vision
