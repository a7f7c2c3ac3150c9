#pragma once

// Names that suit a symbol, a fact's argument and a file alike: letters, digits and dashes, a letter first. Keys,
// agents, objects and the names of a path have this form. In our Scheme it is plain-name? of (pizarra forms).
//
//   is_plain_name("ur5e-2");       // and neither "2nd" nor "my cube"

#include <algorithm>
#include <string_view>

namespace pizarra {

inline constexpr std::size_t longest_plain_name = 64;

constexpr bool is_plain_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto fits = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && name.size() <= longest_plain_name && is_letter(name.front()) &&
         std::ranges::all_of(name, fits);
}

}  // namespace pizarra
