#include "drivers/camera/image_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <glob.h>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

#include "drivers/camera/image_faults.hpp"
#include "drivers/camera/image_pairs.hpp"

namespace pizarra {
namespace {

constexpr std::size_t most_files = 100'000;
constexpr std::uintmax_t most_bytes = 256 << 20;

bool has_image_name(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::string_view endings[] = {".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm", ".tif", ".tiff", ".webp"};
  return std::ranges::find(endings, ending) != std::end(endings);
}

// As the shell expands the pattern.
std::vector<std::string> files_like(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> out;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0) {
    out.assign(found.gl_pathv, found.gl_pathv + std::min<std::size_t>(found.gl_pathc, most_files));
  }
  globfree(&found);
  return out;
}

// Bounded; a file that is none, as a pipe, might never answer.
Result<std::vector<unsigned char>> bytes_of(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    return fail("corrupt-frame", fmt::format("{} is no regular file", file));
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > most_bytes) return fail("corrupt-frame", fmt::format("{} is too large for an image", file));
  std::vector<unsigned char> out(size);
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(size));
  out.resize(static_cast<std::size_t>(stream.gcount()));
  return out;
}

}  // namespace

std::vector<std::string> image_files_at(const std::string& where) {
  std::error_code error;
  if (!std::filesystem::is_directory(where, error)) return files_like(where);
  std::vector<std::string> out;
  for (std::filesystem::directory_iterator it(where, error), end; !error && it != end; it.increment(error)) {
    if (out.size() < most_files && has_image_name(it->path().string())) out.push_back(it->path().string());
  }
  std::ranges::sort(out);
  return out;
}

Result<cv::Mat> read_image_file(const std::string& file, bool grey) {
  const Result<std::vector<unsigned char>> bytes = bytes_of(file);
  if (!bytes) return fail(bytes);
  const std::string_view fault = fault_of_image(*bytes);
  if (!fault.empty()) return fail("corrupt-frame", fmt::format("{} {}", file, fault));
  cv::Mat image;
  try {
    if (!bytes->empty()) image = cv::imdecode(*bytes, grey ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    image.release();
  }
  return checked_image(std::move(image), file);
}

Result<void> ImageFiles::open() {
  // What goes wrong is told by our failures.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  files_ = image_files_at(where_);
  taken_ = 0;
  if (files_.empty()) return fail("disconnected", fmt::format("there are no images at {}", where_));
  return partner_.empty() ? Result<void>() : keep_paired();
}

Result<void> ImageFiles::keep_paired() {
  std::vector<std::string> others = image_files_at(partner_);
  // Its own side tells that.
  if (others.empty()) return {};
  Result<ImagePairs> pairs = side_ == 0 ? pair_files(files_, std::move(others)) : pair_files(std::move(others), files_);
  if (!pairs) return fail(pairs);
  files_ = std::move(pairs->sides[side_]);
  left_out_ = pairs->alone[side_];
  return {};
}

Result<std::optional<double>> ImageFiles::grab() {
  if (taken_ == files_.size()) return fail("ended", fmt::format("there are no more images at {}", where_));
  return 1000 * static_cast<double>(taken_++) / rate_hz_;
}

Result<cv::Mat> ImageFiles::retrieve() { return read_image_file(files_[taken_ - 1], grey_); }

}  // namespace pizarra
