#include "drivers/camera/jpeg_image.hpp"

#include <csetjmp>
#include <cstdio>
#include <fmt/format.h>

// They need <cstdio> before them.
#include <jerror.h>
#include <jpeglib.h>

#include "drivers/camera/header_numbers.hpp"
#include "drivers/camera/image_faults.hpp"
#include "drivers/camera/orientation.hpp"

namespace pizarra::camera {
namespace {

using Bytes = std::span<const unsigned char>;

constexpr int exif_marker = JPEG_APP0 + 1;

struct Photograph {
  cv::Mat pixels;
  int orientation = 1;
};

struct Judge {
  jpeg_error_mgr manager;  // the first: libjpeg knows of this alone
  std::jmp_buf found;
  std::string_view fault;  // ours; empty: libjpeg's
};

Judge& judge_of(j_common_ptr jpeg) { return *reinterpret_cast<Judge*>(jpeg->err); }

[[noreturn]] void end_reading(j_common_ptr jpeg) { std::longjmp(judge_of(jpeg).found, 1); }

[[noreturn]] void refuse(j_common_ptr jpeg, std::string_view fault) {
  judge_of(jpeg).fault = fault;
  end_reading(jpeg);
}

// Called between rows of blocks.
void count_scans(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > most_scans) refuse(jpeg, "has more than 32 scans");
}

// Warnings are below 0, traces above.
void take_message(j_common_ptr jpeg, int level) {
  if (level < 0) end_reading(jpeg);
}

int orientation_of(const jpeg_decompress_struct& jpeg) {
  constexpr std::string_view mark("Exif\0\0", 6);
  for (const jpeg_marker_struct* marker = jpeg.marker_list; marker != nullptr; marker = marker->next) {
    const Bytes data(marker->data, marker->data_length);
    if (says(data, 0, mark)) return orientation_in(data.subspan(mark.size()));
  }
  return 1;
}

// It is left by a jump where there is a fault, so nothing in here may have a destructor.
void decode(jpeg_decompress_struct& jpeg, bool grey, ImageSize most, Photograph& out) {
  const auto common = reinterpret_cast<j_common_ptr>(&jpeg);
  jpeg_save_markers(&jpeg, exif_marker, 0xffff);
  jpeg_read_header(&jpeg, TRUE);
  if (is_too_large({jpeg.image_width, jpeg.image_height}, most)) refuse(common, larger_than(most));
  if (jpeg.num_components == 4) refuse(common, "has the colours of a printer (CMYK), not of a camera");
  out.orientation = orientation_of(jpeg);
  jpeg.out_color_space = grey ? JCS_GRAYSCALE : JCS_EXT_BGR;
  jpeg_start_decompress(&jpeg);
  out.pixels.create(static_cast<int>(jpeg.output_height), static_cast<int>(jpeg.output_width),
                    grey ? CV_8UC1 : CV_8UC3);
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = out.pixels.ptr(static_cast<int>(jpeg.output_scanline));
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
}

std::string fault_found(j_common_ptr jpeg) {
  const Judge& judge = judge_of(jpeg);
  if (!judge.fault.empty()) return std::string(judge.fault);
  if (judge.manager.msg_code == JWRN_JPEG_EOF) return std::string(cut_short);
  char said[JMSG_LENGTH_MAX];
  judge.manager.format_message(jpeg, said);
  return fmt::format("cannot be read: libjpeg says \"{}\"", said);
}

}  // namespace

bool is_jpeg(Bytes bytes) { return says(bytes, 0, "\xff\xd8"); }

Result<cv::Mat> read_jpeg(Bytes bytes, bool grey, ImageSize most) {
  Photograph photograph;
  Judge judge;
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&judge.manager);
  judge.manager.error_exit = end_reading;
  judge.manager.emit_message = take_message;
  jpeg_progress_mgr progress{};
  progress.progress_monitor = count_scans;
  if (setjmp(judge.found) != 0) {
    std::string fault = fault_found(reinterpret_cast<j_common_ptr>(&jpeg));
    jpeg_destroy_decompress(&jpeg);
    return image_fault(fault);
  }
  jpeg_create_decompress(&jpeg);
  jpeg.progress = &progress;
  jpeg_mem_src(&jpeg, bytes.data(), bytes.size());
  decode(jpeg, grey, most, photograph);
  jpeg_destroy_decompress(&jpeg);
  turn_upright(photograph.pixels, photograph.orientation);
  return std::move(photograph.pixels);
}

}  // namespace pizarra::camera
