#include "blackboard/journal/log_ahead.hpp"

#include <array>

namespace pizarra::journal {

namespace {

// A thousand pages, after which SQLite copies them to where they belong, and those of the transaction that is the last.
constexpr std::int64_t wanted = 1032 * std::int64_t{4096 + 24};
constexpr std::int64_t of_what_is_free = 64;

}  // namespace

void write_log_ahead(Disk& disk, const std::string& path) {
  if (!disk.status(path)) return;
  const std::unique_ptr<Disk::File> file = disk.open(path, Disk::Access::write);
  if (file == nullptr || file->free_bytes() / of_what_is_free <= wanted) return;
  static constexpr std::array<char, 64 << 10> nothing{};
  for (std::int64_t end = file->bytes(); end < wanted; end += static_cast<std::int64_t>(nothing.size())) {
    if (!file->write_at(end, {nothing.data(), nothing.size()})) return;
  }
}

}  // namespace pizarra::journal
