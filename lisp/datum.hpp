#pragma once

// A Datum is one s-expression: what agents say, what the wire carries, what files hold.
//
// It is an immutable value: copying shares structure, so a fact may be kept in many places at the cost of one. It is
// one of five kinds: symbol, string, integer (64 bit), real (finite double), list. The default Datum is the empty list.
//
//   Datum fact = list("seen"_sym, "circle", 112.25, 87.5);
//   fact.head();          // "seen"
//   fact[1].text();       // "circle"
//   fact[2].number();     // 112.25

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pizarra {

class Datum {
 public:
  enum class Kind : std::uint8_t { symbol, string, integer, real, list };

  Datum() = default;

  // A name that is_symbol_name refuses is a bug of the caller, except the comma that ReadLimits::commas yields.
  static Datum symbol(std::string_view name);
  // Text that is_string_text refuses is a bug of the caller.
  static Datum string(std::string_view text);
  static Datum integer(std::int64_t value);
  // A value that is not finite is a bug of the caller. Negative zero becomes zero, so that equal reals write equally.
  static Datum real(double value);
  static Datum list(std::vector<Datum> items);

  Kind kind() const;
  bool is_symbol() const { return kind() == Kind::symbol; }
  bool is_string() const { return kind() == Kind::string; }
  bool is_integer() const { return kind() == Kind::integer; }
  bool is_real() const { return kind() == Kind::real; }
  bool is_number() const { return is_integer() || is_real(); }
  bool is_list() const { return kind() == Kind::list; }
  bool is_symbol(std::string_view name) const { return is_symbol() && text() == name; }

  // The characters of a symbol or string; empty for the other kinds. The view lives as long as this very Datum, not as
  // long as its copies.
  std::string_view text() const;
  // The value of an integer; 0 for the other kinds.
  std::int64_t integer() const;
  // The value of an integer or a real; 0 for the other kinds.
  double number() const;
  // The elements of a list; none for the other kinds.
  std::span<const Datum> items() const;
  std::size_t size() const { return items().size(); }
  const Datum& operator[](std::size_t index) const { return items()[index]; }
  // The name of the symbol that a list begins with; empty where there is none.
  std::string_view head() const;
  // Whether this is a list that begins with the symbol `name`.
  bool is_form(std::string_view name) const { return is_list() && !name.empty() && head() == name; }

  std::size_t hash() const;

  // Integer 1 and real 1.0 are different; kinds order as they are declared.
  friend bool operator==(const Datum& a, const Datum& b);
  friend std::strong_ordering operator<=>(const Datum& a, const Datum& b);

 private:
  // Text that fits stands in the Datum itself: most facts then cost one list and nothing else.
  struct Short {
    static constexpr std::size_t capacity = 15;
    std::uint8_t size = 0;
    std::array<char, capacity> chars{};
    std::string_view view() const { return {chars.data(), size}; }
  };
  struct Long {
    std::shared_ptr<const std::string> text;
    std::string_view view() const { return *text; }
  };
  struct ShortSymbol : Short {};
  struct LongSymbol : Long {};
  struct ShortString : Short {};
  struct LongString : Long {};
  struct List {
    std::shared_ptr<const std::vector<Datum>> items;
  };
  using Value = std::variant<List, ShortSymbol, LongSymbol, ShortString, LongString, std::int64_t, double>;
  explicit Datum(Value value) : value_(std::move(value)) {}
  template <class ShortText, class LongText>
  static Datum of_text(std::string_view text);
  Value value_;
};

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
  std::vector<Datum> out;
  out.reserve(sizeof...(items));
  (out.push_back(to_datum(std::forward<Items>(items))), ...);
  return Datum::list(std::move(out));
}

}  // namespace pizarra

template <>
struct std::hash<pizarra::Datum> {
  std::size_t operator()(const pizarra::Datum& datum) const { return datum.hash(); }
};
