#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "programs/method/report.hpp"

namespace pizarra::method {

namespace {

constexpr double size_px = 720;
constexpr double circle_px = 270;
constexpr double half_width_px = 62, half_height_px = 20;

struct Point {
  double x, y;
};

// Names come from a board: whoever told them may have meant to draw.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

// Where a line from a point inside the box around `middle` leaves it on its way to `towards`.
Point edge_of(Point middle, Point inside, Point towards) {
  const double dx = towards.x - inside.x, dy = towards.y - inside.y;
  const auto part = [](double half, double off, double d) {
    return std::abs(d) < 1e-6 ? 1.0 : (std::copysign(half, d) - off) / d;
  };
  const double way =
      std::min(part(half_width_px, inside.x - middle.x, dx), part(half_height_px, inside.y - middle.y, dy));
  return {inside.x + dx * way, inside.y + dy * way};
}

const char* colour_of(const std::string& pattern) {
  if (pattern == "QUERY") return "#1f5fa8";
  if (pattern == "SEND") return "#7a4fa0";
  if (pattern == "EVENT") return "#b3541e";
  if (pattern == "STREAM") return "#7d7d7d";
  return "#2f7d4f";
}

// To the left of its way, so that the two ways of a pair lie side by side; each pattern a lane of its own.
std::string arrow(Point from, Point to, const Connection& connection) {
  const double length = std::max(std::hypot(to.x - from.x, to.y - from.y), 1.0);
  const double lane = connection.pattern == "PUSH" ? 5 : connection.pattern == "QUERY" ? 13 : 21;
  const Point aside{(to.y - from.y) / length * lane, -(to.x - from.x) / length * lane};
  const Point from_aside{from.x + aside.x, from.y + aside.y}, to_aside{to.x + aside.x, to.y + aside.y};
  const Point a = edge_of(from, from_aside, to_aside), b = edge_of(to, to_aside, from_aside);
  const char* colour = colour_of(connection.pattern);
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" marker-end=\"url(#{})\"/>"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\" font-size=\"9\" text-anchor=\"middle\" paint-order=\"stroke\" "
      "stroke=\"white\" stroke-width=\"4\">{}</text>\n",
      a.x, a.y, b.x, b.y, colour, connection.pattern, a.x + (b.x - a.x) * 0.62, a.y + (b.y - a.y) * 0.62 + 3, colour,
      escaped(connection.pattern));
}

}  // namespace

std::string svg_of(const System& system) {
  std::map<std::string, Point> places;
  const double step = 2 * std::numbers::pi / std::max<double>(1, static_cast<double>(system.components.size()));
  double angle = -std::numbers::pi / 2;
  for (const Component& component : system.components) {
    places[component.name] = {size_px / 2 + circle_px * std::cos(angle), size_px / 2 + circle_px * std::sin(angle)};
    angle += step;
  }
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {0:.0f}\" font-family=\"sans-serif\">\n<defs>\n",
      size_px);
  for (const char* pattern : {"QUERY", "SEND", "PUSH", "EVENT", "STREAM", "WIRING"}) {
    out += fmt::format(
        "<marker id=\"{}\" markerWidth=\"8\" markerHeight=\"8\" refX=\"7\" refY=\"3\" orient=\"auto\">"
        "<path d=\"M0,0 L7,3 L0,6 z\" fill=\"{}\"/></marker>\n",
        pattern, colour_of(pattern));
  }
  out += "</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (const Connection& connection : system.connections) {
    const auto from = places.find(connection.from), to = places.find(connection.to);
    if (from != places.end() && to != places.end()) out += arrow(from->second, to->second, connection);
  }
  for (const auto& [name, place] : places) {
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.0f}\" height=\"{:.0f}\" rx=\"5\" fill=\"#f4f1e8\" stroke=\"#333\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"12\">{}</text>\n",
        place.x - half_width_px, place.y - half_height_px, 2 * half_width_px, 2 * half_height_px, place.x, place.y + 4,
        escaped(name));
  }
  return out + "</svg>\n";
}

}  // namespace pizarra::method
