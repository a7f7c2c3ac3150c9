#pragma once

// Films of every format, by FFmpeg. It brings sixty libraries and 26 MB, where OpenCV's reader of films brings two
// hundred and 63 MB. They are loaded at the first call, and programs that call nothing here start without them.
//
//   const Result<std::unique_ptr<FilmReader>> film = new_film_reader();
//   if (!(*film)->open("film.mp4")) ...
//   while (const std::optional<double> moment_ms = (*film)->grab()) show((*film)->picture(false));
//
// The failure is no-module: the file `pizarra-ffmpeg.so` is not beside the program, or cannot be loaded.

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "lisp/result.hpp"

namespace pizarra::camera {

class FilmReader {
 public:
  virtual ~FilmReader() = default;
  // Once. Not a film, or one whose format nothing decodes: false.
  virtual bool open(const std::string& path) = 0;
  // 25 where the film says none that is sane.
  virtual double pictures_per_second() const = 0;
  // Decodes the next picture; when it is to be shown, from the film's beginning. Nothing: the film is over.
  virtual std::optional<double> grab() = 0;
  // The grabbed one, upright: grey or BGR. Empty where it is damaged.
  virtual cv::Mat picture(bool grey) = 0;
};

Result<std::unique_ptr<FilmReader>> new_film_reader();

}  // namespace pizarra::camera
