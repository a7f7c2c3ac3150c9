#pragma once

// A film as a camera, at its own rate.
//
//   FilmSource film("left.mp4", 0);
//   if (film.open() && film.grab()) show(*film.retrieve(true));

#include "drivers/camera/film_reader.hpp"
#include "drivers/camera/frame_source.hpp"

namespace pizarra::camera {

class FilmSource : public FrameSource {
 public:
  // `rate_hz`: in place of the film's own; 0: none.
  FilmSource(std::string path, double rate_hz) : path_(std::move(path)), rate_hz_(rate_hz) {}

  Result<void> open() override;
  void close() override { film_.reset(); }
  Result<std::optional<double>> grab() override;
  Result<cv::Mat> retrieve(bool grey) override;
  double recorded_hz() const override { return recorded_hz_; }

 private:
  std::string path_;
  double rate_hz_;
  double recorded_hz_ = 0;
  std::unique_ptr<FilmReader> film_;  // while it is open
  bool taken_any_ = false;
};

}  // namespace pizarra::camera
