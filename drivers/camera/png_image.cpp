#include "drivers/camera/png_image.hpp"

#include <csetjmp>
#include <cstring>
#include <fmt/format.h>
#include <png.h>

#include "drivers/camera/header_numbers.hpp"
#include "drivers/camera/image_faults.hpp"
#include "drivers/camera/orientation.hpp"

namespace pizarra::camera {
namespace {

using Bytes = std::span<const unsigned char>;

struct Reading {
  Bytes left;
  ImageSize most;
  cv::Mat pixels;
  int orientation = 1;
  std::string fault;
  std::jmp_buf found;
};

[[noreturn]] void refuse(Reading& reading, std::string_view fault) {
  reading.fault = fault;
  std::longjmp(reading.found, 1);
}

[[noreturn]] void take_error(png_structp png, png_const_charp said) {
  auto& reading = *static_cast<Reading*>(png_get_error_ptr(png));
  reading.fault = fmt::format("cannot be read: libpng says \"{}\"", said);
  std::longjmp(reading.found, 1);
}

// Of colour profiles and comments, no pixels.
void pass_over_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep out, std::size_t count) {
  auto& reading = *static_cast<Reading*>(png_get_io_ptr(png));
  if (count > reading.left.size()) refuse(reading, cut_short);
  std::memcpy(out, reading.left.data(), count);
  reading.left = reading.left.subspan(count);
}

// Whatever the file has becomes 8 bits of grey or BGR.
void choose_pixels(png_structp png, png_infop info, bool grey) {
  constexpr int no_warning = 1;
  const bool coloured = (png_get_color_type(png, info) & PNG_COLOR_MASK_COLOR) != 0;
  png_set_strip_16(png);
  png_set_strip_alpha(png);
  png_set_palette_to_rgb(png);
  png_set_expand_gray_1_2_4_to_8(png);
  if (grey) {
    png_set_rgb_to_gray(png, no_warning, 0.299, 0.587);
  } else if (coloured) {
    png_set_bgr(png);
  } else {
    png_set_gray_to_rgb(png);
  }
}

int orientation_of(png_structp png, png_infop info) {
  png_uint_32 size = 0;
  png_bytep exif = nullptr;
  return png_get_eXIf_1(png, info, &size, &exif) != 0 ? orientation_in(Bytes(exif, size)) : 1;
}

// It is left by a jump where there is a fault, so nothing in here may have a destructor.
void decode(png_structp png, png_infop info, bool grey, Reading& reading) {
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_set_read_fn(png, &reading, take_bytes);
  png_read_info(png, info);
  const ImageSize size{png_get_image_width(png, info), png_get_image_height(png, info)};
  if (is_too_large(size, reading.most)) refuse(reading, larger_than(reading.most));
  choose_pixels(png, info, grey);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  cv::Mat& pixels = reading.pixels;
  pixels.create(static_cast<int>(size.height), static_cast<int>(size.width), grey ? CV_8UC1 : CV_8UC3);
  if (png_get_rowbytes(png, info) != pixels.step) refuse(reading, no_image);
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < pixels.rows; ++y) png_read_row(png, pixels.ptr(y), nullptr);
  }
  png_read_end(png, info);
  reading.orientation = orientation_of(png, info);
}

}  // namespace

bool is_png(Bytes bytes) { return says(bytes, 0, "\x89PNG\r\n\x1a\n"); }

ImageSize png_size(Bytes bytes) {
  return {number(bytes, 16, 4, std::endian::big), number(bytes, 20, 4, std::endian::big)};
}

Result<cv::Mat> read_png(Bytes bytes, bool grey, ImageSize most) {
  Reading reading;
  reading.left = bytes;
  reading.most = most;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, take_error, pass_over_warning);
  png_infop info = png_create_info_struct(png);
  if (setjmp(reading.found) == 0) decode(png, info, grey, reading);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!reading.fault.empty()) return image_fault(reading.fault);
  turn_upright(reading.pixels, reading.orientation);
  return std::move(reading.pixels);
}

}  // namespace pizarra::camera
