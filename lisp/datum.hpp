#pragma once

// A Datum is one s-expression: what agents say, what the wire carries, what files hold.
//
// It is an immutable value of 16 bytes: copying shares structure, so a fact may be kept in many places at the cost of
// one. It is one of five kinds: symbol, string, integer (64 bit), real (finite double), list. The default Datum is the
// empty list. Numbers and text of up to 15 bytes stand in the Datum itself, and a list is one block of memory, so that
// most facts are one allocation. Copies may be used and destroyed by any thread.
//
//   Datum fact = list("seen"_sym, "circle", 112.25, 87.5);
//   fact.head();          // "seen"
//   fact[1].text();       // "circle"
//   fact[2].number();     // 112.25

#include <array>
#include <atomic>
#include <bit>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pizarra {

struct Weight;

class Datum {
 public:
  enum class Kind : std::uint8_t { symbol, string, integer, real, list };

  Datum() = default;
  Datum(const Datum& other) : words_(other.words_) {
    if (shares()) share();
  }
  Datum(Datum&& other) noexcept : words_(other.words_) { other.forget(); }
  Datum& operator=(const Datum& other) { return *this = Datum(other); }
  Datum& operator=(Datum&& other) noexcept {
    Datum taken(std::move(other));
    std::swap(words_, taken.words_);
    return *this;
  }
  ~Datum() {
    if (shares()) release();
  }

  // A name that is_symbol_name refuses is a bug of the caller, except the comma that ReadLimits::commas yields.
  static Datum symbol(std::string_view name);
  // Bytes that is_string_text refuses stand as escapes (lisp/outside_text.hpp).
  static Datum string(std::string_view text);
  // The same for a reader, which has looked at every byte already.
  static Datum checked_symbol(std::string_view name) { return of_text(name, Form::short_symbol, Form::long_symbol); }
  static Datum checked_string(std::string_view text) { return of_text(text, Form::short_string, Form::long_string); }
  static Datum integer(std::int64_t value) { return {Form::integer, std::bit_cast<std::uint64_t>(value)}; }
  // A value that is not finite is a bug of the caller. Negative zero becomes zero, so that equal reals write equally.
  static Datum real(double value);
  static Datum list(std::vector<Datum> items) { return list_of(items); }
  // The same, of items that are moved out of where they stand.
  static Datum list_of(std::span<Datum> items);

  Kind kind() const { return kinds[tag() >> form_shift]; }
  bool is_symbol() const { return kind() == Kind::symbol; }
  bool is_string() const { return kind() == Kind::string; }
  bool is_integer() const { return kind() == Kind::integer; }
  bool is_real() const { return kind() == Kind::real; }
  bool is_number() const { return is_integer() || is_real(); }
  bool is_list() const { return kind() == Kind::list; }
  bool is_symbol(std::string_view name) const { return is_symbol() && text() == name; }

  // The characters of a symbol or string; empty for the other kinds. The view lives as long as this very Datum, not as
  // long as its copies.
  std::string_view text() const {
    const std::uint8_t form = tag();
    if (form >= first_tag(Form::integer)) return {};
    if (form >= first_tag(Form::short_symbol)) return {characters(), static_cast<std::size_t>(form & length_mask)};
    return form >= first_tag(Form::long_symbol) ? long_text() : std::string_view();
  }
  // The value of an integer; 0 for the other kinds.
  std::int64_t integer() const { return is_integer() ? value<std::int64_t>() : 0; }
  // The value of an integer or a real; 0 for the other kinds.
  double number() const { return is_real() ? value<double>() : static_cast<double>(integer()); }
  // The elements of a list; none for the other kinds.
  std::span<const Datum> items() const;
  std::size_t size() const { return items().size(); }
  const Datum& operator[](std::size_t index) const { return items()[index]; }
  // The name of the symbol that a list begins with; empty where there is none.
  std::string_view head() const {
    const std::span<const Datum> elements = items();
    return elements.empty() || !elements.front().is_symbol() ? std::string_view() : elements.front().text();
  }
  // Whether this is a list that begins with the symbol `name`. In line, where `name` is a literal of known length.
  [[gnu::always_inline]] bool is_form(std::string_view name) const {
    return is_list() && !name.empty() && head() == name;
  }

  std::size_t hash() const;

  // Integer 1 and real 1.0 are different; kinds order as they are declared.
  friend bool operator==(const Datum& a, const Datum& b) {
    // Two comparisons, where that of the arrays is a call.
    const bool same_words = a.words_[0] == b.words_[0] && a.words_[1] == b.words_[1];
    return same_words || (a.tag() == b.tag() && a.shares() && a.same_shared(b));
  }
  friend std::strong_ordering operator<=>(const Datum& a, const Datum& b);
  friend Weight weigh(const Datum& datum);

 private:
  // How it is kept. The first three share what a pointer leads to.
  enum class Form : std::uint8_t { list, long_symbol, long_string, short_symbol, short_string, integer, real };
  static constexpr std::array kinds{Kind::list,   Kind::symbol,  Kind::string, Kind::symbol,
                                    Kind::string, Kind::integer, Kind::real};
  static constexpr std::size_t capacity = 15;  // of short text, in bytes
  static constexpr int form_shift = 4;
  static constexpr std::uint8_t length_mask = 15;  // of short text
  static constexpr int tag_shift = 56;
  static constexpr std::uint8_t first_tag(Form form) {
    return static_cast<std::uint8_t>(static_cast<unsigned>(form) << form_shift);
  }

  struct Shared {
    mutable std::atomic<std::uint32_t> users{1};
  };
  struct Text;
  struct Items;

  Datum(Form form, std::uint64_t word) : words_{word, std::uint64_t{first_tag(form)} << tag_shift} {}
  static Datum of_text(std::string_view text, Form short_form, Form long_form);
  std::uint8_t tag() const { return static_cast<std::uint8_t>(words_[1] >> tag_shift); }
  template <class T>
  T value() const {
    return std::bit_cast<T>(words_[0]);
  }
  const char* characters() const { return reinterpret_cast<const char*>(words_.data()); }
  bool shares() const { return tag() < first_tag(Form::short_symbol) && words_[0] != 0; }
  void share() const { value<const Shared*>()->users.fetch_add(1, std::memory_order_relaxed); }
  void release();
  void forget() { words_ = {}; }
  std::string_view long_text() const;
  // Of two of the same form.
  bool same_shared(const Datum& other) const;

  // The first holds the value, or both short text; the last byte says the form and the length of short text. Unused
  // bytes are zero, so that equal scalars have equal words.
  std::array<std::uint64_t, 2> words_{};
};

static_assert(sizeof(Datum) == 16 && sizeof(void*) == 8 && std::endian::native == std::endian::little);

struct Datum::Items : Datum::Shared {
  explicit Items(std::uint32_t count) : size(count) {}
  std::uint32_t size;
  mutable std::atomic<std::uint64_t> weight{0};  // once weigh() has found it
  Datum* data() { return reinterpret_cast<Datum*>(this + 1); }
  const Datum* data() const { return reinterpret_cast<const Datum*>(this + 1); }
};

inline std::span<const Datum> Datum::items() const {
  if (tag() != first_tag(Form::list)) return {};
  const auto* items = value<const Items*>();
  return items == nullptr ? std::span<const Datum>() : std::span(items->data(), items->size);
}

// Whether the strict reader reads `name` as one symbol.
bool is_symbol_name(std::string_view name);
// Whether the strict reader can read `text` inside a string: valid UTF-8 without NUL.
bool is_string_text(std::string_view text);

inline Datum operator""_sym(const char* name, std::size_t size) { return Datum::symbol({name, size}); }

// What a C++ value is as a Datum: text is a string, whole numbers integers, floating point reals.
inline Datum to_datum(Datum datum) { return datum; }
inline Datum to_datum(std::string_view text) { return Datum::string(text); }
inline Datum to_datum(const char* text) { return Datum::string(text); }
inline Datum to_datum(const std::string& text) { return Datum::string(text); }
inline Datum to_datum(std::integral auto value) { return Datum::integer(static_cast<std::int64_t>(value)); }
inline Datum to_datum(std::floating_point auto value) { return Datum::real(value); }

template <class... Items>
Datum list(Items&&... items) {
  std::array<Datum, sizeof...(items)> out = {to_datum(std::forward<Items>(items))...};
  return Datum::list_of(out);
}

}  // namespace pizarra

template <>
struct std::hash<pizarra::Datum> {
  std::size_t operator()(const pizarra::Datum& datum) const { return datum.hash(); }
};
