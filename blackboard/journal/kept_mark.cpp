#include "blackboard/journal/kept_mark.hpp"

#include <array>
#include <charconv>
#include <fcntl.h>
#include <unistd.h>

namespace pizarra::journal {

namespace {

// A number of one length, so that each is written over the other, and a newline.
constexpr std::size_t digits = 19;

}  // namespace

KeptMark::~KeptMark() {
  if (file_ >= 0) close(file_);
}

std::optional<std::int64_t> KeptMark::get() const {
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  std::array<char, digits + 1> text{};
  const ssize_t length = pread(file, text.data(), text.size(), 0);
  close(file);
  std::int64_t entry = 0;
  const auto read = std::from_chars(text.data(), text.data() + digits, entry);
  // A power cut may leave anything of what nobody waited for.
  const bool whole = length == ssize_t{digits + 1} && read.ptr == text.data() + digits && text.back() == '\n';
  return whole ? std::optional(entry) : std::nullopt;
}

void KeptMark::set(std::int64_t entry) {
  if (file_ < 0) file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  std::string text = std::to_string(entry);
  text.insert(0, digits - text.size(), '0');
  text += '\n';
  [[maybe_unused]] const ssize_t written = pwrite(file_, text.data(), text.size(), 0);
}

}  // namespace pizarra::journal
