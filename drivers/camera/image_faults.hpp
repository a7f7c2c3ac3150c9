#pragma once

// The faults of an image file, in the words that follow its name, and the largest size of an image.
//
//   if (is_too_large(size, most)) return image_fault(larger_than(most));    // "corrupt-frame", "is larger than ..."

#include <cstdint>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra::camera {

struct ImageSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  bool operator==(const ImageSize&) const = default;
};

// What the eyes work with; and two of those side by side. A few hundred kilobytes may hold gigabytes, so that what is
// larger is refused by its header.
inline constexpr ImageSize largest_image{8192, 8192};
inline constexpr ImageSize largest_pair{16384, 8192};
// The least that the eyes find a mark in.
inline constexpr int least_side_px = 64;
inline constexpr std::string_view cut_short = "is cut short: its end is missing";
inline constexpr std::string_view no_image = "is no image that can be read";

inline constexpr std::string_view formats_read = "JPEG, PNG, BMP, PGM, PPM, TIFF and WebP are read";
inline constexpr std::string_view is_gif = "is a GIF: JPEG, PNG, BMP, PGM, PPM, TIFF and WebP are read";

constexpr bool is_too_large(ImageSize size, ImageSize most) {
  return size.width > most.width || size.height > most.height;
}
constexpr std::string_view larger_than(ImageSize most) {
  return most == largest_pair ? "is larger than 16384x8192 px" : "is larger than 8192x8192 px";
}

inline std::unexpected<Failure> image_fault(std::string_view sentence) {
  return fail("corrupt-frame", std::string(sentence));
}

}  // namespace pizarra::camera
