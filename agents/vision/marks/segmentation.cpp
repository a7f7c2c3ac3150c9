#include "agents/vision/marks/segmentation.hpp"

#include <algorithm>
#include <functional>

#include "agents/vision/image/regions.hpp"

namespace pizarra::vision {
namespace {

bool has_the_size_of_a_mark(const Region& region, cv::Size image, const cv::Rect& area) {
  const cv::Rect& box = region.box;
  return region.area_px >= least_seen_area_px && !is_too_large_for_a_mark(box.size(), image) &&
         5 * region.area_px >= box.area() && box.width <= 4 * box.height && box.height <= 4 * box.width &&
         box.x > area.x && box.y > area.y && box.br().x < area.br().x && box.br().y < area.br().y;
}

}  // namespace

bool is_too_large_for_a_mark(cv::Size box, cv::Size image) {
  return 10 * box.width > 9 * image.width || 10 * box.height > 9 * image.height;
}

std::size_t longest_contour_px(cv::Size image) { return 2 * static_cast<std::size_t>(image.width + image.height); }

ImageSegmentation::ImageSegmentation(const cv::Mat& grey, double noise, double focal_px, std::optional<cv::Rect> area)
    : focal_px_(focal_px),
      area_(area.value_or(cv::Rect({0, 0}, grey.size())) & cv::Rect({0, 0}, grey.size())),
      cut_(look_at(grey, {0, 0, grey.cols, grey.rows}, noise)),
      split_(split_tones(cut_.pixels, cut_.noise, area_)) {}

cv::Mat1b ImageSegmentation::mask(MarkTone tone) const {
  cv::Mat1b out = cv::Mat1b::zeros(image().size());
  const BitImage& there = bits(tone);
  for (int y = 0; y < out.rows; ++y) {
    for_each_run_of_bits(there.row(y), there.words_a_row(),
                         [&](int first, int end) { std::fill(out[y] + first, out[y] + end, std::uint8_t{255}); });
  }
  return out;
}

struct ImageSegmentation::Candidate {
  Region region;
  MarkTone tone;
};

// Of more than can be marks the largest come first: specks are small.
std::vector<ImageSegmentation::Candidate> ImageSegmentation::candidates() const {
  std::vector<Candidate> out;
  for (const MarkTone tone : {MarkTone::dark, MarkTone::light}) {
    for (const Region& region : regions_of(bits(tone))) {
      if (has_the_size_of_a_mark(region, image().size(), area_)) out.push_back({region, tone});
    }
  }
  const auto area = [](const Candidate& candidate) { return candidate.region.area_px; };
  if (out.size() > most_marks) std::ranges::stable_sort(out, std::ranges::greater(), area);
  return out;
}

const std::vector<SeenMark>& ImageSegmentation::marks() {
  if (collected_) return marks_;
  collected_ = true;
  const std::size_t longest = longest_contour_px(image().size());
  const std::vector<Candidate> all = candidates();
  std::size_t looked_at = 0;
  for (; looked_at < all.size() && marks_.size() < most_marks; ++looked_at) {
    const auto& [region, tone] = all[looked_at];
    std::optional<MarkContour> contour = follow_contour(bits(tone), region.start, longest);
    if (!contour || contour->size() < 4) continue;
    std::optional<SeenMark> mark = measure_mark(cut_, std::move(*contour), tone);
    if (!mark) continue;
    mark->focal_px = focal_px_;
    marks_.push_back(std::move(*mark));
  }
  left_out_ = all.size() - looked_at;
  return marks_;
}

}  // namespace pizarra::vision
