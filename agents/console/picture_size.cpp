#include "agents/console/picture_size.hpp"

#include <algorithm>
#include <limits>

namespace pizarra::console {

namespace {

constexpr std::size_t most_recent = 16;
constexpr Duration hardly = 20ms;
// A quick line and a page take so long for any picture. A shorter time says nothing of the line.
constexpr Duration of_any = 3ms;
constexpr double with_ease = 0.5;
constexpr double with_difficulty = 0.75;
constexpr int waits_smoothed_over = 8;
constexpr Duration longest_pause = 320s;

double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

// Of the line, for a byte.
double seconds_a_byte(const PictureSize::Drawn& drawn) {
  return seconds(std::max(Duration(0), drawn.waited - of_any)) /
         static_cast<double>(std::max<std::size_t>(1, drawn.bytes));
}

}  // namespace

void PictureSize::note(const Drawn& drawn) {
  wait_ += (drawn.waited - wait_) / waits_smoothed_over;
  recent_.push_back(drawn);
  if (recent_.size() > most_recent) recent_.pop_front();
  if (recent_.size() < most_recent) return;
  const double share = full_share();
  if (!light_ && (wait_ > too_long || share > with_difficulty)) {
    become_light(drawn.sent);
  } else if (light_ && wait_ <= hardly && share <= with_ease && drawn.sent >= not_full_before_) {
    light_ = false;
    recent_.clear();
  }
}

double PictureSize::full_share() const {
  double quickest = std::numeric_limits<double>::max();
  double bytes = 0;  // of those behind the oldest
  for (const Drawn& drawn : recent_) {
    quickest = std::min(quickest, seconds_a_byte(drawn));
    bytes += static_cast<double>(drawn.full_bytes);
  }
  bytes -= static_cast<double>(recent_.front().full_bytes);
  const double span = seconds(recent_.back().sent - recent_.front().sent);
  return span > 0 ? bytes * quickest / span : std::numeric_limits<double>::max();
}

void PictureSize::become_light(Time now) {
  light_ = true;
  not_full_before_ = now + pause_;
  pause_ = std::min(longest_pause, 2 * pause_);
  recent_.clear();
}

}  // namespace pizarra::console
