// Sheets as files that a printer prints at real size.

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <zlib.h>

#include "programs/commands/print_sheet.hpp"
#include "programs/story/output_file.hpp"

namespace pizarra::programs {
namespace {

constexpr double mm_an_inch = 25.4;
constexpr double dots_an_inch = 300;
constexpr double points_an_inch = 72;

using Bytes = std::vector<std::uint8_t>;

// ---- PNG

cv::Mat1b raster(const Sheet& sheet) {
  constexpr double dots_a_mm = dots_an_inch / mm_an_inch;
  constexpr int fraction_bits = 8;
  cv::Mat1b page(cvRound(Sheet::height_mm * dots_a_mm), cvRound(Sheet::width_mm * dots_a_mm), std::uint8_t{255});
  // Pixel (0, 0) reaches from 0 to 1 on paper, and from -0.5 to 0.5 for who draws.
  const auto dots = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d at = (p * dots_a_mm).array() - 0.5;
    return cv::Point(cvRound(at.x() * (1 << fraction_bits)), cvRound(at.y() * (1 << fraction_bits)));
  };
  for (const auto& area : sheet.areas) {
    std::vector<cv::Point> corners;
    for (const Eigen::Vector2d& p : area) corners.push_back(dots(p));
    cv::fillConvexPoly(page, corners, cv::Scalar(0), cv::LINE_AA, fraction_bits);
  }
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

Bytes png_of(const Sheet& sheet) {
  Bytes bytes;
  cv::imencode(".png", raster(sheet), bytes);
  say_real_size(bytes);
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
  if (path.ends_with(".png")) return story::write_file(path, png_of(sheet));
  return fail("unknown-format", "a sheet is a FILE.pdf or a FILE.png, not " + path);
}

}  // namespace pizarra::programs
