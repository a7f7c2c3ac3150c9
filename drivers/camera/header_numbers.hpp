#pragma once

// Numbers in the headers of image files.
//
//   number(bytes, 18, 4, std::endian::little);       // the width of a BMP
//   tiff_number(exif, 0x112);                        // how a photograph is to be turned

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

namespace pizarra::camera {

// Of `count` bytes, 4 at most; 0 where the bytes end before.
std::uint32_t number(std::span<const unsigned char> bytes, std::size_t at, std::size_t count, std::endian order);

bool says(std::span<const unsigned char> bytes, std::size_t at, std::string_view text);

bool is_tiff(std::span<const unsigned char> bytes);
// Under this tag of a TIFF's first directory; 0: there is none.
std::uint32_t tiff_number(std::span<const unsigned char> tiff, std::uint32_t tag);

}  // namespace pizarra::camera
