#include "lisp/datum.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>

#include "lisp/elements_looked_at.hpp"
#include "lisp/keyed_hash.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra {

struct Datum::Text : Datum::Shared {
  explicit Text(std::uint32_t count) : size(count) {}
  std::uint32_t size;
  char* data() { return reinterpret_cast<char*>(this + 1); }
  const char* data() const { return reinterpret_cast<const char*>(this + 1); }
};

Datum Datum::of_text(std::string_view text, Form short_form, Form long_form) {
  if (text.size() <= capacity) {
    Datum datum(short_form, 0);
    std::memcpy(datum.words_.data(), text.data(), text.size());
    datum.words_[1] |= std::uint64_t{text.size()} << tag_shift;
    return datum;
  }
  Text* shared = new (::operator new(sizeof(Text) + text.size())) Text(static_cast<std::uint32_t>(text.size()));
  std::ranges::copy(text, shared->data());
  return {long_form, std::bit_cast<std::uint64_t>(shared)};
}

Datum Datum::symbol(std::string_view name) {
  assert(is_symbol_name(name) || name == ",");
  return checked_symbol(name);
}

Datum Datum::string(std::string_view text) {
  return is_string_text(text) ? checked_string(text) : checked_string(lines_of_bytes(text));
}

Datum Datum::real(double value) {
  assert(std::isfinite(value));
  return {Form::real, std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)};
}

Datum Datum::list_of(std::span<Datum> items) {
  if (items.empty()) return {};
  auto* shared =
      new (::operator new(sizeof(Items) + items.size_bytes())) Items(static_cast<std::uint32_t>(items.size()));
  std::uninitialized_move(items.begin(), items.end(), shared->data());
  return {Form::list, std::bit_cast<std::uint64_t>(shared)};
}

void Datum::release() {
  auto* shared = value<Shared*>();
  // A single thread needs no locked instruction to say so.
  const bool alone = shared->users.load(std::memory_order_acquire) == 1;
  if (!alone && shared->users.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
  if (is_list()) {
    auto* items = static_cast<Items*>(shared);
    std::destroy_n(items->data(), items->size);
  }
  ::operator delete(shared);
}

std::string_view Datum::long_text() const {
  const auto* shared = value<const Text*>();
  return {shared->data(), shared->size};
}

bool Datum::same_shared(const Datum& other) const {
  if (is_list()) {
    const auto left = items();
    const auto right = other.items();
    if (left.size() != right.size()) return false;
    const auto differing = std::ranges::mismatch(left, right).in1;
    elements_looked_at += static_cast<std::size_t>(differing - left.begin());
    return differing == left.end();
  }
  if (long_text().size() != other.long_text().size()) return false;
  look_at_text(long_text().size());
  return long_text() == other.long_text();
}

std::size_t Datum::hash() const {
  if (is_list()) {
    std::size_t out = keyed_mix(tag(), size());
    elements_looked_at += size();
    for (const Datum& item : items()) out = keyed_mix(out, item.hash());
    return out;
  }
  if (shares()) {
    look_at_text(long_text().size());
    return keyed_mix(tag(), keyed_hash(long_text()));
  }
  return keyed_mix(words_[0], words_[1]);
}

std::strong_ordering operator<=>(const Datum& a, const Datum& b) {
  if (a.kind() != b.kind()) return a.kind() <=> b.kind();
  const bool short_texts = std::min(a.tag(), b.tag()) >= Datum::first_tag(Datum::Form::short_symbol) &&
                           std::max(a.tag(), b.tag()) < Datum::first_tag(Datum::Form::integer);
  // No text holds the zeros behind a shorter one, and the byte that says its length comes last.
  if (short_texts) {
    const auto order = std::byteswap(a.words_[0]) <=> std::byteswap(b.words_[0]);
    return order != 0 ? order : std::byteswap(a.words_[1]) <=> std::byteswap(b.words_[1]);
  }
  switch (a.kind()) {
    case Datum::Kind::symbol:
    case Datum::Kind::string:
      look_at_text(std::min(a.text().size(), b.text().size()));
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
  for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
    ++elements_looked_at;
    if (const auto order = left[i] <=> right[i]; order != 0) return order;
  }
  return left.size() <=> right.size();
}

}  // namespace pizarra
