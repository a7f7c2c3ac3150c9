#include "drivers/camera/image_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <glob.h>

#include "drivers/camera/image_pairs.hpp"

namespace pizarra::camera {
namespace {

constexpr std::size_t most_files = 100'000;

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

std::string no_images_at(const std::string& where) {
  std::error_code error;
  const std::filesystem::directory_iterator first(where, error);
  const bool empty = error || first == std::filesystem::directory_iterator();
  if (empty) return fmt::format("there are no images at {}", where);
  return fmt::format("there are no images at {}: {}, by the ends of their names, and {} is none of these", where,
                     formats_read, first->path().filename().string());
}

Result<void> ImageFiles::open() {
  files_ = image_files_at(where_);
  taken_ = 0;
  if (files_.empty()) return fail("disconnected", no_images_at(where_));
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
  return 1000 * static_cast<double>(taken_++) / recorded_hz();
}

Result<cv::Mat> ImageFiles::retrieve(bool grey) {
  return read_image_file(files_[taken_ - 1], grey || reading_.grey, reading_.most);
}

}  // namespace pizarra::camera
