#pragma once

// The cameras of a cell that are not simulated, as its cell file says it:
//
//   (camera (pair (device 0) (device 2)) (size 640 480) (rate 30) (exposure 8) (tones grey) (skew 10)
//           (calibration "pair.calibration"))
//   (camera (side-by-side (video "film.avi")) (focal 520) (base-line 60))    ; rectified already
//   (camera (single (images "shots/*.jpg")) (rate 10) (learned-at 600))      ; one camera alone
//   (camera (plugin "libmycamera.so"))                                       ; drivers/plugin/camera_plugin.hpp
//
// A source is a (device N) or (device "/dev/video0"), a (video "FILE"), an image sequence (images "FOLDER") or
// (images "PATTERN"), a (stream "URL"), or a (pipeline "ELEMENT ! ... ! appsink") of GStreamer. drivers/camera/ reads
// it.

#include <cstdint>
#include <string>
#include <vector>

namespace pizarra::forms {

struct CameraSource {
  enum class Kind : std::uint8_t { device, video, images, stream, pipeline };
  Kind kind = Kind::device;
  std::string where;
  bool operator==(const CameraSource&) const = default;
};

struct CameraSetup {
  enum class Arrangement : std::uint8_t { simulated, single, side_by_side, pair, plugin };
  Arrangement arrangement = Arrangement::simulated;
  std::vector<CameraSource> sources = {};  // two for a pair, the left one first; none of a plug-in; one otherwise
  std::string plugin = {};                 // the plug-in's file; what stands below it says by itself
  // Of one image; 0: as it comes. One that comes otherwise is an error.
  int width = 0;
  int height = 0;
  double rate_hz = 0;      // 0: the device's own; of an image sequence 10
  double exposure_ms = 0;  // 0: automatic
  bool grey = false;       // colour is not even taken
  double skew_ms = 0;      // how far the moments of a pair may lie apart; 0: half of the time between two images
  // What its pixels mean: a calibration of the pair, or the numbers of a rectified one. 0: unknown.
  std::string calibration_file = {};
  double focal_px = 0;
  double base_line_mm = 0;
  double learned_at_mm = 0;  // one camera alone: how far away objects are while they are learned

  bool is_simulated() const { return arrangement == Arrangement::simulated; }
  bool is_plugin() const { return arrangement == Arrangement::plugin; }
};

}  // namespace pizarra::forms
