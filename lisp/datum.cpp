#include "lisp/datum.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <type_traits>

namespace pizarra {

template <class ShortText, class LongText>
Datum Datum::of_text(std::string_view text) {
  if (text.size() > Short::capacity) {
    LongText value;
    value.text = std::make_shared<const std::string>(text);
    return Datum(Value(std::move(value)));
  }
  ShortText value;
  value.size = static_cast<std::uint8_t>(text.size());
  std::ranges::copy(text, value.chars.begin());
  return Datum(Value(value));
}

Datum Datum::symbol(std::string_view name) {
  assert(is_symbol_name(name) || name == ",");
  return of_text<ShortSymbol, LongSymbol>(name);
}

Datum Datum::string(std::string_view text) {
  assert(is_string_text(text));
  return of_text<ShortString, LongString>(text);
}

Datum Datum::integer(std::int64_t value) { return Datum(Value(value)); }

Datum Datum::real(double value) {
  assert(std::isfinite(value));
  return Datum(Value(value == 0.0 ? 0.0 : value));
}

Datum Datum::list(std::vector<Datum> items) {
  if (items.empty()) return {};
  List value;
  value.items = std::make_shared<const std::vector<Datum>>(std::move(items));
  return Datum(Value(std::move(value)));
}

Datum::Kind Datum::kind() const {
  static constexpr std::array kinds{Kind::list,   Kind::symbol,  Kind::symbol, Kind::string,
                                    Kind::string, Kind::integer, Kind::real};
  static_assert(kinds.size() == std::variant_size_v<Value>);
  return kinds[value_.index()];
}

std::string_view Datum::text() const {
  if (const auto* symbol = std::get_if<ShortSymbol>(&value_)) return symbol->view();
  if (const auto* string = std::get_if<ShortString>(&value_)) return string->view();
  if (const auto* symbol = std::get_if<LongSymbol>(&value_)) return symbol->view();
  if (const auto* string = std::get_if<LongString>(&value_)) return string->view();
  return {};
}

std::int64_t Datum::integer() const {
  const auto* value = std::get_if<std::int64_t>(&value_);
  return value ? *value : 0;
}

double Datum::number() const {
  if (const auto* value = std::get_if<double>(&value_)) return *value;
  return static_cast<double>(integer());
}

std::span<const Datum> Datum::items() const {
  const auto* list = std::get_if<List>(&value_);
  if (!list || !list->items) return {};
  return *list->items;
}

std::string_view Datum::head() const {
  const auto elements = items();
  if (elements.empty() || !elements.front().is_symbol()) return {};
  return elements.front().text();
}

std::size_t Datum::hash() const {
  const auto mix = [](std::size_t seed, std::size_t value) {
    return (std::rotl(seed, 5) ^ value) * std::size_t{0x9e3779b97f4a7c15};
  };
  const std::size_t seed = static_cast<std::size_t>(kind()) + 1;
  switch (kind()) {
    case Kind::symbol:
    case Kind::string:
      return mix(seed, std::hash<std::string_view>{}(text()));
    case Kind::integer:
      return mix(seed, static_cast<std::size_t>(integer()));
    case Kind::real:
      return mix(seed, std::hash<double>{}(number()));
    case Kind::list:
      break;
  }
  std::size_t out = mix(seed, size());
  for (const Datum& item : items()) out = mix(out, item.hash());
  return out;
}

bool operator==(const Datum& a, const Datum& b) {
  if (a.kind() != b.kind()) return false;
  switch (a.kind()) {
    case Datum::Kind::symbol:
    case Datum::Kind::string:
      return a.text() == b.text();
    case Datum::Kind::integer:
      return a.integer() == b.integer();
    case Datum::Kind::real:
      return a.number() == b.number();
    case Datum::Kind::list:
      break;
  }
  return a.items().data() == b.items().data() || std::ranges::equal(a.items(), b.items());
}

std::strong_ordering operator<=>(const Datum& a, const Datum& b) {
  if (a.kind() != b.kind()) return a.kind() <=> b.kind();
  switch (a.kind()) {
    case Datum::Kind::symbol:
    case Datum::Kind::string:
      return a.text() <=> b.text();
    case Datum::Kind::integer:
      return a.integer() <=> b.integer();
    case Datum::Kind::real:
      return std::strong_order(a.number(), b.number());
    case Datum::Kind::list:
      break;
  }
  const auto left = a.items();
  const auto right = b.items();
  return std::lexicographical_compare_three_way(left.begin(), left.end(), right.begin(), right.end());
}

}  // namespace pizarra
