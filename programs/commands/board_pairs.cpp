#include "programs/commands/board_pairs.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>

#include "drivers/camera/frame_source.hpp"
#include "drivers/camera/image_files.hpp"
#include "drivers/camera/image_pairs.hpp"
#include "drivers/camera/stereo_reader.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::programs {
namespace {

class FilePairs : public BoardPairs {
 public:
  explicit FilePairs(camera::ImagePairs pairs)
      : left_(std::move(pairs.sides[0])),
        right_(std::move(pairs.sides[1])),
        left_out_(pairs.alone[0] + pairs.alone[1]) {}

  Result<ImagePair> next() override {
    if (taken_ == left_.size()) return fail("ended", "there are no more images");
    const std::size_t pair = taken_++;
    Result<cv::Mat> left = camera::read_image_file(left_[pair], true);
    if (!left) return fail(left);
    if (single()) return ImagePair{std::move(*left), {}};
    Result<cv::Mat> right = camera::read_image_file(right_[pair], true);
    if (!right) return fail(right);
    return ImagePair{std::move(*left), std::move(*right)};
  }
  std::string name() const override {
    const auto name_of = [](const std::string& file) { return std::filesystem::path(file).filename().string(); };
    return text_of_bytes(name_of(left_[taken_ - 1]) + (single() ? "" : " " + name_of(right_[taken_ - 1])));
  }
  std::size_t left_out() const override { return left_out_; }
  bool chosen() const override { return true; }
  bool single() const override { return right_.empty(); }

 private:
  std::vector<std::string> left_;
  std::vector<std::string> right_;
  std::size_t left_out_;
  std::size_t taken_ = 0;
};

class CameraPairs : public BoardPairs {
 public:
  explicit CameraPairs(const forms::CameraSetup& eyes)
      : reader_(eyes, camera::sources_of(eyes), real_time),
        single_(eyes.arrangement == forms::CameraSetup::Arrangement::single) {
    reader_.read_once();
  }

  Result<void> open() { return reader_.open(); }
  Result<ImagePair> next() override {
    const Result<void> grabbed = reader_.grab();
    ++taken_;
    if (!grabbed) return fail(grabbed);
    Result<camera::StereoImages> images = reader_.retrieve(true);
    if (!images) return fail(images);
    return ImagePair{std::move(images->left), std::move(images->right)};
  }
  std::string name() const override { return fmt::format("{} {}", single_ ? "image" : "pair", taken_); }
  bool single() const override { return single_; }
  bool chosen() const override { return false; }

 private:
  static Time real_time() {
    return Time(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
  }

  camera::StereoReader reader_;
  const bool single_;
  int taken_ = 0;
};

}  // namespace

Result<std::unique_ptr<BoardPairs>> BoardPairs::of_files(const std::string& left, const std::string& right) {
  std::vector<std::string> left_files = camera::image_files_at(left);
  const bool single = right.empty();
  std::vector<std::string> right_files = single ? std::vector<std::string>() : camera::image_files_at(right);
  for (const auto& [files, where] : {std::pair(&left_files, &left), std::pair(&right_files, &right)}) {
    if (files->empty() && !where->empty()) return fail("no-images", camera::no_images_at(*where));
  }
  Result<camera::ImagePairs> pairs = single ? camera::ImagePairs{{std::move(left_files), {}}, {}}
                                            : camera::pair_files(std::move(left_files), std::move(right_files));
  if (!pairs) return fail(pairs);
  const std::size_t count = pairs->sides[0].size();
  if (count > most) {
    return fail("too-many", fmt::format("there are {} {} at {}, and at most {} make a calibration: choose those that "
                                        "show the board at different places and angles",
                                        count, single ? "images" : "pairs", left, most));
  }
  return std::make_unique<FilePairs>(std::move(*pairs));
}

Result<std::unique_ptr<BoardPairs>> BoardPairs::of_cameras(const forms::CameraSetup& eyes) {
  if (eyes.is_simulated()) {
    return fail("no-camera", "the cell has no real cameras: (camera (single ...)) or (camera (pair ...))");
  }
  if (eyes.is_plugin()) {
    return fail("no-camera", "a camera's plug-in tells its geometry by itself, and is not calibrated here");
  }
  auto pairs = std::make_unique<CameraPairs>(eyes);
  const Result<void> opened = pairs->open();
  if (!opened) return fail(opened);
  return pairs;
}

}  // namespace pizarra::programs
