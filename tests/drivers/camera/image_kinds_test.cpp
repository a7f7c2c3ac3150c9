// Every kind of JPEG and PNG is read as OpenCV reads it, to the pixel.

#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <png.h>

// It needs <cstdio> before it.
#include <jpeglib.h>

#include "drivers/camera/jpeg_image.hpp"
#include "drivers/camera/png_image.hpp"

namespace pizarra::camera {
namespace {

using File = std::vector<unsigned char>;

void expect_read_as_by_opencv(const File& file) {
  for (const bool grey : {false, true}) {
    const Result<cv::Mat> read = is_jpeg(file) ? read_jpeg(file, grey) : read_png(file, grey);
    ASSERT_TRUE(read) << read.error().sentence;
    const cv::Mat expected = cv::imdecode(file, grey ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR);
    ASSERT_EQ(read->size(), expected.size());
    ASSERT_EQ(read->type(), expected.type());
    EXPECT_EQ(cv::norm(*read, expected, cv::NORM_INF), 0) << (grey ? "grey" : "colour");
  }
}

// Rows of samples as they lie in memory, of noise.
cv::Mat noise_rows(int height, std::size_t row_bytes) {
  cv::Mat out(height, static_cast<int>(row_bytes), CV_8UC1);
  cv::randu(out, 0, 256);
  return out;
}

// ---- PNG

struct PngKind {
  int colours;
  int bits;
  bool interlaced = false;
  bool transparency = false;  // beside the pixels
  double gamma = 0;
  std::vector<unsigned char> exif = {};
};

constexpr int png_width = 61;
constexpr int png_height = 43;

void take(png_structp png, png_bytep bytes, std::size_t count) {
  auto& file = *static_cast<File*>(png_get_io_ptr(png));
  file.insert(file.end(), bytes, bytes + count);
}

void say_transparency(png_structp png, png_infop info, const PngKind& kind) {
  png_byte levels[2] = {0, 128};
  const png_color_16 colour{.index = 0, .red = 7, .green = 7, .blue = 7, .gray = 1};
  if (kind.colours == PNG_COLOR_TYPE_PALETTE) {
    png_set_tRNS(png, info, levels, 2, nullptr);
  } else {
    png_set_tRNS(png, info, nullptr, 0, &colour);
  }
}

File png_of(const PngKind& kind) {
  File out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &out, take, nullptr);
  png_set_IHDR(png, info, png_width, png_height, kind.bits, kind.colours,
               kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette(1U << std::min(kind.bits, 8));
  for (png_color& colour : palette) {
    colour = {static_cast<png_byte>(cv::theRNG()), static_cast<png_byte>(cv::theRNG()),
              static_cast<png_byte>(cv::theRNG())};
  }
  if (kind.colours == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  if (kind.transparency) say_transparency(png, info, kind);
  if (kind.gamma > 0) png_set_gAMA(png, info, kind.gamma);
  File exif = kind.exif;
  if (!exif.empty()) png_set_eXIf_1(png, info, static_cast<png_uint_32>(exif.size()), exif.data());
  png_write_info(png, info);
  const cv::Mat rows = noise_rows(png_height, png_get_rowbytes(png, info));
  const int passes = png_set_interlace_handling(png);
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < rows.rows; ++y) png_write_row(png, rows.ptr(y));
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

TEST(ImageKinds, PngsOfAllBitsAndColoursAreReadAsByOpenCv) {
  struct Depths {
    int colours;
    std::vector<int> bits;
  };
  const std::vector<Depths> all = {{PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16}},
                                   {PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8}},
                                   {PNG_COLOR_TYPE_RGB, {8, 16}},
                                   {PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16}},
                                   {PNG_COLOR_TYPE_RGB_ALPHA, {8, 16}}};
  for (const auto& [colours, depths] : all) {
    for (const int bits : depths) {
      for (const bool interlaced : {false, true}) {
        for (const double gamma : {0.0, 0.45}) {
          SCOPED_TRACE(fmt::format("colours {} bits {} interlaced {} gamma {}", colours, bits, interlaced, gamma));
          expect_read_as_by_opencv(png_of({colours, bits, interlaced, false, gamma}));
          const bool has_alpha = (colours & PNG_COLOR_MASK_ALPHA) != 0;
          if (!has_alpha) expect_read_as_by_opencv(png_of({colours, bits, interlaced, true, gamma}));
        }
      }
    }
  }
}

// ---- which way up

// A directory of one entry: a number of two bytes.
File exif_of(int orientation, bool big_endian) {
  const auto o = static_cast<unsigned char>(orientation);
  if (big_endian) return {'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, o, 0, 0, 0, 0, 0, 0};
  return {'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, o, 0, 0, 0, 0, 0, 0, 0};
}

TEST(ImageKinds, APngIsTurnedAsItsCameraSays) {
  for (int orientation = 0; orientation <= 9; ++orientation) {
    SCOPED_TRACE(orientation);
    for (const bool big_endian : {false, true}) {
      expect_read_as_by_opencv(
          png_of({.colours = PNG_COLOR_TYPE_RGB, .bits = 8, .exif = exif_of(orientation, big_endian)}));
    }
  }
}

// ---- JPEG

struct JpegKind {
  J_COLOR_SPACE given = JCS_RGB;
  J_COLOR_SPACE stored = JCS_YCbCr;
  std::array<int, 2> sampling = {2, 2};  // of the brightness; colour has one
  bool progressive = false;
  int restart_rows = 0;
  int quality = 90;
  File exif = {};
  cv::Size size = {67, 45};
};

File jpeg_of(const JpegKind& kind) {
  jpeg_error_mgr errors;
  jpeg_compress_struct jpeg{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(kind.size.width);
  jpeg.image_height = static_cast<JDIMENSION>(kind.size.height);
  jpeg.input_components = kind.given == JCS_GRAYSCALE ? 1 : kind.given == JCS_CMYK ? 4 : 3;
  jpeg.in_color_space = kind.given;
  jpeg_set_defaults(&jpeg);
  jpeg_set_colorspace(&jpeg, kind.stored);
  jpeg_set_quality(&jpeg, kind.quality, TRUE);
  if (kind.stored == JCS_YCbCr) {
    jpeg.comp_info[0].h_samp_factor = kind.sampling[0];
    jpeg.comp_info[0].v_samp_factor = kind.sampling[1];
  }
  if (kind.progressive) jpeg_simple_progression(&jpeg);
  jpeg.restart_in_rows = kind.restart_rows;
  jpeg_start_compress(&jpeg, TRUE);
  if (!kind.exif.empty()) {
    File marker = {'E', 'x', 'i', 'f', 0, 0};
    marker.insert(marker.end(), kind.exif.begin(), kind.exif.end());
    jpeg_write_marker(&jpeg, JPEG_APP0 + 1, marker.data(), static_cast<unsigned>(marker.size()));
  }
  cv::Mat pixels = noise_rows(kind.size.height, static_cast<std::size_t>(kind.size.width * jpeg.input_components));
  cv::blur(pixels, pixels, {9, 9});
  for (int y = 0; y < pixels.rows; ++y) {
    JSAMPROW row = pixels.ptr(y);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  File out(bytes, bytes + size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return out;
}

TEST(ImageKinds, JpegsOfAllKindsAreReadAsByOpenCv) {
  for (const bool progressive : {false, true}) {
    for (const int quality : {20, 75, 100}) {
      for (const std::array<int, 2> sampling :
           {std::array{1, 1}, std::array{2, 1}, std::array{1, 2}, std::array{2, 2}, std::array{4, 1}}) {
        SCOPED_TRACE(
            fmt::format("progressive {} quality {} sampling {}x{}", progressive, quality, sampling[0], sampling[1]));
        expect_read_as_by_opencv(jpeg_of({.sampling = sampling, .progressive = progressive, .quality = quality}));
      }
      expect_read_as_by_opencv(jpeg_of({JCS_GRAYSCALE, JCS_GRAYSCALE, {}, progressive, 0, quality}));
      expect_read_as_by_opencv(jpeg_of({JCS_RGB, JCS_RGB, {}, progressive, 0, quality}));
    }
  }
  expect_read_as_by_opencv(jpeg_of({.restart_rows = 1}));
  for (const int side : {1, 2, 7, 8, 9, 16, 17}) expect_read_as_by_opencv(jpeg_of({.size = {side, side}}));
}

TEST(ImageKinds, AJpegIsTurnedAsItsCameraSays) {
  for (int orientation = 0; orientation <= 9; ++orientation) {
    SCOPED_TRACE(orientation);
    for (const bool big_endian : {false, true})
      expect_read_as_by_opencv(jpeg_of({.exif = exif_of(orientation, big_endian)}));
  }
}

TEST(ImageKinds, ExifThatEndsTooSoonTurnsNothing) {
  const File whole = exif_of(6, false);
  for (std::size_t size = 0; size < whole.size() - 6; ++size) {
    SCOPED_TRACE(size);
    File exif(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    const Result<cv::Mat> read = read_jpeg(jpeg_of({.exif = exif}), true);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->size(), (cv::Size{67, 45}));
  }
}

TEST(ImageKinds, APrintersColoursAreNoCameras) {
  for (const J_COLOR_SPACE stored : {JCS_CMYK, JCS_YCCK}) {
    const Result<cv::Mat> read = read_jpeg(jpeg_of({.given = JCS_CMYK, .stored = stored}), false);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().sentence, "has the colours of a printer (CMYK), not of a camera");
  }
}

}  // namespace
}  // namespace pizarra::camera
