#include "blackboard/journal/kept_mark.hpp"

#include <charconv>

namespace pizarra::journal {

namespace {

// A number of one length, so that each is written over the other, and a newline.
constexpr std::size_t digits = 19;

}  // namespace

std::optional<std::int64_t> KeptMark::get() const {
  const std::unique_ptr<Disk::File> file = disk_.open(path_, Disk::Access::read);
  if (file == nullptr) return std::nullopt;
  const std::string text = file->read(digits + 1);
  std::int64_t entry = 0;
  // A power cut may leave anything of what nobody waited for.
  const bool whole = text.size() == digits + 1 && text.back() == '\n' &&
                     std::from_chars(text.data(), text.data() + digits, entry).ptr == text.data() + digits;
  return whole ? std::optional(entry) : std::nullopt;
}

void KeptMark::set(std::int64_t entry) {
  if (file_ == nullptr) file_ = disk_.open(path_, Disk::Access::write);
  if (file_ == nullptr) return;
  std::string text = std::to_string(entry);
  text.insert(0, digits - text.size(), '0');
  text += '\n';
  [[maybe_unused]] const bool written = file_->write_at(0, text);
}

}  // namespace pizarra::journal
