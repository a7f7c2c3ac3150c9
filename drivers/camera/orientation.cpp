#include "drivers/camera/orientation.hpp"

#include "drivers/camera/header_numbers.hpp"

namespace pizarra::camera {

int orientation_in(std::span<const unsigned char> exif) {
  constexpr std::uint32_t tag = 0x112;
  const std::uint32_t said = is_tiff(exif) ? tiff_number(exif, tag) : 0;
  return said >= 1 && said <= 8 ? static_cast<int>(said) : 1;
}

// 2 to 4 are mirrored, turned by half and both; 5 to 8 lie on a side, and are mirrored, and so on.
void turn_upright(cv::Mat& image, int orientation) {
  constexpr int upside_down = 0;
  constexpr int left_to_right = 1;
  constexpr int both = -1;
  const bool lies = orientation >= 5;
  if (lies) cv::transpose(image, image);
  switch (orientation) {
    case 2:
    case 6:
      return cv::flip(image, image, left_to_right);
    case 3:
    case 7:
      return cv::flip(image, image, both);
    case 4:
    case 8:
      return cv::flip(image, image, upside_down);
    default:
      return;
  }
}

}  // namespace pizarra::camera
