// Image files and videos, as a person has them, read as a camera.

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <set>
#include <sys/stat.h>

#include "blackboard/time/real_executor.hpp"
#include "drivers/camera/frame_source.hpp"
#include "drivers/camera/image_files.hpp"
#include "drivers/camera/image_pairs.hpp"
#include "drivers/camera/video_camera.hpp"
#include "lisp/writer.hpp"
#include "tests/run_task.hpp"
#include "tests/scratch.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::camera {
namespace {

using Arrangement = forms::CameraSetup::Arrangement;

// A folder of its own, gone with the test.
class Recordings : public testing::Test {
 protected:
  Recordings() : folder(scratch_folder() + testing::UnitTest::GetInstance()->current_test_info()->name() + "/") {
    std::filesystem::create_directories(folder);
  }
  ~Recordings() override { std::filesystem::remove_all(folder); }

  void write_image(const std::string& name, int level, cv::Size size = {320, 240}) const {
    ASSERT_TRUE(cv::imwrite(folder + name, cv::Mat(size, CV_8UC3, cv::Scalar::all(level))));
  }
  void write_video(const std::string& name, cv::Size size, double hz, int frames) const {
    cv::VideoWriter film(folder + name, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), hz, size);
    ASSERT_TRUE(film.isOpened());
    for (int i = 0; i < frames; ++i) film.write(cv::Mat(size, CV_8UC3, cv::Scalar::all(40 + i % 150)));
  }
  forms::CameraSetup setup(Arrangement arrangement, forms::CameraSource::Kind kind,
                           std::vector<std::string> names) const {
    forms::CameraSetup out{.arrangement = arrangement};
    for (const std::string& name : names) out.sources.push_back({kind, folder + name});
    if (arrangement != Arrangement::single) {
      out.focal_px = 400;
      out.base_line_mm = 60;
    }
    return out;
  }
  Result<StereoFrame> next(VideoCamera& camera, Time after = {}) { return run(executor, camera.next(after, false)); }

  const std::string folder;
  RealExecutor executor;
};

TEST_F(Recordings, AFolderAndAPatternGiveTheirImagesInTheOrderOfTheirNames) {
  write_image("b.png", 20);
  write_image("a.jpg", 10);
  write_image("c.PNG", 30);
  std::ofstream(folder + "notes.txt") << "no image";
  ImageFiles all(folder, {.grey = true});
  ASSERT_TRUE(all.open());
  for (const int level : {10, 20, 30}) {
    ASSERT_TRUE(all.grab());
    EXPECT_EQ(all.retrieve(false)->data[0], level);
  }
  EXPECT_EQ(all.grab().error().symbol, "ended");
  ImageFiles some(folder + "[ab].*", {.grey = true});
  ASSERT_TRUE(some.open());
  EXPECT_EQ(image_files_at(folder + "[ab].*").size(), 2u);
}

TEST_F(Recordings, NoImagesAtAllIsNoCamera) {
  EXPECT_EQ(ImageFiles(folder, {}).open().error().sentence, "there are no images at " + folder);
  EXPECT_EQ(ImageFiles("/nowhere/*.png", {}).open().error().symbol, "disconnected");
}

TEST_F(Recordings, AnImageThatIsNoneIsToldByItsNameAndTheOthersAreSeen) {
  write_image("1.png", 50);
  std::ofstream(folder + "2.png") << "this is no picture";
  write_image("3.png", 60);
  std::ofstream(folder + "4.png") << "";
  forms::CameraSetup eyes = setup(Arrangement::single, forms::CameraSource::Kind::images, {"*.png"});
  eyes.rate_hz = 100;
  VideoCamera camera(executor, eyes);
  ASSERT_TRUE(run(executor, camera.open()));
  std::set<std::string> said;
  std::set<int> seen;
  Time last = {};
  for (int i = 0; i < 200 && (said.size() < 2 || seen.size() < 2); ++i) {
    const Result<StereoFrame> frame = next(camera, last);
    ASSERT_TRUE(frame);
    seen.insert(frame->left->pixels[0]);
    const std::string why = camera.drops().why_corrupt;
    if (!why.empty()) said.insert(why);
    last = frame->captured;
  }
  EXPECT_EQ(seen, (std::set<int>{50, 60}));
  EXPECT_EQ(said, (std::set<std::string>{"the camera: " + folder + "2.png is no image that can be read",
                                         "the camera: " + folder + "4.png is no image that can be read"}));
}

// A name is whatever bytes a file system takes.
TEST_F(Recordings, AnImageWhoseNameIsNoTextIsToldByWhatCanBeShownOfIt) {
  const std::string shown = folder + "f\\xfcr\\x1b[31m.png is no image that can be read";
  std::ofstream(folder + "f\xFCr\x1b[31m.png") << "this is no picture";
  write_image("good.png", 50);
  forms::CameraSetup eyes = setup(Arrangement::single, forms::CameraSource::Kind::images, {""});
  eyes.rate_hz = 100;
  VideoCamera camera(executor, eyes);
  ASSERT_TRUE(run(executor, camera.open()));
  const Result<StereoFrame> frame = next(camera);
  ASSERT_TRUE(frame);
  while (camera.drops().corrupt == 0) ASSERT_TRUE(next(camera, frame->captured));
  EXPECT_EQ(camera.drops().why_corrupt, "the camera: " + shown);
  EXPECT_EQ(write(list("camera-state"_sym, camera.drops().why_corrupt)).find('\x1b'), std::string::npos);
}

TEST_F(Recordings, ACameraOfSuchImagesAloneSaysSoAcrossTheBoard) {
  std::ofstream(folder + "f\xFCr.png") << "this is no picture";
  forms::CameraSetup eyes = setup(Arrangement::single, forms::CameraSource::Kind::images, {"f\xFCr.png"});
  eyes.rate_hz = 1000;
  VideoCamera camera(executor, eyes);
  const Result<StereoModel> opened = run(executor, camera.open());
  ASSERT_FALSE(opened);
  const Failure told = failure_from_datum(failure_to_datum(opened.error()));
  EXPECT_EQ(told.sentence, "the camera: " + folder + "f\\xfcr.png is no image that can be read");
}

TEST_F(Recordings, AFolderOfGifsIsToldWhatIsRead) {
  std::ofstream(folder + "a.gif") << "GIF89a";
  EXPECT_EQ(ImageFiles(folder, {}).open().error().sentence,
            "there are no images at " + folder +
                ": JPEG, PNG, BMP, PGM, PPM, TIFF and WebP are read, by the ends of "
                "their names, and a.gif is none of these");
  ImageFiles named(folder + "*.gif", {});
  ASSERT_TRUE(named.open());
  ASSERT_TRUE(named.grab());
  EXPECT_EQ(named.retrieve(true).error().sentence,
            folder + "a.gif is a GIF: JPEG, PNG, BMP, PGM, PPM, TIFF and WebP are read");
}

// Nothing but its header is there: whoever decoded it would say that it is cut short.
TEST_F(Recordings, APngThatIsTooLargeForTheEyesIsRefusedByItsHeader) {
  const std::string header("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x3e\x80\0\0\x1f\x40\x08\0\0\0\0", 29);
  std::ofstream(folder + "a.png", std::ios::binary) << header;
  const auto told_of = [&](Arrangement arrangement) {
    const forms::CameraSetup eyes = setup(arrangement, forms::CameraSource::Kind::images, {"a.png"});
    const std::unique_ptr<FrameSource> source = std::move(sources_of(eyes)[0]);
    EXPECT_TRUE(source->open());
    EXPECT_TRUE(source->grab());
    return source->retrieve(true).error().sentence;
  };
  EXPECT_EQ(told_of(Arrangement::single), folder + "a.png is larger than 8192x8192 px");
  EXPECT_EQ(told_of(Arrangement::side_by_side), folder + "a.png is cut short: its end is missing");
}

// What is decoded of it would be half grey.
TEST_F(Recordings, AnImageThatIsCutShortIsNone) {
  cv::Mat noise(480, 640, CV_8UC3);
  cv::randu(noise, 0, 255);
  for (const std::string name : {"a.jpg", "b.png"}) {
    ASSERT_TRUE(cv::imwrite(folder + name, noise));
    const std::uintmax_t whole = std::filesystem::file_size(folder + name);
    for (const std::uintmax_t size : {whole - 1, 2 * whole / 3, std::uintmax_t{3000}, std::uintmax_t{300}}) {
      SCOPED_TRACE(name + " of " + std::to_string(size));
      ImageFiles images(folder + name, {});
      ASSERT_TRUE(images.open());
      ASSERT_TRUE(images.grab());
      EXPECT_TRUE(images.retrieve(false));
      std::filesystem::copy_file(folder + name, folder + "kept");
      std::filesystem::resize_file(folder + name, size);
      const Result<cv::Mat> cut = images.retrieve(false);
      std::filesystem::rename(folder + "kept", folder + name);
      ASSERT_FALSE(cut);
      EXPECT_EQ(cut.error().sentence, folder + name + " is cut short: its end is missing");
    }
  }
}

// By one byte anywhere. libpng would say something of its own.
TEST_F(Recordings, APngThatIsDamagedIsNoneAndToldOnce) {
  cv::Mat noise(24, 32, CV_8UC1);
  cv::randu(noise, 0, 255);
  ASSERT_TRUE(cv::imwrite(folder + "a.png", noise));
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(folder + "a.png"));
  ImageFiles images(folder + "a.png", {});
  ASSERT_TRUE(images.open());
  ASSERT_TRUE(images.grab());
  ASSERT_TRUE(images.retrieve(false));
  testing::internal::CaptureStderr();
  for (std::streamoff at = 0; at < size; ++at) {
    std::fstream file(folder + "a.png", std::ios::in | std::ios::out | std::ios::binary);
    const auto flip = [&] {
      file.seekg(at);
      const int byte = file.get();
      file.seekp(at);
      file.put(static_cast<char>(byte ^ 0x10)).flush();
    };
    flip();
    const Result<cv::Mat> damaged = images.retrieve(false);
    EXPECT_FALSE(damaged) << "byte " << at;
    flip();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(images.retrieve(false));
}

TEST_F(Recordings, APipeAmongTheImagesIsToldAndNotWaitedFor) {
  ASSERT_EQ(mkfifo((folder + "a.png").c_str(), 0600), 0);
  ImageFiles images(folder, {});
  ASSERT_TRUE(images.open());
  ASSERT_TRUE(images.grab());
  EXPECT_EQ(images.retrieve(false).error().sentence, folder + "a.png is no regular file");
}

TEST_F(Recordings, APairOfImageSequencesIsSeenInStep) {
  for (int i = 0; i < 3; ++i) {
    write_image("left" + std::to_string(i) + ".png", 10 * i);
    write_image("right" + std::to_string(i) + ".png", 10 * i + 100);
  }
  forms::CameraSetup eyes = setup(Arrangement::pair, forms::CameraSource::Kind::images, {"left*.png", "right*.png"});
  eyes.rate_hz = 100;
  VideoCamera camera(executor, eyes);
  const Result<StereoModel> model = run(executor, camera.open());
  ASSERT_TRUE(model);
  EXPECT_EQ(model->base_line_mm, 60);
  Time last = {};
  for (int i = 0; i < 10; ++i) {
    const Result<StereoFrame> frame = next(camera, last);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->left->pixels[0] + 100, frame->right->pixels[0]);
    last = frame->captured;
  }
}

TEST_F(Recordings, APairGoesByTheNumbersInItsNamesAndCountsWhatHasNoPartner) {
  for (int i = 0; i < 12; ++i) {
    write_image("left" + std::to_string(i) + ".png", 10 * i);
    if (i != 3 && i != 11) write_image("right" + std::to_string(i) + ".png", 10 * i + 100);
  }
  forms::CameraSetup eyes = setup(Arrangement::pair, forms::CameraSource::Kind::images, {"left*.png", "right*.png"});
  eyes.rate_hz = 100;
  VideoCamera camera(executor, eyes);
  ASSERT_TRUE(run(executor, camera.open()));
  StereoFrame last;
  while (last.number < 10) {
    const Result<StereoFrame> frame = next(camera, last.captured);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->left->pixels[0] + 100, frame->right->pixels[0]);
    last = *frame;
  }
  EXPECT_GE(camera.drops().skewed, 2u);
}

TEST_F(Recordings, APairWhoseNamesDoNotSayWhatBelongsTogetherHasAsManyOnEitherSide) {
  for (const char* name : {"left-a.png", "left-b.png", "left-c.png", "right-a.png", "right-b.png"}) {
    write_image(name, 50);
  }
  const forms::CameraSetup eyes =
      setup(Arrangement::pair, forms::CameraSource::Kind::images, {"left*.png", "right*.png"});
  {
    VideoCamera camera(executor, eyes);
    const Result<StereoModel> model = run(executor, camera.open());
    ASSERT_FALSE(model);
    EXPECT_EQ(
        model.error().sentence,
        "the left camera: 3 images are of the left camera and 2 of the right one, and no numbers in their names say "
        "which belong together: give what belongs together the same number");
  }
  write_image("right-c.png", 50);
  VideoCamera camera(executor, eyes);
  EXPECT_TRUE(run(executor, camera.open()));
}

TEST(ImagePairs, NumbersThatContradictTheOrderAreNotOverridden) {
  const std::vector<std::string> right = {"r/3.png", "r/4.png", "r/5.png", "r/6.png"};
  EXPECT_EQ(pair_files({"l/1.png", "l/2.png", "l/3.png", "l/4.png"}, right).error().symbol, "unpaired");
  EXPECT_EQ(pair_files({"l/a3 (3).png", "l/a3.png", "l/a4.png", "l/a5.png"}, right).error().symbol, "unpaired");
  EXPECT_EQ(pair_files({"l/a3.png", "l/a4.png", "l/a5.png", "l/x.png"}, right).error().symbol, "unpaired");
}

TEST(ImagePairs, WhatHasTheSameNameBelongsTogetherWhateverItsNumbers) {
  const std::vector<std::string> burst = {"IMG_20240101_120000", "IMG_20240101_120000_1"};
  EXPECT_EQ(pair_files({"l/" + burst[0] + ".jpg", "l/" + burst[1] + ".jpg"},
                       {"r/" + burst[0] + ".jpg", "r/" + burst[1] + ".jpg"})
                .value()
                .sides[1],
            (std::vector<std::string>{"r/" + burst[0] + ".jpg", "r/" + burst[1] + ".jpg"}));
  const ImagePairs letters = pair_files({"l/a.png", "l/b.png", "l/c.png"}, {"r/b.png", "r/c.png"}).value();
  EXPECT_EQ(letters.sides[0], (std::vector<std::string>{"l/b.png", "l/c.png"}));
  EXPECT_EQ(letters.alone, (std::array<std::size_t, 2>{1, 0}));
}

TEST(ImagePairs, NumbersTooLargeToCountWithSayNothing) {
  const std::vector<std::string> left = {"l/1.png", "l/9223372036854775807.png"};
  EXPECT_EQ(pair_files(left, {"r/3.png", "r/5000000000000000000.png"}).error().symbol, "unpaired");
}

TEST(ImagePairs, ACamerasOwnNumberSaysNothing) {
  std::vector<std::string> left;
  std::vector<std::string> right;
  for (int i = 0; i < 20; ++i) {
    if (i != 3) left.push_back(fmt::format("l/frame{:02}_cam0.png", i));
    if (i != 16) right.push_back(fmt::format("r/frame{:02}_cam1.png", i));
  }
  const ImagePairs pairs = pair_files(left, right).value();
  ASSERT_EQ(pairs.sides[0].size(), 18u);
  EXPECT_EQ(pairs.alone, (std::array<std::size_t, 2>{1, 1}));
  for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(pairs.sides[0][i].substr(2, 7), pairs.sides[1][i].substr(2, 7));
  const ImagePairs one = pair_files({"l/frame07_cam0.png"}, right).value();
  EXPECT_EQ(one.sides[1], (std::vector<std::string>{"r/frame07_cam1.png"}));
}

TEST(ImagePairs, DatesAndTimesAreComparedWhole) {
  const ImagePairs times =
      pair_files({"l_10.0.png", "l_10.5.png", "l_11.0.png"}, {"r_10.5.png", "r_11.0.png", "r_11.5.png"}).value();
  EXPECT_EQ(times.sides[0], (std::vector<std::string>{"l_10.5.png", "l_11.0.png"}));
  EXPECT_EQ(times.sides[1], (std::vector<std::string>{"r_10.5.png", "r_11.0.png"}));
  const ImagePairs dates = pair_files({"0522_235959.png", "0523_000000.png"}, {"0523_000000.png"}).value();
  EXPECT_EQ(dates.sides[0], (std::vector<std::string>{"0523_000000.png"}));
}

TEST(ImagePairs, WhatIsRefusedNamesAnImageAndSaysWhatToRename) {
  const auto why = [](std::vector<std::string> left, std::vector<std::string> right) {
    return pair_files(std::move(left), std::move(right)).error().sentence;
  };
  EXPECT_EQ(why({"l/100.png", "l/200.png", "l/300.png"}, {"r/102.png", "r/201.png", "r/303.png"}),
            "3 images are of the left camera and 3 of the right one, and the numbers in their names do not say which "
            "belong together, as of 100.png: give what belongs together the same number, or take out the numbers");
  EXPECT_EQ(why({"l/3 (3).png", "l/4.png"}, {"r/3.png", "r/4.png"}),
            "3 (3).png has 2 numbers in its name and 4.png has 1: give what belongs together the same number, or take "
            "out the numbers");
  EXPECT_EQ(why({"l/a3.png", "l/b3.png", "l/c4.png"}, {"r/3.png", "r/4.png", "r/5.png"}),
            "a3.png and b3.png have the same number: give what belongs together the same number, or take out the "
            "numbers");
}

TEST(ImagePairs, NumbersThatAreNotOnBothSidesSayNothing) {
  const ImagePairs apart = pair_files({"l/1.png", "l/2.png"}, {"r/101.png", "r/102.png"}).value();
  EXPECT_EQ(apart.sides[1], (std::vector<std::string>{"r/101.png", "r/102.png"}));
  const ImagePairs unpadded = pair_files({"10.png", "8.png", "9.png"}, {"100.png", "101.png", "99.png"}).value();
  EXPECT_EQ(unpadded.sides[1], (std::vector<std::string>{"101.png", "99.png", "100.png"}));
  const ImagePairs cameras = pair_files({"a-1.png", "b-1.png"}, {"a-2.png", "b-2.png"}).value();
  EXPECT_EQ(cameras.sides[1], (std::vector<std::string>{"a-2.png", "b-2.png"}));
  const ImagePairs stray = pair_files({"l/1.png", "l/02.png", "l/3.png"}, {"r/2.png", "r/3.png", "r/4.png"}).value();
  EXPECT_EQ(stray.sides[0], (std::vector<std::string>{"l/02.png", "l/3.png"}));
  EXPECT_EQ(stray.sides[1], (std::vector<std::string>{"r/2.png", "r/3.png"}));
  EXPECT_EQ(stray.alone[0] + stray.alone[1], 2u);
  EXPECT_EQ(pair_files({"l/1.png", "l/2.png", "l/3.png"}, {"r/8.png", "r/9.png"}).error().symbol, "unpaired");
}

// A frame that this machine shows late is late alone: the median says at which rate the others follow.
TEST_F(Recordings, AVideoIsShownAtItsOwnRateAndBeginsAnew) {
  write_video("film.avi", {320, 240}, 50, 10);
  VideoCamera camera(executor, setup(Arrangement::single, forms::CameraSource::Kind::video, {"film.avi"}));
  ASSERT_TRUE(run(executor, camera.open()));
  const StereoFrame first = *next(camera);
  StereoFrame last = first;
  std::vector<double> periods_s;
  while (last.number < first.number + 25) {
    const StereoFrame frame = *next(camera, last.captured);
    const double apart_s = std::chrono::duration<double>(frame.captured - last.captured).count();
    periods_s.push_back(apart_s / static_cast<double>(frame.number - last.number));
    last = frame;
  }
  const double all_s = std::chrono::duration<double>(last.captured - first.captured).count();
  EXPECT_GT(all_s, 0.45) << "25 frames at 50 a second, two and a half times the film";
  std::ranges::nth_element(periods_s, periods_s.begin() + static_cast<std::ptrdiff_t>(periods_s.size() / 2));
  EXPECT_NEAR(periods_s[periods_s.size() / 2], 0.02, 0.005);
}

// A telephone that is held upright films aslant, and notes in the film how it must be turned.
TEST_F(Recordings, AFilmIsShownUpright) {
  cv::Mat picture(240, 320, CV_8UC3, cv::Scalar::all(40));
  picture(cv::Rect(0, 0, 160, 240)) = cv::Scalar::all(200);
  {
    cv::VideoWriter film(folder + "film.mp4", cv::VideoWriter::fourcc('m', 'p', '4', 'v'), 25, picture.size());
    for (int i = 0; i < 3; ++i) film.write(picture);
  }
  std::string bytes = whole_file(folder + "film.mp4");
  const std::size_t header = bytes.find("tkhd");
  ASSERT_NE(header, std::string::npos);
  // 16 bits before the point, or 2: a quarter of a turn clockwise.
  constexpr std::size_t behind_name = 4 + 40;
  bytes.replace(header + behind_name, 36,
                std::string("\0\0\0\0\0\1\0\0\0\0\0\0\xff\xff\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x40\0\0\0", 36));
  std::ofstream(folder + "film.mp4", std::ios::binary) << bytes;
  VideoCamera camera(executor, setup(Arrangement::single, forms::CameraSource::Kind::video, {"film.mp4"}));
  ASSERT_TRUE(run(executor, camera.open()));
  const Result<StereoFrame> frame = next(camera);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->left->width, 240);
  EXPECT_EQ(frame->left->height, 320);
  EXPECT_NEAR(frame->left->pixels[20 * 240 + 120], 200, 4) << "what was on the left is above";
  EXPECT_NEAR(frame->left->pixels[300 * 240 + 120], 40, 4);
}

TEST_F(Recordings, WhatIsNoVideoIsNoCamera) {
  std::ofstream(folder + "film.avi") << "this is no film";
  VideoCamera camera(executor, setup(Arrangement::single, forms::CameraSource::Kind::video, {"film.avi"}));
  const Result<StereoModel> model = run(executor, camera.open());
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().sentence, "the camera: " + folder + "film.avi cannot be opened");
}

TEST_F(Recordings, APairSideBySideOf1280x960At120AsecondKeepsUp) {
  write_video("film.avi", {2560, 960}, 120, 12);
  forms::CameraSetup eyes = setup(Arrangement::side_by_side, forms::CameraSource::Kind::video, {"film.avi"});
  eyes.width = 1280;
  eyes.height = 960;
  VideoCamera camera(executor, eyes);
  ASSERT_TRUE(run(executor, camera.open()));
  const std::clock_t cpu_before = std::clock();
  const std::uint64_t first = next(camera)->number;
  StereoFrame last;
  for (int i = 0; i < 60; ++i) {
    const Result<StereoFrame> frame = next(camera, last.captured);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->left->width, 1280);
    last = *frame;
  }
  const double cpu_ms = 1000.0 * static_cast<double>(std::clock() - cpu_before) / CLOCKS_PER_SEC;
  const double cpu_ms_a_frame = cpu_ms / static_cast<double>(last.number - first);
  RecordProperty("cpu_us_a_frame", static_cast<int>(1000 * cpu_ms_a_frame));
  std::printf("%.2f ms of a processor a pair of 1280 x 960\n", cpu_ms_a_frame);
  EXPECT_LT(cpu_ms_a_frame, 25);
}

// The plugins of GStreamer are packages of their own.
bool has_gstreamer_plugin(const std::string& name) {
  for (const auto& architecture : std::filesystem::directory_iterator("/usr/lib")) {
    if (std::filesystem::exists(architecture.path() / "gstreamer-1.0" / ("libgst" + name + ".so"))) return true;
  }
  return false;
}

TEST_F(Recordings, APipelineIsACameraWhateverItsColoursAre) {
  if (!has_gstreamer_plugin("videotestsrc")) GTEST_SKIP() << "gstreamer1.0-plugins-base is not installed";
  for (const std::string format : {"format=BGR,", "format=GRAY8,", ""}) {
    const std::string pipeline =
        "videotestsrc is-live=true ! video/x-raw," + format + "width=640,height=480,framerate=30/1 ! appsink";
    VideoCamera camera(
        executor, {.arrangement = Arrangement::single, .sources = {{forms::CameraSource::Kind::pipeline, pipeline}}});
    const Result<StereoModel> model = run(executor, camera.open());
    ASSERT_TRUE(model.has_value()) << format << describe(model.error());
    EXPECT_EQ(model->width, 640) << format;
    const Result<StereoFrame> frame = next(camera);
    ASSERT_TRUE(frame.has_value()) << format << describe(frame.error());
    EXPECT_EQ(frame->left->channels, 1) << format;
  }
}

}  // namespace
}  // namespace pizarra::camera
