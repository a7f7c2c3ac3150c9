#include "agents/vision/sight/known_twins.hpp"

#include <algorithm>

namespace pizarra::vision {

namespace {

bool is_like(const SeenMark& mark, const LearnedObjects& objects, const LearnedObject& object) {
  return mark.tag || is_recognised(mark, objects, object);
}

}  // namespace

void KnownTwins::note(const SeenMark& own, const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                      const LearnedObject& object) {
  std::erase_if(places_, [&](const cv::Point2d& place) { return own.box.contains(place); });
  for (const SeenMark& mark : marks) {
    if (own.box.contains(mark.centre) || !is_like(mark, objects, object)) continue;
    if (may_be_one_cube(own, mark, front_slimness(object))) continue;
    std::erase_if(places_, [&](const cv::Point2d& place) { return mark.box.contains(place); });
    places_.push_back(mark.centre);
  }
  // Those that were noted longest ago are the least sure.
  if (places_.size() > most) places_.erase(places_.begin(), places_.end() - most);
}

void KnownTwins::add(cv::Point2d place) {
  if (places_.size() < most) places_.push_back(place);
}

void KnownTwins::follow(const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                        const LearnedObject& object) {
  for (cv::Point2d& place : places_) {
    const auto found = std::ranges::find_if(
        marks, [&](const SeenMark& mark) { return mark.box.contains(place) && is_like(mark, objects, object); });
    if (found != marks.end()) place = found->centre;
  }
}

void drop_moved(std::vector<SeenMark>& marks, const std::vector<SeenMark>& now, cv::Point2d motion, double most_px) {
  std::erase_if(marks, [&](const SeenMark& mark) {
    return std::ranges::none_of(now, [&](const SeenMark& seen) {
      const cv::Point2d moved = seen.centre - mark.centre;
      return std::min(cv::norm(moved), cv::norm(moved - motion)) < most_px;
    });
  });
}

}  // namespace pizarra::vision
