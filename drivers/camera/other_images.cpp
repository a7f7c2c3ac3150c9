#include "drivers/camera/other_images.hpp"

#include <algorithm>
#include <opencv2/core/utils/logger.hpp>

#include "drivers/camera/header_numbers.hpp"
#include "drivers/camera/opencv_files.hpp"

namespace pizarra::camera {
namespace {

using Bytes = std::span<const unsigned char>;
using Order = std::endian;

// An image whose rows are stored from the top down has a height below 0.
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

ImageSize size_of_tiff(Bytes bytes) {
  constexpr std::uint32_t width_tag = 256;
  constexpr std::uint32_t height_tag = 257;
  return {tiff_number(bytes, width_tag), tiff_number(bytes, height_tag)};
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

std::optional<ImageSize> size_of_other_image(Bytes bytes) {
  ImageSize out;
  if (says(bytes, 0, "BM")) out = size_of_bmp(bytes);
  if (says(bytes, 0, "P") && bytes.size() > 2 && bytes[1] >= '1' && bytes[1] <= '6') out = size_of_pnm(bytes);
  if (is_tiff(bytes)) out = size_of_tiff(bytes);
  if (says(bytes, 0, "RIFF") && says(bytes, 8, "WEBP")) out = size_of_webp(bytes);
  return out.width > 0 && out.height > 0 ? std::optional(out) : std::nullopt;
}

Result<cv::Mat> read_other_image(Bytes bytes, bool grey, ImageSize most) {
  if (says(bytes, 0, "GIF8")) return image_fault(is_gif);
  const std::optional<ImageSize> size = size_of_other_image(bytes);
  if (!size) return image_fault(no_image);
  if (is_too_large(*size, most)) return image_fault(larger_than(most));
  const Result<OpencvFiles> opencv = opencv_files();
  if (!opencv) return fail(opencv);
  // What goes wrong is told by our failures.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::Mat image;
  try {
    const cv::_InputArray file(bytes.data(), static_cast<int>(bytes.size()));
    image = opencv->decode(file, grey);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) return image_fault(no_image);
  return image;
}

}  // namespace pizarra::camera
