#include "agents/vision/marks/mark_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pizarra::vision {
namespace {

// Of the contour, each as long as the others. A side has so many of them.
constexpr std::size_t parts = 24;
constexpr std::size_t least_side = 3;
constexpr std::size_t most_side = parts / 2;
// Of the contour so many places tell enough.
constexpr std::size_t most_places = 96;
constexpr std::size_t least_places = 12;
// Where the contour turns by more than that it has a corner, beyond which blur leaves less of the mark.
const double cosine_of_corner = std::cos(40 * CV_PI / 180);
// How far outside its edge the ground is looked at. Nearer there is most of the mark's own blur, farther that of where
// a narrow margin ends; what hides a part is there at both.
constexpr std::array beyond_edge_px = {1.25, 2.0};
constexpr double well_outside_px = 2.5;
// By how much ground differs that is one: grey levels, a part of the contrast, and standard deviations of noise, of
// which the most unlike of so many sides has some four.
constexpr double uneven_levels = 5;
constexpr double uneven_share = 0.03;
constexpr double most_deviations = 8;

double level_at(const cv::Mat1b& grey, cv::Point2d place) {
  const double x = std::clamp(place.x, 0.0, grey.cols - 1.001);
  const double y = std::clamp(place.y, 0.0, grey.rows - 1.001);
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double right = x - column;
  const double down = y - row;
  const std::uint8_t* above = grey.ptr<std::uint8_t>(row) + column;
  const std::uint8_t* below = above + grey.step;
  return (1 - down) * ((1 - right) * above[0] + right * above[1]) + down * ((1 - right) * below[0] + right * below[1]);
}

struct Place {
  cv::Point2d at;
  cv::Point2d outwards;  // 1 px
  std::size_t part;

  cv::Point2d beyond(double px) const { return at + px * outwards; }
};

// Along the contour, without its corners.
std::vector<Place> places_along(const MarkContour& contour) {
  const std::size_t size = contour.size();
  const std::size_t reach = std::max<std::size_t>(3, size / 32);
  const std::size_t count = std::min(size, most_places);
  const double side = signed_area(contour) > 0 ? 1 : -1;
  std::vector<Place> out;
  out.reserve(count);
  for (std::size_t i = 0; size >= least_places && i < count; ++i) {
    const std::size_t here = i * size / count;
    const cv::Point2d at = contour[here];
    const cv::Point2d before = at - cv::Point2d(contour[(here + size - reach) % size]);
    const cv::Point2d after = cv::Point2d(contour[(here + reach) % size]) - at;
    if (before.dot(after) < cosine_of_corner * std::sqrt(before.dot(before) * after.dot(after))) continue;
    const cv::Point2d along = before + after;
    const cv::Point2d outwards = side / std::sqrt(along.dot(along)) * cv::Point2d(along.y, -along.x);
    out.push_back({at, outwards, i * parts / count});
  }
  return out;
}

// How far outside the place its edge is, where the level passes the middle.
double edge_px(const cv::Mat1b& grey, const Place& place, double middle) {
  constexpr double between_pixels = 0.5;
  double before = level_at(grey, place.beyond(-1)) - middle;
  for (const int px : {0, 1, 2}) {
    const double now = level_at(grey, place.beyond(px)) - middle;
    if ((now > 0) != (before > 0)) return px - 1 + before / (before - now);
    before = now;
  }
  return between_pixels;
}

// Of samples: how many, where they are, and how far from the light's slope.
struct Samples {
  double count = 0;
  cv::Point2d at = {};
  double level = 0;

  cv::Vec3d row() const { return {count, at.x, at.y}; }
  Samples& operator+=(const Samples& other) {
    count += other.count;
    at += other.at;
    level += other.level;
    return *this;
  }
};

struct Ground {
  std::array<std::array<Samples, parts>, beyond_edge_px.size()> beyond{};
  double contrast = 0;
};

Ground ground_of(const cv::Mat1b& grey, const std::vector<Place>& places, cv::Point2d centre) {
  Ground out;
  double inside = 0;
  double outside = 0;
  for (const Place& place : places) {
    inside += level_at(grey, place.beyond(-1));
    outside += level_at(grey, place.beyond(well_outside_px));
  }
  const auto count = static_cast<double>(places.size());
  out.contrast = std::abs(outside - inside) / count;
  for (const Place& place : places) {
    const double edge = edge_px(grey, place, (inside + outside) / 2 / count);
    for (std::size_t i = 0; i < beyond_edge_px.size(); ++i) {
      const cv::Point2d at = place.beyond(edge + beyond_edge_px[i]);
      out.beyond[i][place.part] += {1, at - centre, level_at(grey, at)};
    }
  }
  return out;
}

// Takes the light's slope away, the plane that fits best, and gives the inverse of its normal matrix.
cv::Matx33d flatten(std::array<Samples, parts>& all) {
  cv::Matx33d normal = cv::Matx33d::zeros();
  cv::Vec3d right = cv::Vec3d::all(0);
  for (const Samples& part : all) {
    if (part.count == 0) continue;
    normal += part.row() * part.row().t() * (1 / part.count);
    right += part.level / part.count * part.row();
  }
  const cv::Matx33d inverse = normal.inv();
  const cv::Vec3d plane = inverse * right;
  for (Samples& part : all) part.level -= plane.dot(part.row());
  return inverse;
}

// A side and the ground beyond the others, as a plane with a step.
struct Step {
  double height = 0;  // grey levels
  double weight = 0;  // so many samples of the height's own would say as much
  double apart = 1;   // how much of that the plane leaves: what is uneven counts the more, the more it is like a slope

  // How much of the squared differences from a plane it explains.
  double explained() const { return height * height * weight; }
};

// By linear least squares: of all sides the one whose step explains most.
Step most_unlike_side(const std::array<Samples, parts>& flat, const cv::Matx33d& inverse) {
  Step best;
  double count = 0;
  for (const Samples& part : flat) count += part.count;
  for (std::size_t first = 0; first < parts; ++first) {
    Samples side;
    for (std::size_t length = 1; length <= most_side; ++length) {
      side += flat[(first + length - 1) % parts];
      if (length < least_side) continue;
      const double weight = side.count - side.row().dot(inverse * side.row());
      if (weight <= 1) continue;
      const Step step{side.level / weight, weight, weight / (side.count - side.count * side.count / count)};
      if (step.explained() > best.explained()) best = step;
    }
  }
  return best;
}

// Of one sample about plane and step: as they scatter, and no less than noise makes of what lies between pixels.
double variance_of(const std::array<Samples, parts>& flat, const Step& step, double noise) {
  constexpr double left_between_pixels = 0.5;
  constexpr int unknowns = 4;
  double squares = -step.explained();
  int known = -unknowns;
  for (const Samples& part : flat) {
    if (part.count == 0) continue;
    squares += part.level * part.level / part.count;
    ++known;
  }
  return std::max(squares / std::max(1, known), left_between_pixels * noise * noise);
}

// At one distance.
double doubt_of(std::array<Samples, parts>& beyond, double contrast, double noise) {
  const cv::Matx33d inverse = flatten(beyond);
  const Step step = most_unlike_side(beyond, inverse);
  if (step.weight == 0) return 0;
  const double spread = std::sqrt(variance_of(beyond, step, noise) / step.weight);
  const double uneven = std::hypot(uneven_levels, uneven_share * contrast) / std::sqrt(step.apart);
  return std::abs(step.height) / std::hypot(uneven, most_deviations * spread);
}

}  // namespace

double ground_doubt(const cv::Mat1b& grey, double noise, const SeenMark& mark) {
  const std::vector<Place> places = places_along(mark.contour);
  if (places.size() < least_places) return 0;
  Ground ground = ground_of(grey, places, mark.centre);
  double least = doubt_of(ground.beyond.front(), ground.contrast, noise);
  for (std::size_t i = 1; i < beyond_edge_px.size() && least > 0; ++i) {
    least = std::min(least, doubt_of(ground.beyond[i], ground.contrast, noise));
  }
  return least;
}

}  // namespace pizarra::vision
