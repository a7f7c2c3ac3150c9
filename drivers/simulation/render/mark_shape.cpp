#include "drivers/simulation/render/mark_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace pizarra::simulation {

namespace {

using Eigen::Vector2d;
using Shape = std::vector<Polygon>;

constexpr double half_mm = 22;  // of a mark's width
constexpr double cross_arm_mm = 14.7;
constexpr double triangle_height_mm = 37;
constexpr int circle_sides = 48;
constexpr double stroke_mm = 13;  // of a letter

Polygon rectangle(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

Polygon circle() {
  // The polygon's area is the circle's.
  const double sector = 2 * std::numbers::pi / circle_sides;
  const double radius = half_mm * std::sqrt(sector / std::sin(sector));
  Polygon out;
  for (int i = 0; i < circle_sides; ++i) out.emplace_back(radius * std::cos(i * sector), radius * std::sin(i * sector));
  return out;
}

Polygon triangle() {
  const double low = -triangle_height_mm / 3;
  return {{-half_mm, low}, {half_mm, low}, {0, low + triangle_height_mm}};
}

// Five kites, and what covers where they meet.
Shape star() {
  const auto at = [](double radius, double tenths) {
    const double angle = std::numbers::pi * (0.5 + tenths / 5);
    return Vector2d(radius * std::cos(angle), radius * std::sin(angle));
  };
  constexpr double tip = 26;
  constexpr double notch = 11.5;
  Shape parts(1);
  for (int i = 0; i < 10; i += 2) {
    parts.push_back({Vector2d::Zero(), at(notch, i - 1), at(tip, i), at(notch, i + 1)});
    parts[0].push_back(at(notch, i + 1));
  }
  return parts;
}

bool covers(const Polygon& part, const Vector2d& point) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vector2d along = part[(i + 1) % part.size()] - part[i];
    const Vector2d to = point - part[i];
    if (along.x() * to.y() - along.y() * to.x() < 0) return false;
  }
  return true;
}

// Moved so that its centroid is the origin. Parts overlap, so that the centroid is counted out.
Shape centred(Shape parts) {
  constexpr double step_mm = 0.1;
  constexpr double reach_mm = 30;
  Vector2d sum = Vector2d::Zero();
  double count = 0;
  for (double x = -reach_mm; x < reach_mm; x += step_mm) {
    for (double y = -reach_mm; y < reach_mm; y += step_mm) {
      const Vector2d point(x, y);
      if (std::ranges::none_of(parts, [&](const Polygon& part) { return covers(part, point); })) continue;
      sum += point;
      ++count;
    }
  }
  for (Polygon& part : parts) {
    for (Vector2d& point : part) point -= sum / count;
  }
  return parts;
}

Shape arrow() {
  return centred({{{-half_mm, 0}, {half_mm, 0}, {0, half_mm}}, rectangle(-stroke_mm / 2, -half_mm, stroke_mm / 2, 1)});
}

Shape hourglass() {
  constexpr double waist_mm = 6;
  return {{{-waist_mm, 0}, {waist_mm, 0}, {half_mm, half_mm}, {-half_mm, half_mm}},
          {{-half_mm, -half_mm}, {half_mm, -half_mm}, {waist_mm, 1}, {-waist_mm, 1}}};
}

Shape house() { return centred({{{-half_mm, -18}, {half_mm, -18}, {half_mm, 4}, {0, half_mm}, {-half_mm, 4}}}); }

Shape letter_h() {
  return {rectangle(-half_mm, -half_mm, stroke_mm - half_mm, half_mm),
          rectangle(half_mm - stroke_mm, -half_mm, half_mm, half_mm),
          rectangle(-half_mm, -stroke_mm / 2, half_mm, stroke_mm / 2)};
}

// It lies off the middle of its width, and is smaller, so that white is around it.
Shape letter_t() {
  constexpr double off_mm = 18;
  return centred({rectangle(-off_mm, off_mm - stroke_mm, off_mm, off_mm),
                  rectangle(-stroke_mm / 2, -off_mm, stroke_mm / 2, off_mm)});
}

// Three strokes from the middle, a third of a turn apart.
Shape letter_y() {
  Shape strokes;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Rotation2Dd turn((0.25 + i) * 2 * std::numbers::pi / 3);
    Polygon& stroke = strokes.emplace_back(rectangle(-4, -stroke_mm / 2, 24, stroke_mm / 2));
    for (Vector2d& point : stroke) point = turn * point;
  }
  return strokes;
}

Shape letter_z() {
  return {rectangle(-half_mm, half_mm - stroke_mm, half_mm, half_mm),
          rectangle(-half_mm, -half_mm, half_mm, stroke_mm - half_mm),
          {{-half_mm, -half_mm}, {-2, -half_mm}, {half_mm, half_mm}, {2, half_mm}}};
}

}  // namespace

const std::vector<Polygon>& mark_shape(Mark mark) {
  static const std::map<Mark, Shape> shapes = {
      {Mark::circle, {circle()}},
      {Mark::square, {rectangle(-half_mm, -half_mm, half_mm, half_mm)}},
      {Mark::cross,
       {rectangle(-half_mm, -cross_arm_mm / 2, half_mm, cross_arm_mm / 2),
        rectangle(-cross_arm_mm / 2, -half_mm, cross_arm_mm / 2, half_mm)}},
      {Mark::triangle, {triangle()}},
      {Mark::arrow, arrow()},
      {Mark::hourglass, hourglass()},
      {Mark::house, house()},
      {Mark::star, star()},
      {Mark::letter_h, letter_h()},
      {Mark::letter_t, letter_t()},
      {Mark::letter_y, letter_y()},
      {Mark::letter_z, letter_z()},
  };
  return shapes.at(mark);
}

}  // namespace pizarra::simulation
