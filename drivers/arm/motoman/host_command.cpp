#include "drivers/arm/motoman/host_command.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

#include "lisp/plain_text.hpp"

namespace pizarra::arm {

namespace {

constexpr std::size_t most_numbers = 64;

std::optional<double> number_in(std::string_view text) {
  text = trimmed(text);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::optional<double> number = number_in(text.substr(0, comma));
    if (!number || numbers.size() >= most_numbers) return std::nullopt;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

bool is_host_code(std::string_view text) {
  return text.size() == 4 && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::unexpected<Failure> refused_command(const std::string& name, std::string_view code) {
  std::uint16_t value = 0;
  std::from_chars(code.data(), code.data() + code.size(), value, 16);
  return fail("refused", fmt::format("the controller refused {}: {}", name, code), to_datum(value));
}

}  // namespace pizarra::arm
