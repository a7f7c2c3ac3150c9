#include "agents/vision/marks/all_tags.hpp"

#include <algorithm>
#include <functional>

#include "agents/vision/marks/tag_mark.hpp"
#include "agents/vision/marks/tag_square.hpp"

namespace pizarra::vision {
namespace {

struct ReadTag {
  SeenMark mark;
  double likeness;
};

void read_family(const cv::Mat1b& grey, const TagFamily& family, std::span<const TagCorners> squares,
                 std::vector<ReadTag>& out) {
  const TagDetection detection = detect_all_tags(grey, family, squares);
  for (std::size_t i = 0; i < detection.found.size(); ++i) {
    const TagCorners& corners = detection.found[i];
    if (!has_a_border(grey, corners, family)) continue;
    const double likeness = tag_likeness(grey, corners, family, detection.numbers[i]);
    if (likeness < least_tag_likeness(family)) continue;
    std::optional<SeenMark> mark = whole_tag(grey, corners, family, detection.numbers[i]);
    if (mark) out.push_back({std::move(*mark), likeness});
  }
}

}  // namespace

std::vector<SeenMark> all_tags(const cv::Mat1b& grey, std::span<const TagFamily* const> families) {
  const std::vector<TagCorners> squares = squares_at_levels(grey);
  std::vector<ReadTag> read;
  for (const TagFamily* family : families) read_family(grey, *family, squares, read);
  std::ranges::stable_sort(read, std::greater<>(), &ReadTag::likeness);
  std::vector<SeenMark> out;
  for (ReadTag& tag : read) {
    const bool is_read = std::ranges::any_of(out, [&](const SeenMark& other) {
      return other.box.contains(tag.mark.centre) && tag.mark.box.contains(other.centre);
    });
    if (!is_read) out.push_back(std::move(tag.mark));
  }
  std::ranges::stable_sort(out, std::greater<>(), &SeenMark::area_px);
  if (out.size() > most_tags_at_once) out.resize(most_tags_at_once);
  return out;
}

}  // namespace pizarra::vision
