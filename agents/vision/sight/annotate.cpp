#include "agents/vision/sight/annotate.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace pizarra::vision {
namespace {

// Small images are shown twice as large.
constexpr int widest_enlarged_px = 800;
constexpr int subpixel_bits = 4;
const cv::Scalar white(255, 255, 255);
const cv::Scalar black(0, 0, 0);
const cv::Scalar red(40, 40, 230);

const std::array<cv::Scalar, 6> palette = {cv::Scalar(60, 200, 255), cv::Scalar(90, 220, 90),
                                           cv::Scalar(255, 160, 60), cv::Scalar(220, 100, 230),
                                           cv::Scalar(230, 220, 60), cv::Scalar(120, 150, 255)};

// From a place in the camera's image to one in the picture, in 1/16 px.
cv::Point in_picture(cv::Point2d p, int scale) {
  const double unit = 1 << subpixel_bits;
  return {cvRound(((p.x + 0.5) * scale - 0.5) * unit), cvRound(((p.y + 0.5) * scale - 0.5) * unit)};
}

void darken(cv::Mat& picture, cv::Rect box) {
  box &= cv::Rect(0, 0, picture.cols, picture.rows);
  if (box.empty()) return;
  cv::Mat part = picture(box);
  part *= 0.35;
}

void write_text(cv::Mat& picture, const std::string& text, cv::Point at, double size, const cv::Scalar& colour) {
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, size, colour, 1, cv::LINE_AA);
}

void draw_contour(cv::Mat& picture, const MarkContour& contour, int scale, const cv::Scalar& colour) {
  std::vector<cv::Point> line;
  for (const cv::Point& p : contour) line.push_back(in_picture(p, scale));
  if (line.empty()) return;
  cv::polylines(picture, line, true, colour, 2, cv::LINE_AA, subpixel_bits);
}

// `p`: in_picture().
void draw_cross(cv::Mat& picture, cv::Point p, const cv::Scalar& colour) {
  const int arm = 9 << subpixel_bits;
  for (const auto& [line, width] : {std::pair(black, 3), std::pair(colour, 1)}) {
    cv::line(picture, p - cv::Point(arm, 0), p + cv::Point(arm, 0), line, width, cv::LINE_AA, subpixel_bits);
    cv::line(picture, p - cv::Point(0, arm), p + cv::Point(0, arm), line, width, cv::LINE_AA, subpixel_bits);
  }
}

// Above the object, below it, right or left of it: the first that covers nothing of `taken`, or what covers least.
cv::Rect place_label(cv::Size picture, cv::Rect around, cv::Size size, const std::vector<cv::Rect>& taken) {
  constexpr int gap = 12;
  constexpr int status_bar = 20;
  const cv::Point middle = (around.tl() + around.br()) / 2;
  const cv::Point places[] = {{middle.x - size.width / 2, around.y - gap - size.height},
                              {middle.x - size.width / 2, around.br().y + gap},
                              {around.br().x + gap, middle.y - size.height / 2},
                              {around.x - gap - size.width, middle.y - size.height / 2}};
  const cv::Rect within(2, 2, picture.width - 4, picture.height - status_bar - 4);
  cv::Rect best;
  int least = std::numeric_limits<int>::max();
  for (const cv::Point& place : places) {
    const cv::Rect plate(place, size);
    int covered = plate.area() - (plate & within).area();
    for (const cv::Rect& other : taken) covered += (plate & other).area();
    if (covered >= least) continue;
    least = covered;
    best = plate;
  }
  best.x = std::clamp(best.x, within.x, std::max(within.x, within.br().x - size.width));
  best.y = std::clamp(best.y, within.y, std::max(within.y, within.br().y - size.height));
  return best;
}

struct Label {
  std::string name;
  std::vector<std::string> numbers;  // a line each
};

std::string place_text(cv::Point2d centre) { return fmt::format("{:.1f} {:.1f}", centre.x, centre.y); }

// On a darkened plate beside what it is of.
void draw_label(cv::Mat& picture, const Label& label, cv::Rect of, const cv::Scalar& colour,
                std::vector<cv::Rect>& taken) {
  constexpr int line_px = 12;
  int baseline = 0;
  int width = cv::getTextSize(label.name, cv::FONT_HERSHEY_SIMPLEX, 0.4, 1, &baseline).width;
  for (const std::string& line : label.numbers) {
    width = std::max(width, cv::getTextSize(line, cv::FONT_HERSHEY_SIMPLEX, 0.34, 1, &baseline).width);
  }
  const int height = line_px * static_cast<int>(label.numbers.size() + 1) + 4;
  const cv::Rect plate = place_label(picture.size(), of, {width + 8, height}, taken);
  taken.push_back(plate);
  darken(picture, plate);
  cv::Point at = plate.tl() + cv::Point(4, line_px);
  write_text(picture, label.name, at, 0.4, colour);
  for (const std::string& line : label.numbers) write_text(picture, line, at += cv::Point(0, line_px), 0.34, white);
}

void draw_sightings(cv::Mat& picture, const std::vector<TrackSighting>& sightings, int scale,
                    std::vector<cv::Rect>& taken) {
  const auto box_of = [&](const TrackSighting& sighting) {
    const cv::Rect box = cv::boundingRect(sighting.contour);
    return cv::Rect(box.tl() * scale, box.br() * scale);
  };
  for (const TrackSighting& sighting : sightings) {
    if (!sighting.contour.empty()) taken.push_back(box_of(sighting));
  }
  std::size_t index = 0;
  for (const TrackSighting& sighting : sightings) {
    const cv::Scalar& ink = palette[index++ % palette.size()];
    draw_contour(picture, sighting.contour, scale, ink);
    if (!sighting.seen) continue;
    draw_cross(picture, in_picture(sighting.centre, scale), ink);
    const Label label{sighting.name, {place_text(sighting.centre), fmt::format("{:.1f} mm", sighting.range_mm)}};
    draw_label(picture, label, box_of(sighting), ink, taken);
  }
}

void draw_found(cv::Mat& picture, const std::vector<FoundPlace>& found, int scale, std::vector<cv::Rect>& taken) {
  constexpr int reach_px = 12;
  for (const FoundPlace& each : found) {
    draw_cross(picture, in_picture(each.centre, scale), white);
    const cv::Point middle(each.centre * scale);
    const cv::Point reach(reach_px, reach_px);
    draw_label(picture, {each.name, {place_text(each.centre)}}, {middle - reach, middle + reach}, white, taken);
  }
}

}  // namespace

std::shared_ptr<const Image> annotate(const Image& base, const Annotation& annotation) {
  const cv::Mat seen(base.height, base.width, CV_8UC(base.channels), const_cast<std::uint8_t*>(base.pixels.data()));
  const int scale = base.width <= widest_enlarged_px ? 2 : 1;
  auto out = std::make_shared<Image>();
  out->width = base.width * scale;
  out->height = base.height * scale;
  out->channels = 3;
  out->pixels.resize(static_cast<std::size_t>(out->width * out->height) * 3);
  cv::Mat picture(out->height, out->width, CV_8UC3, out->pixels.data());
  cv::Mat colour = seen;
  if (base.channels == 1) cv::cvtColor(seen, colour, cv::COLOR_GRAY2BGR);
  // A camera may just have come back with images of another size.
  if (annotation.filled.size() == colour.size()) {
    cv::Mat painted = colour.clone();
    painted.setTo(red, annotation.filled);
    colour = painted;
  }
  cv::resize(colour, picture, picture.size(), 0, 0, cv::INTER_CUBIC);
  draw_contour(picture, annotation.learned_contour, scale, palette[1]);
  std::vector<cv::Rect> taken;
  draw_sightings(picture, annotation.sightings, scale, taken);
  draw_found(picture, annotation.found, scale, taken);
  darken(picture, {0, picture.rows - 20, picture.cols, 20});
  write_text(picture, annotation.status, {8, picture.rows - 6}, 0.42, white);
  return out;
}

}  // namespace pizarra::vision
