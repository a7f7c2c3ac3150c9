#include "agents/vision/marks/level_regions.hpp"

#include <algorithm>
#include <functional>

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

}  // namespace

std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone) {
  // Each group is one region as more and more levels show it.
  std::vector<std::vector<Seen>> groups;
  for (double at = least_level; at < most_level; at *= level_ratio) {
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
  // A region that is the same at several levels has a steep border. The middle one of its levels is far from either
  // side of it.
  const auto area = [](const std::vector<Seen>& seen) { return seen[seen.size() / 2].region.area_px; };
  std::ranges::stable_sort(groups, std::ranges::greater(), area);
  std::vector<LevelRegion> out;
  const std::size_t longest = longest_contour_px(pixels.size());
  for (const std::vector<Seen>& seen : groups) {
    if (out.size() >= most_level_regions) break;
    if (seen.size() < 2) continue;
    const Seen& middle = seen[seen.size() / 2];
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

std::vector<LevelRegion> level_regions(const cv::Mat1b& pixels, MarkTone tone, const cv::Rect& area) {
  if (area.empty()) return {};
  std::vector<LevelRegion> out = level_regions(pixels(area), tone);
  for (LevelRegion& region : out) {
    for (cv::Point& p : region.contour) p += area.tl();
    region.box += area.tl();
    region.reach.middle += cv::Point2d(area.tl());
  }
  return out;
}

}  // namespace pizarra::vision
