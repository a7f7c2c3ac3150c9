#pragma once

// Text of devices, files and people: without the blanks around it, in lower case (of ASCII; other bytes stay), and the
// number that it is.
//
//   number_from<int>("12", 0, 100)       // 12; nothing of "12 mm", "" or "101"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace pizarra {

inline constexpr std::string_view blanks = " \t\r\n\f\v";

constexpr std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

inline std::string lowered(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 32) : c; });
  return out;
}

// Nothing where the text is anything else, or the number lies outside.
template <class Number>
std::optional<Number> number_from(std::string_view text, Number low = std::numeric_limits<Number>::lowest(),
                                  Number high = std::numeric_limits<Number>::max()) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_all = error == std::errc() && end == text.data() + text.size();
  return is_all && number >= low && number <= high ? std::optional(number) : std::nullopt;
}

}  // namespace pizarra
