#pragma once

// Where objects are looked for, and how often at most, as somebody said to save time or to shut other places out. By
// the names that they were learned under.
//
//   SearchLimits limits;
//   limits.set("circle", {.area = cv::Rect(40, 60, 100, 80), .per_second = 5});
//   limits.of("circle").area                     // of the left image, px; nothing: everywhere
//   LookPace pace;
//   if (pace.is_due(captured, 5)) ... pace.looked(captured, 5);

#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "agents/vision/objects/learned.hpp"
#include "agents/vision/objects/renames.hpp"
#include "blackboard/time/clock.hpp"

namespace pizarra::vision {

struct SearchLimit {
  std::optional<cv::Rect> area = {};
  std::optional<double> per_second = {};  // looks at it
};

class SearchLimits {
 public:
  static const SearchLimits& none();

  SearchLimit of(const std::string& name) const;
  // In place of what was said before.
  void set(const std::string& name, SearchLimit limit);
  // Limits go by the new names; those of objects that are not known any more end.
  void follow(const Renames& renames, const LearnedObjects& objects);
  // (searched-in NAME X Y WIDTH HEIGHT) and (looked-at-most NAME TIMES) of each.
  std::vector<Datum> facts() const;

 private:
  std::map<std::string, SearchLimit> limits_;
};

// When something may be looked at again: so often on the average, whatever the camera's own rate.
class LookPace {
 public:
  // Also where another rate is said, or the clock of the images was set back.
  bool is_due(Time captured, double per_second) const;
  void looked(Time captured, double per_second);

 private:
  double per_second_ = 0;
  Time due_ = {};
};

}  // namespace pizarra::vision
