#pragma once

// An image sequence: the image files of a folder, or those that a pattern fits, in the order of their names; of one side
// of a pair those that have a partner on the other (image_pairs.hpp).
//
//   ImageFiles shots("shots", 10, false);          // shots/*.png, .jpg, ...
//   ImageFiles left("calib/left*.jpg", 10, true);  // grey

#include <array>
#include <vector>

#include "drivers/camera/frame_source.hpp"

namespace pizarra {

class ImageFiles : public FrameSource {
 public:
  static constexpr double usual_rate_hz = 10;

  ImageFiles(std::string where, double rate_hz, bool grey)
      : where_(std::move(where)), rate_hz_(rate_hz > 0 ? rate_hz : usual_rate_hz), grey_(grey) {}
  // One side of a pair: where the left camera's files are, and the right one's; `side` 0 is the left.
  ImageFiles(std::array<std::string, 2> wheres, std::size_t side, double rate_hz, bool grey)
      : ImageFiles(wheres[side], rate_hz, grey) {
    side_ = side;
    partner_ = wheres[1 - side];
  }

  Result<void> open() override;
  void close() override { files_.clear(); }
  Result<std::optional<double>> grab() override;
  Result<cv::Mat> retrieve() override;
  double recorded_hz() const override { return rate_hz_; }
  std::size_t left_out() const override { return left_out_; }

 private:
  // Leaves the files that have a partner.
  Result<void> keep_paired();

  std::string where_;
  double rate_hz_;
  bool grey_;
  std::size_t side_ = 0;
  std::string partner_;  // where the other side's files are; empty: there is no other side
  std::vector<std::string> files_;
  std::size_t left_out_ = 0;
  std::size_t taken_ = 0;
};

// 8 bit, grey or BGR. Failure corrupt-frame.
Result<cv::Mat> read_image_file(const std::string& file, bool grey);

// The files that ImageFiles reads, sorted; bounded.
std::vector<std::string> image_files_at(const std::string& where);

}  // namespace pizarra
