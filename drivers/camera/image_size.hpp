#pragma once

// How large an image file's image is, by its first bytes: a few hundred kilobytes may hold gigabytes, which OpenCV
// makes room for before it knows better.
//
//   const std::optional<ImageSize> size = size_of_image(bytes);     // of a PNG, BMP, PGM, PPM, TIFF or WebP

#include <cstdint>
#include <optional>
#include <span>

namespace pizarra {

struct ImageSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  bool operator==(const ImageSize&) const = default;
};

// Nothing where the bytes are none of those, or end before they say.
std::optional<ImageSize> size_of_image(std::span<const unsigned char> bytes);

}  // namespace pizarra
