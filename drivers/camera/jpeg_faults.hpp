#pragma once

// What libjpeg thinks of a JPEG. OpenCV decodes by it too, but takes what it warns of for good, and leaves the warnings
// on standard error.
//
//   const std::optional<ImageSize> size = size_of_jpeg(bytes);
//   switch (fault_of_jpeg(bytes)) ...

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/camera/image_size.hpp"

namespace pizarra {

enum class JpegFault : std::uint8_t { none, cut_short, damaged, too_many_scans };

// Each goes over the whole image, and of a progressive JPEG's thousands a few hundred bytes each may tell nothing. What
// encoders make has about ten.
inline constexpr int most_scans = 32;

// All of its data is gone through, up to its first fault. What damage leaves valid codes is none.
JpegFault fault_of_jpeg(std::span<const unsigned char> bytes);

// By its header; nothing where that cannot be read.
std::optional<ImageSize> size_of_jpeg(std::span<const unsigned char> bytes);

}  // namespace pizarra
