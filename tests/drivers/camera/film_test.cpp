// Films as a camera, without what OpenCV reads films with: a program of its own, since other tests load that
// themselves.

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "drivers/camera/film_source.hpp"
#include "tests/scratch.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::camera {
namespace {

constexpr int width = 96;
constexpr int height = 64;

// Of a film, levels from 16 to 235 are all that are shown.
std::uint8_t shown(int level) { return static_cast<std::uint8_t>(std::lround((level - 16) * 255 / 219.0)); }

// Of so many pictures, each of one level: 50, 60, ...
std::string uncompressed(int pictures, const std::string& size = fmt::format("W{} H{}", width, height)) {
  std::string out = "YUV4MPEG2 " + size + " F25:1 Ip A1:1 C420jpeg\n";
  for (int i = 0; i < pictures; ++i) {
    out += "FRAME\n" + std::string(width * height, static_cast<char>(50 + 10 * i));
    out += std::string(2 * (width / 2) * (height / 2), static_cast<char>(128));
  }
  return out;
}

std::string written(const std::string& name, const std::string& bytes) {
  std::string path = scratch_folder() + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

TEST(Film, IsReadWithoutTheReadersThatOpencvLoads) {
  FilmSource film(written("film.y4m", uncompressed(3)), 0);
  ASSERT_TRUE(film.open());
  EXPECT_EQ(film.recorded_hz(), 25);
  for (int i = 0; i < 3; ++i) {
    const Result<std::optional<double>> moment_ms = film.grab();
    ASSERT_TRUE(moment_ms);
    EXPECT_NEAR(**moment_ms, 40 * i, 1e-6);
    const Result<cv::Mat> grey = film.retrieve(true);
    ASSERT_TRUE(grey);
    EXPECT_LE(cv::norm(*grey, cv::Mat1b(height, width, shown(50 + 10 * i)), cv::NORM_INF), 1);
    const Result<cv::Mat> colour = film.retrieve(false);
    ASSERT_TRUE(colour);
    const cv::Mat3b same(height, width, cv::Vec3b::all(shown(50 + 10 * i)));
    EXPECT_LE(cv::norm(*colour, same, cv::NORM_INF), 1);
  }
  const std::string maps = whole_file("/proc/self/maps");
  EXPECT_TRUE(maps.contains("libavformat"));
  for (const char* not_loaded : {"opencv_videoio", "gstreamer", "gdal"}) EXPECT_FALSE(maps.contains(not_loaded));
}

TEST(Film, ThatUsesAllLevelsIsShownAsItIs) {
  const std::string all = uncompressed(1, fmt::format("W{} H{} XCOLORRANGE=FULL", width, height));
  FilmSource film(written("film.y4m", all), 0);
  ASSERT_TRUE(film.open());
  ASSERT_TRUE(film.grab());
  EXPECT_EQ(film.retrieve(true)->at<std::uint8_t>(0, 0), 50);
}

TEST(Film, IsOverOnceAndBeginsAnewWhereItIsOpenedAgain) {
  FilmSource film(written("film.y4m", uncompressed(2)), 10);
  for (int turn = 0; turn < 2; ++turn) {
    ASSERT_TRUE(film.open());
    EXPECT_EQ(film.recorded_hz(), 10);
    ASSERT_TRUE(film.grab());
    EXPECT_NEAR(film.retrieve(true)->at<std::uint8_t>(0, 0), shown(50), 1);
    ASSERT_TRUE(film.grab());
    EXPECT_EQ(film.grab().error().symbol, "ended");
    EXPECT_EQ(film.grab().error().symbol, "ended");
    film.close();
  }
}

TEST(Film, MayHaveAColonInItsName) {
  FilmSource film(written("2026-11-30 10:22 cell.y4m", uncompressed(1)), 0);
  ASSERT_TRUE(film.open());
  EXPECT_TRUE(film.grab());
}

TEST(Film, ThatIsCutShortGivesWhatIsThere) {
  const std::string whole = uncompressed(3);
  FilmSource film(written("film.y4m", whole.substr(0, whole.size() - 1000)), 0);
  ASSERT_TRUE(film.open());
  int whole_ones = 0;
  while (film.grab()) whole_ones += film.retrieve(true) ? 1 : 0;
  EXPECT_EQ(whole_ones, 2);
}

TEST(Film, OfNoPicturesIsNoCamera) {
  const auto symbol_of = [](const std::string& bytes) {
    FilmSource film(written("film", bytes), 0);
    const Result<void> opened = film.open();
    return opened ? film.grab().error().symbol : opened.error().symbol;
  };
  const std::string silence("RIFF\x34\0\0\0WAVEfmt \x10\0\0\0\1\0\1\0\x40\x1f\0\0\x80\x3e\0\0\2\0\x10\0data\x10\0\0\0",
                            44);
  for (const std::string& bytes :
       {std::string(), std::string("no film"), uncompressed(0), silence + std::string(16, 0)}) {
    EXPECT_EQ(symbol_of(bytes), "disconnected");
  }
  EXPECT_EQ(symbol_of(uncompressed(1, "W200000 H200000")), "disconnected");
  EXPECT_EQ(symbol_of(uncompressed(1, "W30000 H30000")), "disconnected");
  FilmSource nowhere("/nowhere/film.mp4", 0);
  EXPECT_EQ(nowhere.open().error().sentence, "/nowhere/film.mp4 cannot be opened");
}

}  // namespace
}  // namespace pizarra::camera
