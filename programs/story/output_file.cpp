#include "programs/story/output_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace pizarra::story {

namespace {

// A piece of a film at its outermost level: of an AVI file its RIFF list, of an MP4 file a box.
struct Piece {
  std::string_view type;
  std::uint64_t bytes = 0;  // with its header
};

std::uint64_t number(std::span<const char> bytes, bool little_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    value = value << 8 | static_cast<std::uint8_t>(bytes[little_endian ? bytes.size() - 1 - i : i]);
  }
  return value;
}

Piece piece_of(std::span<const char, 16> header) {
  if (std::string_view(header.data(), 4) == "RIFF") {
    return {std::string_view(header.data(), 4), 8 + number(header.subspan(4, 4), true)};
  }
  const std::uint64_t bytes = number(header.first(4), false);
  return {std::string_view(header.data() + 4, 4), bytes == 1 ? number(header.subspan(8, 8), false) : bytes};
}

}  // namespace

Result<void> make_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) return fail("cannot-write", fmt::format("cannot make the folder of {}: {}", path, error.message()));
  return {};
}

Result<void> check_writable(const std::string& path) {
  const Result<void> folder = make_folder_of(path);
  if (!folder) return folder;
  const bool there = std::filesystem::exists(path);
  errno = 0;
  const bool opened = std::ofstream(path, std::ios::app).is_open();
  if (!opened) return fail("cannot-write", fmt::format("cannot write {}: {}", path, std::strerror(errno)));
  if (!there) std::remove(path.c_str());
  return {};
}

Result<void> write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  const Result<void> folder = make_folder_of(path);
  if (!folder) return folder;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) return fail(unwritten(path));
  return {};
}

bool is_whole_film(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (!in || error) return false;
  bool indexed = false;
  std::uint64_t at = 0;
  while (at < size) {
    std::array<char, 16> header{};
    in.seekg(static_cast<std::streamoff>(at));
    if (!in.read(header.data(), header.size())) in.clear();
    const Piece piece = piece_of(header);
    if (piece.bytes < 8 || piece.bytes > size - at) return false;
    indexed = indexed || piece.type == "RIFF" || piece.type == "moov";
    at += piece.bytes;
  }
  return indexed;
}

Failure unwritten(const std::string& path) {
  // More than what is left of a block that is the file's already.
  const std::vector<char> more(1 << 20);
  // One that was never made says why when it is made here.
  const bool was_there = std::filesystem::exists(path);
  const int file = open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_CREAT, 0644);
  std::string reason = file < 0 ? std::strerror(errno) : "the disk was full, or failed";
  if (file >= 0) {
    const off_t end = lseek(file, 0, SEEK_END);
    // The part that fits is written, and the next write says why no more does.
    const bool fits = ::write(file, more.data(), more.size()) == static_cast<ssize_t>(more.size());
    if (!fits && ::write(file, more.data(), more.size()) < 0) reason = std::strerror(errno);
    if (ftruncate(file, end) != 0) reason += ", and it cannot be shortened";
    close(file);
  }
  std::error_code ignored;
  if (!was_there) std::filesystem::remove(path, ignored);
  return {"cannot-write", fmt::format("cannot write {} whole: {}", path, reason), {}, {}};
}

}  // namespace pizarra::story
