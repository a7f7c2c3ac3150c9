#include "agents/vision/marks/outline_guess.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace pizarra::vision {
namespace {

// Of the outline's points every so many make pairs, and are tried.
constexpr std::size_t pair_stride = 2;
constexpr std::size_t try_stride = 2;
// A guess is given up where hardly any of the first, far apart from each other, are edges.
constexpr std::size_t first_tried = 12;
constexpr double least_of_first = 0.25;
// Along a chain every so many places begin a pair, which ends so far on.
constexpr std::size_t place_stride = 3;
constexpr std::array<std::size_t, 4> apart_px = {10, 18, 32, 56};
constexpr double least_apart_px = 8;
constexpr int angles = 24;
// Two guesses are one: by the mark's standard deviation, and as a ratio.
constexpr double same_place = 0.35;
constexpr double same_size = 1.15;

double turn_of(const cv::Vec2d& v) { return std::atan2(v[1], v[0]); }

int angle_bin(double turn) {
  constexpr double full = 2 * std::numbers::pi;
  return static_cast<int>((turn - full * std::floor(turn / full)) * angles / full) % angles;
}

// How two oriented places lie to each other, whatever the place, the turn and the size.
int pair_bin(const cv::Vec2d& apart, const cv::Vec2d& first, const cv::Vec2d& second) {
  const double along = turn_of(apart);
  return angle_bin(turn_of(first) - along) * angles + angle_bin(turn_of(second) - along);
}

struct OutlinePair {
  cv::Vec2d from;
  cv::Vec2d apart;
};

class Guesser {
 public:
  Guesser(const EdgeChains& edges, const PlaneOutline& outline, MarkTone tone, const SizeRange& sizes,
          double least_shown)
      : edges_(edges), sizes_(sizes), least_shown_(least_shown) {
    const double sign = tone == MarkTone::dark ? 1 : -1;
    for (const PlaneOutline::Point& point : outline.points) points_.push_back({point.at, sign * point.out});
    for (std::size_t i = 0; i < points_.size(); i += pair_stride) {
      for (std::size_t j = 0; j < points_.size(); j += pair_stride) {
        const cv::Vec2d apart = points_[j].at - points_[i].at;
        if (i == j || is_straight(apart, points_[i].light, points_[j].light)) continue;
        const auto bin = static_cast<std::size_t>(pair_bin(apart, points_[i].light, points_[j].light));
        pairs_[bin].push_back({points_[i].at, apart});
      }
    }
    order_points();
  }

  std::vector<OutlineGuess> run() {
    for (const EdgeChain& chain : edges_.chains) {
      for (std::size_t i = 0; i < chain.size(); i += place_stride) {
        for (const std::size_t apart : apart_px) {
          if (i + apart < chain.size()) guess(chain[i], chain[i + apart]);
        }
      }
    }
    return best();
  }

 private:
  struct Point {
    cv::Vec2d at;
    cv::Vec2d light;
  };
  using Cell = std::tuple<int, int, int>;

  // Two places of one straight edge say nothing of a size.
  static bool is_straight(const cv::Vec2d& apart, const cv::Vec2d& first, const cv::Vec2d& second) {
    constexpr double least_bend = 0.2;  // rad
    const double length = cv::norm(apart);
    return length <= 0 ||
           (first.dot(second) > std::cos(least_bend) && std::abs(first.dot(apart)) < std::sin(least_bend) * length);
  }

  // The first ones are far apart from each other.
  void order_points() {
    for (std::size_t first = 0; first < first_tried; ++first) {
      for (std::size_t i = first; i < points_.size(); i += first_tried) {
        if ((i / first_tried) % try_stride == 0) tried_.push_back(points_[i]);
      }
    }
    // One of each run, then the others.
    std::vector<Point> ordered;
    const std::size_t run = tried_.size() / first_tried;
    for (std::size_t k = 0; k < run; ++k) {
      for (std::size_t first = 0; first < first_tried; ++first) ordered.push_back(tried_[first * run + k]);
    }
    tried_ = std::move(ordered);
  }

  void guess(const EdgePlace& first, const EdgePlace& second) {
    const cv::Vec2d apart(second.at.x - first.at.x, second.at.y - first.at.y);
    const double length = cv::norm(apart);
    const cv::Vec2d first_light(first.light[0], first.light[1]);
    const cv::Vec2d second_light(second.light[0], second.light[1]);
    if (length < least_apart_px || is_straight(apart, first_light, second_light)) return;
    for (const OutlinePair& pair : pairs_[static_cast<std::size_t>(pair_bin(apart, first_light, second_light))]) {
      const double squared = pair.apart.dot(pair.apart);
      // The turn and the size that bring one to the other, as a complex number.
      const double c = (apart[0] * pair.apart[0] + apart[1] * pair.apart[1]) / squared;
      const double s = (apart[1] * pair.apart[0] - apart[0] * pair.apart[1]) / squared;
      const double size = std::hypot(c, s);
      if (size < sizes_.least_px || size > sizes_.most_px) continue;
      const double x = first.at.x - (c * pair.from[0] - s * pair.from[1]);
      const double y = first.at.y - (s * pair.from[0] + c * pair.from[1]);
      keep(c, s, x, y, size);
    }
  }

  void keep(double c, double s, double x, double y, double size) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < tried_.size(); ++i) {
      const Point& p = tried_[i];
      const cv::Point2d at(c * p.at[0] - s * p.at[1] + x, s * p.at[0] + c * p.at[1] + y);
      const cv::Vec2d light(c * p.light[0] - s * p.light[1], s * p.light[0] + c * p.light[1]);
      seen += edges_.is_edge(at, light) ? 1 : 0;
      if (i + 1 == first_tried && static_cast<double>(seen) < least_of_first * first_tried) return;
    }
    const double shown = static_cast<double>(seen) / static_cast<double>(tried_.size());
    if (shown < least_shown_) return;
    const double cell_px = std::max(2.0, size * same_place / 2);
    const Cell cell(cvRound(std::log(size) / std::log(same_size)), cvFloor(x / cell_px), cvFloor(y / cell_px));
    OutlineGuess& best = found_[cell];
    if (shown > best.shown) best = {{c, -s, x, s, c, y, 0, 0, 1}, shown};
  }

  std::vector<OutlineGuess> best() const {
    std::vector<OutlineGuess> all;
    for (const auto& [cell, guess] : found_) all.push_back(guess);
    const auto size_of = [](const OutlineGuess& guess) {
      return std::hypot(guess.to_image(0, 0), guess.to_image(1, 0));
    };
    // By how long its edges are: small shapes are everywhere.
    std::ranges::stable_sort(all, std::ranges::greater(),
                             [&](const OutlineGuess& guess) { return guess.shown * size_of(guess); });
    std::vector<OutlineGuess> out;
    for (const OutlineGuess& guess : all) {
      if (out.size() >= most_guesses) break;
      const bool known = std::ranges::any_of(out, [&](const OutlineGuess& other) {
        const double away =
            std::hypot(guess.to_image(0, 2) - other.to_image(0, 2), guess.to_image(1, 2) - other.to_image(1, 2));
        return away < same_place * size_of(other) &&
               std::max(size_of(guess), size_of(other)) < same_size * std::min(size_of(guess), size_of(other));
      });
      if (!known) out.push_back(guess);
    }
    return out;
  }

  const EdgeChains& edges_;
  const SizeRange sizes_;
  const double least_shown_;
  std::vector<Point> points_;
  std::vector<Point> tried_;
  std::array<std::vector<OutlinePair>, static_cast<std::size_t>(angles* angles)> pairs_;
  std::map<Cell, OutlineGuess> found_;
};

}  // namespace

std::vector<OutlineGuess> outline_guesses(const EdgeChains& edges, const PlaneOutline& outline, MarkTone tone,
                                          const SizeRange& sizes, double least_shown) {
  if (outline.points.size() < 32) return {};
  return Guesser(edges, outline, tone, sizes, least_shown).run();
}

}  // namespace pizarra::vision
