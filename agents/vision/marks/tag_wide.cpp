#include "agents/vision/marks/tag_wide.hpp"

#include <algorithm>
#include <apriltag/apriltag.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
#include <cassert>
#include <memory>
#include <mutex>

#include "agents/vision/marks/tag_mark.hpp"

namespace pizarra::vision {
namespace {

// libapriltag sees nothing in smaller images, and reads beyond them.
constexpr int least_image_px = 16;

using Codes = std::shared_ptr<apriltag_family_t>;

// One family's codes, and what reads them.
class Reader {
 public:
  Reader(std::string_view name, const Codes& codes, int mended_cells)
      : name_(name), codes_(codes), mended_cells_(mended_cells) {}
  std::string_view name() const { return name_; }
  const apriltag_family_t& codes() const { return *codes_; }

  TagDetection read(const cv::Mat1b& grey) {
    const std::scoped_lock alone(mutex_);
    if (!detector_) open();
    image_u8_t image{grey.cols, grey.rows, static_cast<std::int32_t>(grey.step), grey.data};
    const std::unique_ptr<zarray_t, void (*)(zarray_t*)> found(apriltag_detector_detect(detector_.get(), &image),
                                                               apriltag_detections_destroy);
    TagDetection out;
    for (int i = 0; i < zarray_size(found.get()); ++i) {
      const apriltag_detection_t* tag = nullptr;
      zarray_get(found.get(), i, &tag);
      out.numbers.push_back(tag->id);
      out.found.push_back(corners_of(*tag));
    }
    return out;
  }

 private:
  void open() {
    detector_.reset(apriltag_detector_create());
    detector_->quad_decimate = 1;
    apriltag_detector_add_family_bits(detector_.get(), codes_.get(), mended_cells_);
  }
  // Its corners go counterclockwise and begin at the lower left; half a pixel is the middle of the first one.
  static TagCorners corners_of(const apriltag_detection_t& tag) {
    TagCorners out;
    for (const int i : {3, 2, 1, 0}) {
      out.emplace_back(static_cast<float>(tag.p[i][0] - 0.5), static_cast<float>(tag.p[i][1] - 0.5));
    }
    return out;
  }

  std::string_view name_;
  Codes codes_;
  int mended_cells_;
  std::mutex mutex_;
  // It goes before its codes do.
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector_{nullptr, apriltag_detector_destroy};
};

Reader& reader_of(const TagFamily& family) {
  static Reader readers[] = {
      {"apriltag-standard41h12", Codes(tagStandard41h12_create(), tagStandard41h12_destroy), 1},
      {"apriltag-circle21h7", Codes(tagCircle21h7_create(), tagCircle21h7_destroy), 1},
      {"apriltag-standard52h13", Codes(tagStandard52h13_create(), tagStandard52h13_destroy), 0},
  };
  const auto reader = std::ranges::find(readers, family.name, &Reader::name);
  assert(reader != std::end(readers));
  return *reader;
}

// The rings on both sides of the square's edge: where all families print.
bool is_at_the_edge(const apriltag_family_t& codes, cv::Point cell) {
  const int around = (codes.total_width - codes.width_at_border) / 2;
  const int last = codes.total_width - 1;
  const int ring = std::min({cell.x, cell.y, last - cell.x, last - cell.y});
  return ring == around || ring == around - 1;
}

}  // namespace

TagDetection detect_wide_tags(const cv::Mat1b& grey, const TagFamily& family) {
  TagDetection out;
  if (std::min(grey.cols, grey.rows) < least_image_px) return out;
  TagDetection read = reader_of(family).read(grey);
  for (std::size_t i = 0; i < read.found.size(); ++i) {
    TagCorners& corners = read.found[i];
    const bool is_tag = has_a_border(grey, corners, family) &&
                        tag_likeness(grey, corners, family, read.numbers[i]) >= least_tag_likeness(family);
    if (!is_tag) continue;
    out.numbers.push_back(read.numbers[i]);
    out.found.push_back(std::move(corners));
  }
  return out;
}

int wide_tags_of(const TagFamily& family) { return static_cast<int>(reader_of(family).codes().ncodes); }

cv::Mat1b wide_print(const TagFamily& family, int number) {
  const apriltag_family_t& codes = reader_of(family).codes();
  const std::uint64_t code = codes.codes[number];
  const int around = (codes.total_width - codes.width_at_border) / 2;
  cv::Mat1b out(codes.total_width, codes.total_width, unprinted);
  for (int y = 0; y < out.rows; ++y) {
    for (int x = 0; x < out.cols; ++x) {
      if (!is_at_the_edge(codes, {x, y})) continue;
      const cv::Rect square(around, around, codes.width_at_border, codes.width_at_border);
      out(y, x) = square.contains({x, y}) ? 255 : 0;
    }
  }
  for (std::uint32_t i = 0; i < codes.nbits; ++i) {
    // The first cell's bit is the highest. Cells count from the square's corner.
    const bool light = (code >> (codes.nbits - 1 - i) & 1) != 0;
    out(static_cast<int>(codes.bit_y[i]) + around, static_cast<int>(codes.bit_x[i]) + around) = light ? 255 : 0;
  }
  return out;
}

}  // namespace pizarra::vision
