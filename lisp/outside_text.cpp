#include "lisp/outside_text.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/characters.hpp"

namespace pizarra {
namespace {

std::string escaped(std::string_view bytes) {
  if (bytes == "\n") return "\\n";
  if (bytes == "\t") return "\\t";
  std::string out;
  for (const char c : bytes) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  return out;
}

std::string made_text(std::string_view bytes, std::string_view kept) {
  std::string out;
  out.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t length = utf8_length(bytes);
    const std::string_view character = bytes.substr(0, std::max<std::size_t>(length, 1));
    const bool stays = length == 1 && kept.find(character.front()) != kept.npos;
    const bool shown = length > 0 && (stays || is_shown(character));
    out += shown ? std::string(character) : escaped(character);
    bytes.remove_prefix(character.size());
  }
  return out;
}

}  // namespace

std::string text_of_bytes(std::string_view bytes) { return made_text(bytes, ""); }

std::string lines_of_bytes(std::string_view bytes) { return made_text(bytes, "\n\t"); }

// Control characters are those of ASCII and, of two bytes, U+0080 to U+009F, of which some terminals take U+009B for
// an escape sequence's beginning. U+202A to U+202E and U+2066 to U+2069 turn around what is written beside them.
bool is_shown(std::string_view character) {
  const auto between = [&](std::string_view first, std::string_view last) {
    return character.size() == first.size() && character >= first && character <= last;
  };
  if (character.size() == 1) return static_cast<unsigned char>(character.front()) >= 0x20 && character != "\x7F";
  return !between("\xC2\x80", "\xC2\x9F") && !between("\xE2\x80\xAA", "\xE2\x80\xAE") &&
         !between("\xE2\x81\xA6", "\xE2\x81\xA9");
}

}  // namespace pizarra
