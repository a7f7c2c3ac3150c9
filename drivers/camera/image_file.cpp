#include "drivers/camera/image_file.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <span>
#include <vector>

#include "drivers/camera/image_faults.hpp"
#include "drivers/camera/jpeg_image.hpp"
#include "drivers/camera/other_images.hpp"
#include "drivers/camera/png_image.hpp"

namespace pizarra::camera {
namespace {

using Bytes = std::span<const unsigned char>;

constexpr std::uintmax_t most_bytes = 256 << 20;

// As many as there are room for, or fewer.
Bytes fill_from(const std::string& file, std::span<unsigned char> room) {
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(room.data()), static_cast<std::streamsize>(room.size()));
  return room.first(static_cast<std::size_t>(stream.gcount()));
}

// Bounded.
Result<std::vector<unsigned char>> bytes_of(const std::string& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > most_bytes) return image_fault("is too large for an image");
  std::vector<unsigned char> out(size);
  out.resize(fill_from(file, out).size());
  return out;
}

// PNGs, which hold what is all alike in next to nothing, are refused before they are read.
bool is_too_large_png(const std::string& file, ImageSize most) {
  std::array<unsigned char, 24> room;
  const Bytes first = fill_from(file, room);
  return first.size() == room.size() && is_png(first) && is_too_large(png_size(first), most);
}

Result<cv::Mat> read_image(const std::string& file, bool grey, ImageSize most) {
  std::error_code error;
  // A file that is none, as a pipe, might never answer.
  if (!std::filesystem::is_regular_file(file, error)) return image_fault("is no regular file");
  if (is_too_large_png(file, most)) return image_fault(larger_than(most));
  const Result<std::vector<unsigned char>> bytes = bytes_of(file);
  if (!bytes) return fail(bytes);
  if (is_jpeg(*bytes)) return read_jpeg(*bytes, grey, most);
  if (is_png(*bytes)) return read_png(*bytes, grey, most);
  return read_other_image(*bytes, grey, most);
}

}  // namespace

Result<cv::Mat> read_image_file(const std::string& file, bool grey, ImageSize most) {
  Result<cv::Mat> image = read_image(file, grey, most);
  if (!image) return fail(image.error().symbol, fmt::format("{} {}", file, image.error().sentence));
  return image;
}

}  // namespace pizarra::camera
