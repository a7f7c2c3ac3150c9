#pragma once

// How far away a mark is, from the middle of the base line, and how far that may be off.
//
//   std::optional<SeenRange> range = range_of(sight, object, pair, confidence_in_look(sight, object, pair));
//   range->mm, range->spread_mm
//
// A pair's range is f b / d, so that it is off by the same part as f, b and d are (JCGM 100:2008, 5.1.2; L. Matthies,
// S. Shafer, Error modeling in stereo navigation, IEEE Journal of Robotics and Automation 3(3), 1987). Where both
// images register the mark's plane, its edges say the range once more. Both hardly err together (a correlation of 0.1
// to 0.4, measured), so that their mean by inverse variances is told. Errors that both images share, as by the light's
// slope, cancel in d. The others are independent:
// - noise, by which each centre moves: centre_noise_px();
// - where edges fall between pixels, and what blur makes of that: disparity_by_phase_px(), measured;
// - how the face is tilted: its nearer side looks larger, which is taken out; by how much is not exactly known;
// - what the camera says of its calibration: StereoDeviations;
// - what covers a part, where it is not clearly whole: other strips of it from either camera. A strip of width w takes
//   w / sqrt(12) off the standard deviation of a square's width, and moves its centre by w / 2. So the two centres are
//   off by sqrt(3) times the difference of the widths. (A face that is turned looks the same.)
// Motion between the moments of the two images is not in it.

#include <optional>

#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra::vision {

struct SeenRange {
  double mm = 0;
  double spread_mm = 0;  // a standard deviation
};

// `confidence_in_whole`: that nothing covers a part of it. `lies`: how its plane lies by both images, where that is
// known; then its range counts too, alone where no regions show the mark. Only of a pair whose right image shows it.
SeenRange range_by_pair(const StereoSight& sight, const SeenPair& pair, double confidence_in_whole,
                        const PlanePose* lies);

// The range of a mark that the left image alone shows (StereoSight::is_cut_off), by how large it looks and how large it
// was learned: good to about a percent, some ten times worse than the pair. Nothing where no sample was learned with
// its size. `lies`: how its plane lies, where that is known.
std::optional<SeenRange> range_by_size(const camera::StereoModel& model, const LearnedObject& object,
                                       const SeenMark& left, const PlanePose* lies);

// By the pair, or by its size where the right image does not show it. `confidence`: what of the likeness's is left.
std::optional<SeenRange> range_of(const StereoSight& sight, const LearnedObject& object, const SeenPair& pair,
                                  double confidence);

}  // namespace pizarra::vision
