#include "lisp/weight.hpp"

#include <algorithm>

#include "lisp/written_escapes.hpp"

namespace pizarra {

namespace {

constexpr int bytes_bits = 32;
constexpr int elements_bits = 24;
constexpr int depth_bits = 8;

constexpr std::uint64_t below(int bits) { return std::uint64_t{1} << bits; }

// Nothing for what has no room in a word; never zero, for every list is one level deep.
std::uint64_t packed(const Weight& weight) {
  if (weight.bytes >= below(bytes_bits) || weight.elements >= below(elements_bits)) return 0;
  if (weight.depth >= below(depth_bits)) return 0;
  return weight.bytes | weight.elements << bytes_bits | weight.depth << (bytes_bits + elements_bits);
}

Weight unpacked(std::uint64_t word) {
  return {.bytes = word % below(bytes_bits),
          .elements = (word >> bytes_bits) % below(elements_bits),
          .depth = word >> (bytes_bits + elements_bits)};
}

// Of a datum that is no list.
std::size_t bytes_of(const Datum& datum) {
  constexpr std::size_t longest_number = 26;
  const Datum::Kind kind = datum.kind();
  if (kind == Datum::Kind::integer || kind == Datum::Kind::real) return longest_number;
  const std::string_view text = datum.text();
  if (kind == Datum::Kind::symbol) return text.size() + 1;
  return text.size() + static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return needs_escape(c); })) +
         3;
}

Weight weigh_items(std::span<const Datum> items) {
  Weight whole{.bytes = 3, .elements = 1};
  for (const Datum& item : items) {
    if (item.is_list()) {
      whole += weigh(item);
    } else {
      whole.bytes += bytes_of(item);
      ++whole.elements;
    }
  }
  ++whole.depth;
  return whole;
}

}  // namespace

Weight& Weight::operator+=(const Weight& other) {
  bytes += other.bytes;
  elements += other.elements;
  depth = std::max(depth, other.depth);
  return *this;
}

Weight weigh(const Datum& datum) {
  if (!datum.is_list()) return {.bytes = bytes_of(datum), .elements = 1};
  const std::span<const Datum> items = datum.items();
  if (items.empty()) return weigh_items(items);
  // Whoever else weighs it at the same time finds the same.
  std::atomic<std::uint64_t>& remembered = datum.value<const Datum::Items*>()->weight;
  if (const std::uint64_t word = remembered.load(std::memory_order_relaxed)) return unpacked(word);
  const Weight weight = weigh_items(items);
  remembered.store(packed(weight), std::memory_order_relaxed);
  return weight;
}

}  // namespace pizarra
