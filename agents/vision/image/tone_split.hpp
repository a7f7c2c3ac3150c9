#pragma once

// An image divided into what is dark and what is light around each pixel. The threshold is local, halfway between the
// darkest and the lightest in the tiles nearby, so that a light gradient does not matter; where nothing but noise is
// nearby, a pixel is neither.
//
//   ToneSplit split = split_tones(cut.pixels, cut.noise);
//   regions_of(split.dark) ...

#include <opencv2/core.hpp>
#include <optional>

#include "agents/vision/image/bit_rows.hpp"

namespace pizarra::vision {

struct ToneSplit {
  BitImage dark;
  BitImage light;
};

// `noise`: what there is in the image, as a standard deviation. In `area`, or a little around it, alone; elsewhere
// everything is neither.
ToneSplit split_tones(const cv::Mat1b& image, double noise, std::optional<cv::Rect> area = {});

}  // namespace pizarra::vision
