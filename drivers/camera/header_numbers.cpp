#include "drivers/camera/header_numbers.hpp"

#include <algorithm>

namespace pizarra::camera {

using Bytes = std::span<const unsigned char>;

std::uint32_t number(Bytes bytes, std::size_t at, std::size_t count, std::endian order) {
  if (at > bytes.size() || count > bytes.size() - at) return 0;
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < count; ++i) out = out << 8 | bytes[at + (order == std::endian::big ? i : count - 1 - i)];
  return out;
}

bool says(Bytes bytes, std::size_t at, std::string_view text) {
  const auto is_same = [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); };
  return bytes.size() >= at + text.size() && std::ranges::equal(bytes.subspan(at, text.size()), text, is_same);
}

bool is_tiff(Bytes bytes) {
  return says(bytes, 0, std::string_view("II*\0", 4)) || says(bytes, 0, std::string_view("MM\0*", 4));
}

// Twelve bytes an entry: its tag, its type, how many, and the value.
std::uint32_t tiff_number(Bytes tiff, std::uint32_t tag) {
  constexpr std::uint32_t of_two_bytes = 3;
  const std::endian order = says(tiff, 0, "II") ? std::endian::little : std::endian::big;
  const std::size_t directory = number(tiff, 4, 4, order);
  const std::size_t entries = number(tiff, directory, 2, order);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * i;
    if (number(tiff, at, 2, order) != tag) continue;
    return number(tiff, at + 8, number(tiff, at + 2, 2, order) == of_two_bytes ? 2 : 4, order);
  }
  return 0;
}

}  // namespace pizarra::camera
