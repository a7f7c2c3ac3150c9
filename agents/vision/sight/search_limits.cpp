#include "agents/vision/sight/search_limits.hpp"

namespace pizarra::vision {
namespace {

Duration period_of(double per_second) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / per_second));
}

}  // namespace

const SearchLimits& SearchLimits::none() {
  static const SearchLimits limits;
  return limits;
}

SearchLimit SearchLimits::of(const std::string& name) const {
  const auto found = limits_.find(name);
  return found == limits_.end() ? SearchLimit() : found->second;
}

void SearchLimits::set(const std::string& name, SearchLimit limit) {
  limits_.erase(name);
  if (limit.area || limit.per_second) limits_.emplace(name, limit);
}

void SearchLimits::follow(const Renames& renames, const LearnedObjects& objects) {
  std::map<std::string, SearchLimit> now;
  for (const auto& [was, limit] : limits_) {
    const LearnedObject* object = objects.find(name_now(renames, was));
    if (object != nullptr) now.emplace(object->name, limit);
  }
  limits_ = std::move(now);
}

std::vector<Datum> SearchLimits::facts() const {
  std::vector<Datum> out;
  for (const auto& [name, limit] : limits_) {
    if (const auto& area = limit.area) {
      out.push_back(list("searched-in"_sym, name, area->x, area->y, area->width, area->height));
    }
    if (limit.per_second) out.push_back(list("looked-at-most"_sym, name, *limit.per_second));
  }
  return out;
}

bool LookPace::is_due(Time captured, double per_second) const {
  const bool set_back = captured + period_of(per_second) < due_;
  return per_second != per_second_ || captured >= due_ || set_back;
}

// One that came late does not put off the next: else a camera of 30 images a second would be looked at 7.5 times where
// 10 are allowed and its images come a little early.
void LookPace::looked(Time captured, double per_second) {
  const Duration period = period_of(per_second);
  const bool in_step = per_second == per_second_ && captured >= due_ && captured < due_ + period;
  due_ = (in_step ? due_ : captured) + period;
  per_second_ = per_second;
}

}  // namespace pizarra::vision
