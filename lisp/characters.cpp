#include "lisp/characters.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/datum.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra {

namespace {

constexpr bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// A line as a person sees it: one column a character, whatever the byte was.
std::string visible(std::string_view line) {
  std::string out;
  while (!line.empty()) {
    const std::size_t length = utf8_length(line);
    if (length > 0 && line.front() == '\t') {
      out += ' ';
    } else if (length == 0 || !is_shown(line.substr(0, length))) {
      out += '?';
    } else {
      out += line.substr(0, length);
    }
    line.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::size_t characters_of(std::string_view text) {
  std::size_t out = 0;
  while (!text.empty()) {
    text.remove_prefix(std::max<std::size_t>(utf8_length(text), 1));
    ++out;
  }
  return out;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = at(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  const bool overlong = (lead == 0xE0 && at(1) < 0xA0) || (lead == 0xF0 && at(1) < 0x90);
  const bool surrogate = lead == 0xED && at(1) > 0x9F;
  const bool too_high = lead == 0xF4 && at(1) > 0x8F;
  return overlong || surrogate || too_high ? 0 : length;
}

std::string place_of(std::string_view file, std::string_view text, std::size_t offset) {
  offset = std::min(offset, text.size());
  const std::string_view before = text.substr(0, offset);
  const auto line_number = 1 + std::ranges::count(before, '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  const std::size_t column = characters_of(text.substr(line_start, offset - line_start));

  constexpr std::size_t shown = 110;
  constexpr std::size_t shown_before = 70;
  const std::size_t shown_after = shown - std::min(offset - line_start, shown_before);
  // A whole file may be one line: its end is looked for no further than it is shown, and a character beyond.
  const std::string_view near = text.substr(0, offset + shown_after + 4);
  const std::size_t line_end = std::min(near.find_first_of("\r\n", offset), near.size());
  std::size_t from = offset - line_start > shown_before ? offset - shown_before : line_start;
  std::size_t to = std::min(line_end, offset + shown_after);
  while (from < offset && is_continuation(text[from])) ++from;
  while (to < line_end && is_continuation(text[to])) ++to;
  const std::string_view begins = from > line_start ? "... " : "";
  const std::string_view ends = to < line_end ? " ..." : "";
  const std::size_t indent = begins.size() + characters_of(text.substr(from, offset - from));
  return fmt::format("{}:{}:{}\n  {}{}{}\n  {:>{}}", file, line_number, column + 1, begins,
                     visible(text.substr(from, to - from)), ends, '^', indent + 1);
}

bool is_symbol_name(std::string_view name) {
  return !name.empty() && name != "." && !begins_like_number(name) && std::ranges::all_of(name, is_symbol_char);
}

bool is_string_text(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0 || text.front() == '\0') return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace pizarra
