#include "drivers/camera/image_size.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <string_view>

namespace pizarra {
namespace {

using Bytes = std::span<const unsigned char>;
using Order = std::endian;

// 0 where the bytes end before.
std::uint32_t number(Bytes bytes, std::size_t at, std::size_t count, Order order) {
  if (at > bytes.size() || count > bytes.size() - at) return 0;
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < count; ++i) out = out << 8 | bytes[at + (order == Order::big ? i : count - 1 - i)];
  return out;
}

bool says(Bytes bytes, std::size_t at, std::string_view text) {
  return bytes.size() >= at + text.size() && std::ranges::equal(bytes.subspan(at, text.size()), text);
}

ImageSize size_of_png(Bytes bytes) { return {number(bytes, 16, 4, Order::big), number(bytes, 20, 4, Order::big)}; }

// What is told from the top down has a height below 0.
ImageSize size_of_bmp(Bytes bytes) {
  const bool is_first_version = number(bytes, 14, 4, Order::little) == 12;
  if (is_first_version) return {number(bytes, 18, 2, Order::little), number(bytes, 20, 2, Order::little)};
  const std::uint32_t height = number(bytes, 22, 4, Order::little);
  return {number(bytes, 18, 4, Order::little), std::min(height, 0U - height)};
}

// Two numbers in decimals, after blanks and comments each.
ImageSize size_of_pnm(Bytes bytes) {
  std::size_t at = 2;
  const auto next = [&] {
    constexpr std::uint32_t plenty = 100'000'000;
    const auto is_digit = [&] { return bytes[at] >= '0' && bytes[at] <= '9'; };
    bool comment = false;
    for (; at < bytes.size() && (comment || !is_digit()); ++at)
      comment = bytes[at] == '#' || (comment && bytes[at] != '\n');
    std::uint32_t out = 0;
    for (; at < bytes.size() && is_digit() && out < plenty; ++at) out = 10 * out + (bytes[at] - '0');
    return out;
  };
  const std::uint32_t width = next();
  return {width, next()};
}

// Twelve bytes an entry of the first directory: its tag, its type, how many, and the value.
ImageSize size_of_tiff(Bytes bytes) {
  constexpr std::uint32_t width_tag = 256;
  constexpr std::uint32_t height_tag = 257;
  constexpr std::uint32_t of_two_bytes = 3;
  const Order order = says(bytes, 0, "II") ? Order::little : Order::big;
  const std::size_t directory = number(bytes, 4, 4, order);
  const std::size_t entries = number(bytes, directory, 2, order);
  ImageSize out;
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * i;
    const std::uint32_t tag = number(bytes, at, 2, order);
    const std::size_t count = number(bytes, at + 2, 2, order) == of_two_bytes ? 2 : 4;
    if (tag == width_tag) out.width = number(bytes, at + 8, count, order);
    if (tag == height_tag) out.height = number(bytes, at + 8, count, order);
  }
  return out;
}

// With loss, without, or with more than an image.
ImageSize size_of_webp(Bytes bytes) {
  constexpr std::uint32_t fourteen_bits = 0x3fff;
  const auto little = [&](std::size_t at, std::size_t count) { return number(bytes, at, count, Order::little); };
  if (says(bytes, 12, "VP8X")) return {1 + little(24, 3), 1 + little(27, 3)};
  if (says(bytes, 12, "VP8L")) return {1 + (little(21, 4) & fourteen_bits), 1 + (little(21, 4) >> 14 & fourteen_bits)};
  return {little(26, 2) & fourteen_bits, little(28, 2) & fourteen_bits};
}

}  // namespace

std::optional<ImageSize> size_of_image(Bytes bytes) {
  ImageSize out;
  if (says(bytes, 1, "PNG\r\n")) out = size_of_png(bytes);
  if (says(bytes, 0, "BM")) out = size_of_bmp(bytes);
  if (says(bytes, 0, "P") && bytes.size() > 2 && bytes[1] >= '1' && bytes[1] <= '6') out = size_of_pnm(bytes);
  if (says(bytes, 0, std::string_view("II*\0", 4)) || says(bytes, 0, std::string_view("MM\0*", 4))) {
    out = size_of_tiff(bytes);
  }
  if (says(bytes, 0, "RIFF") && says(bytes, 8, "WEBP")) out = size_of_webp(bytes);
  return out.width > 0 && out.height > 0 ? std::optional(out) : std::nullopt;
}

}  // namespace pizarra
