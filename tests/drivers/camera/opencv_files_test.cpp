#include "drivers/camera/opencv_files.hpp"

#include <fstream>
#include <gtest/gtest.h>

#include "drivers/camera/frame_source.hpp"
#include "drivers/camera/image_file.hpp"
#include "tests/scratch.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::camera {
namespace {

// One grey pixel.
constexpr unsigned char png[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
                                 0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00,
                                 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00, 0x00, 0x00, 0x0a, 0x49, 0x44, 0x41, 0x54, 0x78,
                                 0x9c, 0x63, 0x48, 0x01, 0x00, 0x00, 0x66, 0x00, 0x65, 0x7a, 0xa0, 0xc6, 0x92, 0x00,
                                 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

bool loaded(const std::string& library) { return whole_file("/proc/self/maps").contains(library); }

TEST(OpencvFiles, AreLoadedForTheFirstImageThatIsNeitherJpegNorPng) {
  const std::string& folder = scratch_folder();
  std::ofstream(folder + "a.png", std::ios::binary).write(reinterpret_cast<const char*>(png), sizeof png);
  std::ofstream(folder + "b.pgm", std::ios::binary) << "P5 1 1 255\nd";
  const Result<cv::Mat> own = read_image_file(folder + "a.png", true);
  ASSERT_TRUE(own) << own.error().sentence;
  EXPECT_EQ(own->at<std::uint8_t>(0, 0), 'd');
  EXPECT_FALSE(loaded("libopencv_imgcodecs"));
  const Result<cv::Mat> other = read_image_file(folder + "b.pgm", true);
  ASSERT_TRUE(other) << other.error().sentence;
  EXPECT_EQ(other->at<std::uint8_t>(0, 0), 'd');
  EXPECT_TRUE(loaded("libopencv_imgcodecs"));
}

TEST(OpencvFiles, ReadWhatTheyWrote) {
  const cv::Mat1b image(2, 3, 100);
  const Result<ImageBytes> bytes = encoded_image(".bmp", image);
  ASSERT_TRUE(bytes) << bytes.error().sentence;
  const cv::Mat read = opencv_files()->decode(*bytes, true);
  ASSERT_EQ(read.size(), image.size());
  EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0);
}

TEST(OpencvFiles, ThereIsNoImageOfAnEndingThatNoFormatHas) {
  const Result<ImageBytes> none = encoded_image(".story", cv::Mat1b(2, 3, 100));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().symbol, "cannot-write");
  EXPECT_EQ(none.error().sentence, "an image cannot be written as .story");
}

}  // namespace
}  // namespace pizarra::camera
