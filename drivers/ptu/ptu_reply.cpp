#include "drivers/ptu/ptu_reply.hpp"

#include <charconv>

#include "lisp/plain_text.hpp"

namespace pizarra::ptu {

PtuLine read_ptu_line(std::string_view line) {
  PtuLine read;
  while (true) {
    const std::size_t mark = line.find_first_of("*!");
    read.echo += trimmed(line.substr(0, mark));
    if (mark == std::string_view::npos) return read;
    line.remove_prefix(mark);
    const bool pan_hit = line.starts_with("!P");
    const bool tilt_hit = line.starts_with("!T");
    if (!pan_hit && !tilt_hit) break;
    read.pan_hit |= pan_hit;
    read.tilt_hit |= tilt_hit;
    line.remove_prefix(2);
  }
  read.result = line.front() == '*' ? PtuLine::Result::ok : PtuLine::Result::error;
  read.text = trimmed(line.substr(1));
  return read;
}

std::optional<double> first_number(std::string_view text) {
  while (!text.empty()) {
    const std::size_t digit = text.find_first_of("0123456789");
    if (digit == std::string_view::npos) return std::nullopt;
    const bool negative = digit > 0 && text[digit - 1] == '-';
    double value = 0;
    const auto [end, error] = std::from_chars(text.data() + digit, text.data() + text.size(), value);
    if (error == std::errc()) return negative ? -value : value;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return std::nullopt;
}

}  // namespace pizarra::ptu
