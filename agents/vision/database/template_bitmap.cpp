#include "agents/vision/database/template_bitmap.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <unistd.h>

namespace pizarra::vision {
namespace {

constexpr int levels_apart = 17;  // a template has levels 0 to 15, a bitmap 0 to 255

std::string header() { return fmt::format("P5\n{0} {0}\n255\n", template_size); }

char grey_of(std::uint8_t level, MarkTone tone) {
  const int grey = levels_apart * level;
  return static_cast<char>(tone == MarkTone::dark ? 255 - grey : grey);
}

bool write_whole(const std::filesystem::path& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK, 0644);
  if (file < 0) return false;
  const ssize_t count = ::write(file, bytes.data(), bytes.size());
  const bool written = count == static_cast<ssize_t>(bytes.size());
  if (count >= 0 && !written) errno = ENOSPC;
  const bool synced = written && ::fsync(file) == 0;
  return ::close(file) == 0 && synced;
}

// A file's name is on the disk when its folder is.
bool sync_folder(const std::filesystem::path& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return false;
  const bool synced = ::fsync(opened) == 0;
  return ::close(opened) == 0 && synced;
}

// Beside it first: whoever reads meanwhile finds the old one or the new one, whole.
Result<void> replace(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path beside = path;
  beside += ".new";
  const bool replaced = write_whole(beside, bytes) && ::rename(beside.c_str(), path.c_str()) == 0;
  if (replaced && sync_folder(path.parent_path())) return {};
  const int cause = errno;
  ::unlink(beside.c_str());
  const bool full = cause == ENOSPC || cause == EDQUOT || cause == EFBIG;
  return fail(full ? "disk-full" : "cannot-write",
              fmt::format("the template bitmap cannot be written: {}", std::strerror(cause)), to_datum(path.string()));
}

// As much of it as a sound one has, and a byte more; of what is no file, as a pipe, which might never answer, nothing.
std::optional<std::string> read_bytes(const std::filesystem::path& path) {
  std::error_code error;
  const bool there = std::filesystem::exists(path, error);
  if (there && !std::filesystem::is_regular_file(path, error)) return std::string();
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  std::string bytes(header().size() + template_size * template_size + 1, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace

Result<void> write_bitmap(const std::filesystem::path& path, const MarkTemplate& picture, MarkTone tone) {
  std::string bytes = header();
  for (const std::uint8_t level : picture) bytes += grey_of(level, tone);
  return replace(path, bytes);
}

Result<void> copy_bitmap(const std::filesystem::path& from, const std::filesystem::path& to) {
  const std::optional<std::string> bytes = read_bytes(from);
  if (!bytes) return {};
  return replace(to, *bytes);
}

Result<MarkTemplate> read_bitmap(const std::filesystem::path& path, MarkTone tone) {
  const std::optional<std::string> bytes = read_bytes(path);
  if (!bytes) return fail("missing", "the template bitmap is missing", to_datum(path.string()));
  const std::string head = header();
  MarkTemplate picture{};
  bool sound = bytes->size() == head.size() + picture.size() && bytes->starts_with(head);
  for (std::size_t i = 0; i < picture.size() && sound; ++i) {
    const int grey = static_cast<std::uint8_t>((*bytes)[head.size() + i]);
    const int weight = tone == MarkTone::dark ? 255 - grey : grey;
    picture[i] = static_cast<std::uint8_t>(weight / levels_apart);
    sound = weight % levels_apart == 0;
  }
  if (!sound) return fail("damaged", "the template bitmap is damaged", to_datum(path.string()));
  return picture;
}

}  // namespace pizarra::vision
