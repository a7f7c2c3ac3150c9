#include "drivers/camera/image_faults.hpp"

#include <algorithm>
#include <cstdint>
#include <zlib.h>

#include "drivers/camera/jpeg_faults.hpp"

namespace pizarra {
namespace {

using Bytes = std::span<const unsigned char>;

// Two of the largest images that work, side by side.
constexpr std::uint32_t most_width = 16384;
constexpr std::uint32_t most_height = 8192;

constexpr std::string_view cut_short = "is cut short: its end is missing";

std::uint32_t big_endian(Bytes bytes) {
  return static_cast<std::uint32_t>(bytes[0]) << 24 | static_cast<std::uint32_t>(bytes[1]) << 16 |
         static_cast<std::uint32_t>(bytes[2]) << 8 | bytes[3];
}

// Chunk by chunk: four bytes its length, four its type, the data, and four the sum of both.
std::string_view fault_of_png(Bytes bytes) {
  constexpr std::size_t around = 12;
  for (std::size_t at = 8; at + around <= bytes.size();) {
    const Bytes rest = bytes.subspan(at);
    const std::size_t length = big_endian(rest);
    if (length > rest.size() - around) return cut_short;
    const Bytes summed = rest.subspan(4, 4 + length);
    if (crc32_z(0, summed.data(), summed.size()) != big_endian(rest.subspan(8 + length)))
      return "is damaged: its check sums are not right";
    if (std::ranges::equal(summed.first(4), std::string_view("IEND"))) return {};
    at += around + length;
  }
  return cut_short;
}

std::string_view fault_of_data(Bytes bytes, bool is_jpeg) {
  if (bytes[0] == 0x89) return fault_of_png(bytes);
  if (!is_jpeg) return {};
  switch (fault_of_jpeg(bytes)) {
    case JpegFault::cut_short:
      return cut_short;
    case JpegFault::damaged:
      return "is damaged: libjpeg finds faults in it";
    case JpegFault::too_many_scans:
      return "has more than 32 scans";
    case JpegFault::none:
      break;
  }
  return {};
}

}  // namespace

std::string_view fault_of_image(Bytes bytes) {
  const bool is_jpeg = bytes.size() > 1 && bytes[0] == 0xff && bytes[1] == 0xd8;
  const std::optional<ImageSize> size = is_jpeg ? size_of_jpeg(bytes) : size_of_image(bytes);
  if (!size && !is_jpeg) return "is no image that can be read";
  if (size && (size->width > most_width || size->height > most_height)) return "is larger than 16384x8192 px";
  return fault_of_data(bytes, is_jpeg);
}

}  // namespace pizarra
