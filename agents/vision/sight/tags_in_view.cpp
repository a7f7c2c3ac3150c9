#include "agents/vision/sight/tags_in_view.hpp"

#include <algorithm>

#include "agents/vision/marks/all_tags.hpp"
#include "agents/vision/marks/tags.hpp"
#include "agents/vision/sight/tag_pose.hpp"
#include "agents/vision/sight/wholeness.hpp"

namespace pizarra::vision {
namespace {

std::optional<SeenMark> partner_of(const SeenMark& left, const std::vector<SeenMark>& right) {
  const auto is_partner = [&](const SeenMark& mark) { return mark.tag == left.tag && are_tag_partners(left, mark); };
  const auto found = std::ranges::find_if(right, is_partner);
  if (found == right.end() || std::any_of(found + 1, right.end(), is_partner)) return std::nullopt;
  return *found;
}

}  // namespace

LearnedObject object_of(const Tag& tag, double side_mm) {
  LearnedObject out{.name = tag_name(tag), .samples = {}};
  LearnedSample& sample = out.samples.emplace_back();
  sample.number = 1;
  sample.tag = tag;
  sample.slimness = 1;
  sample.size_by = LearnedSample::SizeBy::measured_face;
  sample.size_mm = face_of_square(side_mm);
  return out;
}

TagsInView::TagsInView(std::span<const SizedFamily> families) {
  for (const SizedFamily& sized : families) {
    const TagFamily* family = family_called(sized.name);
    if (family == nullptr) continue;
    families_.push_back(family);
    sizes_.push_back(object_of({sized.name, 0}, sized.side_mm));
  }
}

std::vector<FoundMark> TagsInView::at(const StereoSight& sight) const {
  const std::vector<SeenMark> left = all_tags(sight.left(), families_);
  const std::vector<SeenMark> right =
      sight.model().is_single() ? std::vector<SeenMark>() : all_tags(sight.right(), families_);
  std::vector<FoundMark> out;
  for (const SeenMark& tag : left) {
    const auto family = std::ranges::find(families_, tag.tag->family, &TagFamily::name);
    const LearnedObject& size = sizes_[static_cast<std::size_t>(family - families_.begin())];
    const Likeness likely{.error = 0, .doubt = tag.tag_doubt, .unlearned = tag.tag_doubt};
    FoundMark& found = out.emplace_back(tag_name(*tag.tag), SeenPair{tag, partner_of(tag, right), likely});
    found.confidence = confidence_in_look(sight, size, found.pair);
    found.range = range_of(sight, size, found.pair, found.confidence);
    found.pose = pose_of(sight.model(), size, found.pair, found.range);
  }
  return out;
}

}  // namespace pizarra::vision
