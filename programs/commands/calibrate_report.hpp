#pragma once

// The output of `calibrate` as it goes, as text or JSON, a line each.
//
//   CalibrateReport report(json, single);
//   report.pair("left01.jpg right01.jpg", taken, {});
//   report.result("pair.calibration", found);

#include <string>

#include "drivers/camera/chessboard.hpp"

namespace pizarra::programs {

class CalibrateReport {
 public:
  CalibrateReport(bool json, bool single) : json_(json), single_(single) {}

  // What came of an image or pair; `so_far` is added to what was found.
  void pair(const std::string& name, const Result<void>& taken, const std::string& so_far) const;
  void without_partner(std::size_t images) const;
  void step(const std::string& what) const;
  // `px`: its error, 0 where that is not why.
  void left_out(const std::string& name, double px, const std::string& why) const;
  void result(const std::string& file, const camera::CalibratedPair& found) const;

 private:
  void pair_result(const std::string& file, const camera::CalibratedPair& found) const;
  void lens_result(const std::string& file, const camera::CalibratedPair& found) const;

  bool json_;
  bool single_;
};

}  // namespace pizarra::programs
