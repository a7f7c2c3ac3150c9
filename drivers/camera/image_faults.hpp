#pragma once

// What is wrong with an image file, in the words that follow its name, and how large an image may be.
//
//   if (is_too_large(size)) return image_fault(too_large);            // "corrupt-frame", "is larger than ..."

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

inline constexpr std::string_view too_large = "is larger than 16384x8192 px";
inline constexpr std::string_view cut_short = "is cut short: its end is missing";
inline constexpr std::string_view no_image = "is no image that can be read";

// A few hundred kilobytes may hold gigabytes. Two of the largest images that work, side by side, are none.
inline bool is_too_large(ImageSize size) { return size.width > 16384 || size.height > 8192; }

inline std::unexpected<Failure> image_fault(std::string_view sentence) {
  return fail("corrupt-frame", std::string(sentence));
}

}  // namespace pizarra::camera
