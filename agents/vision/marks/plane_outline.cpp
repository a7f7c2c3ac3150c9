#include "agents/vision/marks/plane_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/covariance.hpp"
#include "agents/vision/marks/outline_sides.hpp"

namespace pizarra::vision {
namespace {

using Border = std::vector<cv::Point2d>;

// The picture's four bits a pixel are smoothed by so many pixels, and looked at so much finer.
constexpr double smoothing = 0.6;
constexpr int finer = 8;
// What is shorter is a speck.
constexpr double least_border = 1;  // standard deviations
// A corner turns by more than this over twice so much of the border, to the nearest place of it: a sharp one; and to
// the next place: one that the template rounds as well.
constexpr double corner_reach = 0.2;
constexpr double corner_turn = 35 * std::numbers::pi / 180;
// The ground beside a mark, in the template's pixels.
constexpr int beside = 2;

class Picture {
 public:
  explicit Picture(const MarkTemplate& levels) {
    cv::Mat1f coarse(template_size, template_size);
    std::ranges::transform(levels, coarse.begin(), [](std::uint8_t level) { return static_cast<float>(level) / 15; });
    cv::GaussianBlur(coarse, coarse, {}, smoothing, smoothing, cv::BORDER_CONSTANT);
    cv::resize(coarse, fine_, {}, finer, finer, cv::INTER_CUBIC);
  }
  const cv::Mat1f& fine() const { return fine_; }
  // From a pixel of the fine picture to standard deviations, and back.
  static cv::Point2d in_plane(cv::Point2d fine) {
    return (1 / template_scale) *
           ((1.0 / finer) * (fine + cv::Point2d(0.5, 0.5)) - cv::Point2d(0.5 + middle, 0.5 + middle));
  }
  static cv::Point2d in_fine(cv::Point2d place) {
    return finer * (template_scale * place + cv::Point2d(middle + 0.5, middle + 0.5)) - cv::Point2d(0.5, 0.5);
  }
  double at(cv::Point2d p) const {
    const int x = std::clamp(cvFloor(p.x), 0, fine_.cols - 2);
    const int y = std::clamp(cvFloor(p.y), 0, fine_.rows - 2);
    const double a = p.x - x;
    const double b = p.y - y;
    return (1 - b) * ((1 - a) * fine_(y, x) + a * fine_(y, x + 1)) +
           b * ((1 - a) * fine_(y + 1, x) + a * fine_(y + 1, x + 1));
  }
  cv::Point2d slope(cv::Point2d p) const {
    constexpr double step = finer / 2.0;
    return {(at(p + cv::Point2d(step, 0)) - at(p - cv::Point2d(step, 0))) / (2 * step),
            (at(p + cv::Point2d(0, step)) - at(p - cv::Point2d(0, step))) / (2 * step)};
  }
  // Half full, along the slope.
  cv::Point2d on_border(cv::Point2d p) const {
    for (int i = 0; i < 3; ++i) {
      const cv::Point2d g = slope(p);
      const double steep = g.dot(g);
      if (steep < 1e-8) break;
      const cv::Point2d step = ((0.5 - at(p)) / steep) * g;
      const double length = cv::norm(step);
      p += length > finer / 2.0 ? (finer / 2.0 / length) * step : step;
    }
    return p;
  }
  // From a place of its border, that way, in standard deviations.
  double ink_from(cv::Point2d place, cv::Vec2d way) const {
    constexpr double step = 0.1;
    constexpr double most = template_size / template_scale;
    double reach = step;
    while (reach < most && at(in_fine(place + (reach + step) * cv::Point2d(way))) > 0.5) reach += step;
    return reach;
  }

 private:
  static constexpr double middle = template_size / 2.0;
  cv::Mat1f fine_;
};

// Moments of the area within closed lines, by Green's theorem, about a point near them. Holes are walked around the
// other way, so that their area is negative.
class AreaMoments {
 public:
  explicit AreaMoments(cv::Point2d origin) : origin_(origin) {}
  void add(const Border& closed) {
    for (std::size_t i = 0; i < closed.size(); ++i) add(closed[i] - origin_, closed[(i + 1) % closed.size()] - origin_);
  }
  bool is_none() const {
    const cv::Matx22d m = covariance();
    return std::abs(area_) < 1e-9 || m(0, 0) <= 0 || m(1, 1) <= 0 || cv::determinant(m) <= 1e-12;
  }
  cv::Point2d middle() const { return origin_ + 1 / area_ * sum_; }
  cv::Matx22d covariance() const {
    const cv::Point2d m = 1 / area_ * sum_;
    const double xy = xy_ / area_ - m.x * m.y;
    return {xx_ / area_ - m.x * m.x, xy, xy, yy_ / area_ - m.y * m.y};
  }

 private:
  void add(const cv::Point2d& p, const cv::Point2d& q) {
    const double cross = p.cross(q);
    area_ += cross / 2;
    sum_ += cross / 6 * (p + q);
    xx_ += cross * (p.x * p.x + p.x * q.x + q.x * q.x) / 12;
    yy_ += cross * (p.y * p.y + p.y * q.y + q.y * q.y) / 12;
    xy_ += cross * (2 * p.x * p.y + p.x * q.y + q.x * p.y + 2 * q.x * q.y) / 24;
  }
  cv::Point2d origin_;
  double area_ = 0;
  cv::Point2d sum_;
  double xx_ = 0, xy_ = 0, yy_ = 0;
};

AreaMoments moments_of(const std::vector<Border>& borders) {
  AreaMoments out({});
  for (const Border& border : borders) out.add(border);
  return out;
}

double length_of(const Border& closed) {
  double out = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) out += cv::norm(closed[(i + 1) % closed.size()] - closed[i]);
  return out;
}

// So many places, evenly along it.
Border evenly(const Border& closed, std::size_t count) {
  Border out;
  const double step = length_of(closed) / static_cast<double>(count);
  double next = 0;
  double walked = 0;
  for (std::size_t i = 0; i < closed.size() && out.size() < count; ++i) {
    const cv::Point2d from = closed[i];
    const cv::Point2d way = closed[(i + 1) % closed.size()] - from;
    const double length = cv::norm(way);
    for (; next < walked + length && out.size() < count; next += step)
      out.push_back(from + ((next - walked) / length) * way);
    walked += length;
  }
  return out;
}

// Of the borders in the picture, the outermost first.
std::vector<Border> borders_in(const Picture& picture) {
  cv::Mat1b full;
  cv::Mat(picture.fine() > 0.5F).convertTo(full, CV_8U);
  std::vector<std::vector<cv::Point>> chains;
  cv::findContours(full, chains, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<Border> out;
  for (const std::vector<cv::Point>& chain : chains) {
    Border border;
    for (const cv::Point& p : chain) border.push_back(Picture::in_plane(picture.on_border(p)));
    if (border.size() > 8 && length_of(border) > least_border) out.push_back(std::move(border));
  }
  std::ranges::sort(out, std::ranges::greater(), length_of);
  return out;
}

// The grey levels made the picture as wide as it is high, and uneven light tilts these. What the borders enclose says
// it better. Its size stays.
void undo_stretch(std::vector<Border>& borders) {
  const AreaMoments moments = moments_of(borders);
  if (moments.is_none()) return;
  const cv::Matx22d root = root_of(moments.covariance());
  const cv::Matx22d undo = std::sqrt(cv::determinant(root)) * root.inv();
  for (Border& border : borders) {
    for (cv::Point2d& p : border) p = undo * p;
  }
}

// From each place to the nearest corner, one that shows within so many places of it on either side.
std::vector<double> from_corners(const Border& border, int reach) {
  const auto size = static_cast<int>(border.size());
  const double step = length_of(border) / size;
  const auto at = [&](int i) { return border[static_cast<std::size_t>((i + 2 * size) % size)]; };
  const auto turn_at = [&](int i) {
    const cv::Point2d before = at(i) - at(i - reach);
    const cv::Point2d after = at(i + reach) - at(i);
    return std::abs(std::atan2(before.cross(after), before.dot(after)));
  };
  std::vector<double> turns;
  for (int i = 0; i < size; ++i) turns.push_back(turn_at(i));
  std::vector<double> out(border.size(), std::numeric_limits<double>::infinity());
  for (int i = 0; i < size; ++i) {
    const double here = turns[static_cast<std::size_t>(i)];
    bool peak = here > corner_turn;
    for (int k = 1; k <= reach && peak; ++k) {
      peak = here >= turns[static_cast<std::size_t>((i + k) % size)] &&
             here >= turns[static_cast<std::size_t>((i - k + size) % size)];
    }
    if (!peak) continue;
    for (int k = 0; k < size; ++k) {
      const int apart = std::min((k - i + size) % size, (i - k + size) % size);
      double& nearest = out[static_cast<std::size_t>(k)];
      nearest = std::min(nearest, apart * step);
    }
  }
  return out;
}

}  // namespace

std::optional<Reach> reach_of(const std::vector<cv::Point2d>& closed) {
  if (closed.size() < 3) return std::nullopt;
  AreaMoments moments(closed.front());
  moments.add(closed);
  if (moments.is_none()) return std::nullopt;
  Reach out;
  out.middle = moments.middle();
  out.spread = root_of(moments.covariance());
  const cv::Matx22d whiten = out.spread.inv();
  constexpr double turn = 2 * std::numbers::pi / Reach::turns;
  // Between two of its points it goes straight.
  const auto place = [&](const cv::Point2d& p) {
    const cv::Vec2d w = whiten * cv::Vec2d(p.x - out.middle.x, p.y - out.middle.y);
    return std::pair(std::atan2(w[1], w[0]) / turn, std::hypot(w[0], w[1]));
  };
  auto [last_turn, last_reach] = place(closed.back());
  for (const cv::Point2d& p : closed) {
    const auto [this_turn, this_reach] = place(p);
    double way = this_turn - last_turn;
    way -= Reach::turns * std::round(way / Reach::turns);
    const int steps = std::max(1, cvCeil(2 * std::abs(way)));
    for (int k = 1; k <= steps; ++k) {
      const double part = static_cast<double>(k) / steps;
      const int bin = (cvRound(last_turn + part * way) + 2 * Reach::turns) % Reach::turns;
      float& reach = out.values[static_cast<std::size_t>(bin)];
      reach = std::max(reach, static_cast<float>(last_reach + part * (this_reach - last_reach)));
    }
    last_turn = this_turn;
    last_reach = this_reach;
  }
  return out;
}

double Reach::variation() const {
  double sum = 0;
  double squares = 0;
  for (const float value : values) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / turns;
  return std::sqrt(std::max(0.0, squares / turns - mean * mean));
}

std::array<double, Reach::turns> reach_errors(const Reach& seen, const Reach& learned) {
  std::array<double, Reach::turns> out;
  for (int turn = 0; turn < Reach::turns; ++turn) {
    double squares = 0;
    for (int i = 0; i < Reach::turns; ++i) {
      const double apart = seen.values[static_cast<std::size_t>((i + turn) % Reach::turns)] -
                           learned.values[static_cast<std::size_t>(i)];
      squares += apart * apart;
    }
    out[static_cast<std::size_t>(turn)] = std::sqrt(squares / Reach::turns);
  }
  return out;
}

ReachFit fit_reach(const Reach& seen, const Reach& learned) {
  const std::array<double, Reach::turns> errors = reach_errors(seen, learned);
  const auto best = std::ranges::min_element(errors);
  return {*best, static_cast<int>(best - errors.begin())};
}

PlaneOutline plane_outline(const MarkTemplate& levels) {
  PlaneOutline out;
  const Picture picture(levels);
  std::vector<Border> borders = borders_in(picture);
  if (borders.empty()) return out;
  undo_stretch(borders);
  const std::optional<Reach> reach = reach_of(borders.front());
  if (!reach) return out;
  out.reach = *reach;
  const cv::Point2d middle_of_area = moments_of(borders).middle();
  out.middle = {middle_of_area.x, middle_of_area.y};
  double all = 0;
  for (const Border& border : borders) all += length_of(border);
  for (const Border& border : borders) {
    const auto share = static_cast<std::size_t>(cvRound(PlaneOutline::count * length_of(border) / all));
    if (share < 8) continue;
    const Border places = evenly(border, share);
    const double reach_in_places = corner_reach * static_cast<double>(share) / length_of(border);
    const std::vector<double> corners = from_corners(places, std::max(1, cvRound(reach_in_places)));
    const std::vector<double> bends = from_corners(places, std::max(1, cvCeil(reach_in_places)));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const cv::Point2d along = places[(i + 1) % places.size()] - places[(i + places.size() - 1) % places.size()];
      const double length = cv::norm(along);
      if (length <= 0) continue;
      cv::Vec2d normal(along.y / length, -along.x / length);
      // Down the picture's slope is out.
      const cv::Point2d slope = picture.slope(Picture::in_fine(places[i]));
      if (normal[0] * slope.x + normal[1] * slope.y > 0) normal = -normal;
      out.points.push_back(
          {{places[i].x, places[i].y}, normal, corners[i], bends[i], picture.ink_from(places[i], -normal)});
    }
    if (&border == &borders.front()) out.outermost = out.points.size();
  }
  number_sides(out.points);
  out.bends = bends_around(out.points);
  cv::Mat1b mark(template_size, template_size);
  std::ranges::transform(levels, mark.begin(), [](std::uint8_t level) -> std::uint8_t { return level >= 8 ? 1 : 0; });
  cv::dilate(mark, mark, cv::Mat(), {-1, -1}, beside);
  std::transform(mark.begin(), mark.end(), out.near.begin(), [](std::uint8_t there) { return there != 0; });
  return out;
}

}  // namespace pizarra::vision
