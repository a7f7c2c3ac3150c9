#include "lisp/json.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/characters.hpp"
#include "lisp/outside_text.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

std::string json_string(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    const char first = character.front();
    if (length == 0) {
      out += '\\' + text_of_bytes(character);
    } else if (first == '"' || first == '\\') {
      out += '\\';
      out += first;
    } else if (length <= 2 && !is_shown(character)) {
      // Control characters, of which those of two bytes end in what they are.
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(character.back())));
    } else {
      out += character;
    }
    text.remove_prefix(character.size());
  }
  return out + "\"";
}

std::string json_failure(const Failure& failure) {
  const std::string place =
      failure.place.empty() ? std::string() : fmt::format(",\"place\":{}", json_string(failure.place));
  const std::string subject = failure.subject == Datum() ? "null" : json_string(write(failure.subject));
  return fmt::format("{{\"symbol\":{},\"sentence\":{},\"subject\":{}{}}}", json_string(failure.symbol),
                     json_string(failure.sentence), subject, place);
}

std::string json_error(const Failure& failure) { return fmt::format("{{\"error\":{}}}", json_failure(failure)); }

}  // namespace pizarra
