#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

// It needs <cstdio> before it.
#include <jpeglib.h>
#include <zlib.h>

#include "drivers/camera/jpeg_image.hpp"
#include "drivers/camera/other_images.hpp"
#include "drivers/camera/png_image.hpp"

namespace pizarra::camera {
namespace {

using File = std::vector<unsigned char>;

// Dark shapes on light ground, with noise.
cv::Mat picture(cv::Size size) {
  cv::Mat out(size, CV_8UC3, cv::Scalar(190, 195, 200));
  cv::circle(out, {size.width / 4, size.height / 3}, size.height / 8, cv::Scalar::all(30), cv::FILLED);
  cv::rectangle(out, {size.width / 2, size.height / 2}, {3 * size.width / 4, 3 * size.height / 4}, cv::Scalar::all(40),
                cv::FILLED);
  cv::Mat noise(size, CV_8UC3);
  cv::randu(noise, 0, 12);
  return out + noise;
}

File encoded(const cv::Mat& image, const std::string& ending, const std::vector<int>& how = {}) {
  File out;
  EXPECT_TRUE(cv::imencode(ending, image, out, how)) << ending;
  return out;
}

// Empty: none.
std::string fault_of_image(const File& file) {
  const Result<cv::Mat> image = is_jpeg(file)  ? read_jpeg(file, false)
                                : is_png(file) ? read_png(file, false)
                                               : read_other_image(file, false);
  if (image) return "";
  EXPECT_EQ(image.error().symbol, "corrupt-frame");
  return image.error().sentence;
}

File bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

TEST(ImageFaults, TheSizeStandsInTheHeaderOfEveryKindOfFile) {
  for (const char* ending : {".bmp", ".ppm", ".pgm", ".tif", ".webp"}) {
    cv::Mat image = picture({137, 61});
    if (std::string_view(ending) == ".pgm") cv::cvtColor(image, image, cv::COLOR_BGR2GRAY);
    EXPECT_EQ(size_of_other_image(encoded(image, ending)), (ImageSize{137, 61})) << ending;
  }
  const File lossy = encoded(picture({137, 61}), ".webp", {cv::IMWRITE_WEBP_QUALITY, 80});
  EXPECT_EQ(size_of_other_image(lossy), (ImageSize{137, 61}));
  EXPECT_EQ(size_of_other_image(bytes_of("P5\n# by hand, 7 years ago\n 20 10\n255\n")), (ImageSize{20, 10}));
}

TEST(ImageFaults, AHeaderThatEndsTooSoonHasNoSize) {
  for (const char* ending : {".bmp", ".ppm", ".tif", ".webp"}) {
    File file = encoded(picture({137, 61}), ending);
    for (std::size_t size = 0; size < 8; ++size)
      EXPECT_FALSE(size_of_other_image(std::span(file).first(size))) << ending;
  }
}

TEST(ImageFaults, AnImageThatWouldFillTheMemoryIsRefusedByItsHeader) {
  EXPECT_EQ(fault_of_image(bytes_of("P5 20000 20000 255 ")), "is larger than 16384x8192 px");
  EXPECT_EQ(fault_of_image(bytes_of("P5 16384 8193 255 ")), "is larger than 16384x8192 px");
  File png = encoded(picture({160, 120}), ".png");
  png[18] = 0x40;
  const auto sum = static_cast<std::uint32_t>(crc32_z(0, &png[12], 17));
  for (const int i : {0, 1, 2, 3})
    png[static_cast<std::size_t>(29 + i)] = static_cast<unsigned char>(sum >> (24 - 8 * i));
  EXPECT_EQ(fault_of_image(png), "is larger than 16384x8192 px");
  File jpeg = encoded(picture({160, 120}), ".jpg");
  const std::array<unsigned char, 2> frame_header = {0xff, 0xc0};
  const auto header = std::ranges::search(jpeg, frame_header).begin();
  ASSERT_NE(header, jpeg.end());
  header[5] = 0x40;
  EXPECT_EQ(fault_of_image(jpeg), "is larger than 16384x8192 px");
}

TEST(ImageFaults, SoundJpegsOfAllKindsHaveNone) {
  const std::vector<std::vector<int>> kinds = {{cv::IMWRITE_JPEG_QUALITY, 20},
                                               {cv::IMWRITE_JPEG_QUALITY, 100},
                                               {cv::IMWRITE_JPEG_PROGRESSIVE, 1},
                                               {cv::IMWRITE_JPEG_OPTIMIZE, 1},
                                               {cv::IMWRITE_JPEG_RST_INTERVAL, 4}};
  cv::Mat colour = picture({333, 217});
  cv::Mat grey;
  cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
  for (const std::vector<int>& kind : kinds) {
    EXPECT_EQ(fault_of_image(encoded(colour, ".jpg", kind)), "") << kind[0];
    EXPECT_EQ(fault_of_image(encoded(grey, ".jpg", kind)), "") << kind[0];
  }
}

// Every coefficient of every block in a scan of its own, bit by bit.
File jpeg_of_many_scans(int side, int coefficients) {
  jpeg_error_mgr errors;
  jpeg_compress_struct jpeg{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = jpeg.image_height = static_cast<JDIMENSION>(side);
  jpeg.input_components = 1;
  jpeg.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&jpeg);
  std::vector<jpeg_scan_info> scans{{.comps_in_scan = 1, .component_index = {0}, .Ss = 0, .Se = 0, .Ah = 0, .Al = 0}};
  for (int coefficient = 1; coefficient <= coefficients; ++coefficient) {
    for (int bit = 10; bit >= 0; --bit) {
      scans.push_back({.comps_in_scan = 1,
                       .component_index = {0},
                       .Ss = coefficient,
                       .Se = coefficient,
                       .Ah = bit == 10 ? 0 : bit + 1,
                       .Al = bit});
    }
  }
  jpeg.scan_info = scans.data();
  jpeg.num_scans = static_cast<int>(scans.size());
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<unsigned char> grey(static_cast<std::size_t>(side), 128);
  unsigned char* row = grey.data();
  for (int y = 0; y < side; ++y) jpeg_write_scanlines(&jpeg, &row, 1);
  jpeg_finish_compress(&jpeg);
  File out(bytes, bytes + size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return out;
}

TEST(ImageFaults, AJpegOfMoreScansThanAnyEncoderMakesIsRefusedBeforeTheyAreAllGoneThrough) {
  EXPECT_EQ(fault_of_image(jpeg_of_many_scans(256, 2)), "");
  const File many = jpeg_of_many_scans(2048, 63);
  EXPECT_LT(many.size(), 100'000U);
  EXPECT_EQ(fault_of_image(many), "has more than 32 scans");
}

// A decoder that is led astray ends before its data or after it, unless it finds back in time.
TEST(ImageFaults, AJpegsDamagedDataIsOftenToldAndNeverOnStandardError) {
  const File sound = encoded(picture({640, 480}), ".jpg", {cv::IMWRITE_JPEG_QUALITY, 90});
  cv::RNG random(1);
  constexpr int tries = 200;
  int told = 0;
  testing::internal::CaptureStderr();
  for (int i = 0; i < tries; ++i) {
    File damaged = sound;
    const int at = random.uniform(700, static_cast<int>(sound.size()) - 50);
    for (int j = 0; j < 20; ++j) damaged[static_cast<std::size_t>(at + j)] = static_cast<unsigned char>(random);
    told += fault_of_image(damaged).empty() ? 0 : 1;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  fmt::print("{} of {} told\n", told, tries);
  EXPECT_GT(told, tries / 4);
}

}  // namespace
}  // namespace pizarra::camera
