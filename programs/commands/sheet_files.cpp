// Sheets as files that a printer prints at real size.

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <zlib.h>

#include "drivers/camera/opencv_files.hpp"
#include "programs/commands/print_sheet.hpp"
#include "programs/story/output_file.hpp"

namespace pizarra::programs {
namespace {

constexpr double mm_an_inch = 25.4;
constexpr double dots_an_inch = 300;
constexpr double points_an_inch = 72;

using Bytes = std::vector<std::uint8_t>;

// ---- PNG

constexpr double dots_a_mm = dots_an_inch / mm_an_inch;
// How dark a dot is follows from how much of this many lines through it is covered.
constexpr int lines_a_dot = 16;

struct Span {
  double from;
  double to;
};

using Area = std::vector<Eigen::Vector2d>;

// The areas of the sheet that reach into this range of heights.
std::vector<const Area*> areas_within(const Sheet& sheet, const Span& heights) {
  std::vector<const Area*> out;
  for (const Area& area : sheet.areas) {
    const auto [low, high] = std::ranges::minmax(area, {}, [](const Eigen::Vector2d& p) { return p.y(); });
    if (low.y() < heights.to && high.y() > heights.from) out.push_back(&area);
  }
  return out;
}

// From where to where a convex area reaches at this height, mm.
std::optional<Span> span_of(const Area& area, double y) {
  Span out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Eigen::Vector2d& a = area[i];
    const Eigen::Vector2d& b = area[(i + 1) % area.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    out = {std::min(out.from, x), std::max(out.to, x)};
  }
  if (out.from > out.to) return std::nullopt;
  return out;
}

// Adds to each dot of a line how much of it the spans cover. Spans may overlap.
void cover(cv::Mat1d& line, std::vector<Span> spans) {
  std::ranges::sort(spans, {}, &Span::from);
  double covered_to = 0;
  for (const Span& span : spans) {
    const double from = std::max(span.from * dots_a_mm, covered_to);
    const double to = std::min(span.to * dots_a_mm, static_cast<double>(line.cols));
    for (int x = static_cast<int>(from); x < to; ++x) line(x) += std::min(to, x + 1.0) - std::max<double>(from, x);
    covered_to = std::max(covered_to, to);
  }
}

// Each dot as dark as the part of it that is covered, so that nothing is larger than drawn.
cv::Mat1b raster_of_areas(const Sheet& sheet) {
  cv::Mat1b page(cvRound(Sheet::height_mm * dots_a_mm), cvRound(Sheet::width_mm * dots_a_mm));
  for (int y = 0; y < page.rows; ++y) {
    cv::Mat1d covered(1, page.cols, 0.0);
    const std::vector<const Area*> areas = areas_within(sheet, {y / dots_a_mm, (y + 1) / dots_a_mm});
    for (int i = 0; i < lines_a_dot; ++i) {
      std::vector<Span> spans;
      for (const Area* area : areas) {
        const std::optional<Span> span = span_of(*area, (y + (i + 0.5) / lines_a_dot) / dots_a_mm);
        if (span) spans.push_back(*span);
      }
      cover(covered, std::move(spans));
    }
    covered.convertTo(page.row(y), CV_8U, -255.0 / lines_a_dot, 255);
  }
  return page;
}

cv::Mat1b raster(const Sheet& sheet) {
  cv::Mat1b page = raster_of_areas(sheet);
  for (const Sheet::Text& text : sheet.texts) {
    constexpr double letter_px = 22;  // of OpenCV's letters at scale 1
    const cv::Point at(cvRound(text.at_mm.x() * dots_a_mm), cvRound(text.at_mm.y() * dots_a_mm));
    cv::putText(page, text.words, at, cv::FONT_HERSHEY_SIMPLEX, 0.7 * text.height_mm * dots_a_mm / letter_px,
                cv::Scalar(0), 3, cv::LINE_AA);
  }
  return page;
}

void put_number(Bytes& bytes, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

// Says how many dots a metre has, behind the header, which is always 33 bytes with what comes before.
void say_real_size(Bytes& png) {
  const auto dots_a_metre = static_cast<std::uint32_t>(cvRound(1000 * dots_an_inch / mm_an_inch));
  Bytes named = {'p', 'H', 'Y', 's'};
  put_number(named, dots_a_metre);
  put_number(named, dots_a_metre);
  named.push_back(1);
  Bytes chunk;
  put_number(chunk, static_cast<std::uint32_t>(named.size() - 4));
  chunk.insert(chunk.end(), named.begin(), named.end());
  put_number(chunk, static_cast<std::uint32_t>(crc32_z(0, named.data(), named.size())));
  png.insert(png.begin() + 33, chunk.begin(), chunk.end());
}

Result<Bytes> png_of(const Sheet& sheet) {
  Result<Bytes> bytes = camera::encoded_image(".png", raster(sheet));
  if (bytes) say_real_size(*bytes);
  return bytes;
}

// ---- PDF

// What is drawn: points from the lower left corner.
std::string pdf_drawing(const Sheet& sheet) {
  constexpr double points_a_mm = points_an_inch / mm_an_inch;
  const auto place = [&](const Eigen::Vector2d& p) {
    return fmt::format("{:.3f} {:.3f}", p.x() * points_a_mm, (Sheet::height_mm - p.y()) * points_a_mm);
  };
  std::string out = "0 g\n";
  for (const auto& area : sheet.areas) {
    for (std::size_t i = 0; i < area.size(); ++i) out += place(area[i]) + (i == 0 ? " m\n" : " l\n");
    out += "h f\n";
  }
  for (const Sheet::Text& text : sheet.texts) {
    out +=
        fmt::format("BT /F1 {:.2f} Tf {} Td ({}) Tj ET\n", text.height_mm * points_a_mm, place(text.at_mm), text.words);
  }
  return out;
}

Bytes pdf_of(const Sheet& sheet) {
  const double points_a_mm = points_an_inch / mm_an_inch;
  const std::string drawing = pdf_drawing(sheet);
  const std::string objects[] = {
      "<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:.3f} {:.3f}] /Contents 4 0 R "
                  "/Resources << /Font << /F1 5 0 R >> >> >>",
                  Sheet::width_mm * points_a_mm, Sheet::height_mm * points_a_mm),
      fmt::format("<< /Length {} >>\nstream\n{}endstream", drawing.size(), drawing),
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
  std::string out = "%PDF-1.4\n";
  std::string places = fmt::format("xref\n0 {}\n0000000000 65535 f \n", std::size(objects) + 1);
  for (std::size_t i = 0; i < std::size(objects); ++i) {
    places += fmt::format("{:010} 00000 n \n", out.size());
    out += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t table = out.size();
  out += places;
  out += fmt::format("trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{}\n%%EOF\n", std::size(objects) + 1, table);
  return {out.begin(), out.end()};
}

}  // namespace

Result<void> write_sheet(const std::string& path, const Sheet& sheet) {
  if (path.ends_with(".pdf")) return story::write_file(path, pdf_of(sheet));
  if (path.ends_with(".png")) {
    const Result<Bytes> png = png_of(sheet);
    return png ? story::write_file(path, *png) : fail(png);
  }
  return fail("unknown-format", "a sheet is a FILE.pdf or a FILE.png, not " + path);
}

}  // namespace pizarra::programs
