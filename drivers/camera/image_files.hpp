#pragma once

// An image sequence: the image files of a folder, or those that a pattern fits, in the order of their names; of one
// side of a pair those that have a partner on the other (image_pairs.hpp).
//
//   ImageFiles shots("shots", {.rate_hz = 10});                       // shots/*.png, .jpg, ...
//   ImageFiles left("calib/left*.jpg", {.rate_hz = 10, .grey = true});

#include <array>
#include <vector>

#include "drivers/camera/frame_source.hpp"
#include "drivers/camera/image_file.hpp"

namespace pizarra::camera {

class ImageFiles : public FrameSource {
 public:
  struct Reading {
    double rate_hz = 0;  // 0: 10 a second
    bool grey = false;
    ImageSize most = largest_image;
  };

  ImageFiles(std::string where, Reading reading) : where_(std::move(where)), reading_(reading) {}
  // One side of a pair: where the left camera's files are, and the right one's; `side` 0 is the left.
  ImageFiles(std::array<std::string, 2> wheres, std::size_t side, Reading reading)
      : where_(wheres[side]), reading_(reading), side_(side), partner_(wheres[1 - side]) {}

  Result<void> open() override;
  void close() override { files_.clear(); }
  Result<std::optional<double>> grab() override;
  Result<cv::Mat> retrieve(bool grey) override;
  double recorded_hz() const override { return reading_.rate_hz > 0 ? reading_.rate_hz : usual_rate_hz; }
  std::size_t left_out() const override { return left_out_; }

 private:
  static constexpr double usual_rate_hz = 10;

  // Leaves the files that have a partner.
  Result<void> keep_paired();

  std::string where_;
  Reading reading_;
  std::size_t side_ = 0;
  std::string partner_;  // where the other side's files are; empty: there is no other side
  std::vector<std::string> files_;
  std::size_t left_out_ = 0;
  std::size_t taken_ = 0;
};

// The files that ImageFiles reads, sorted; bounded.
std::vector<std::string> image_files_at(const std::string& where);
// Where there are none: why.
std::string no_images_at(const std::string& where);

}  // namespace pizarra::camera
