#include "lisp/json.hpp"

#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra {

std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
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
