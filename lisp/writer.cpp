#include "lisp/writer.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstring>
#include <string_view>

#include "lisp/decimal.hpp"
#include "lisp/written_escapes.hpp"

namespace pizarra {

namespace {

constexpr std::size_t longest_number = 32;

// At least what it takes, in bytes.
std::size_t room_for_text(std::string_view text) { return 2 * text.size() + 2; }

std::size_t room_for(const Datum& datum) {
  if (datum.is_number()) return longest_number;
  if (!datum.is_list()) return room_for_text(datum.text());
  std::size_t room = 2;
  for (const Datum& item : datum.items()) room += room_for(item) + 1;
  return room;
}

// These answer where what they wrote ends.

char* write_plain(char* out, std::string_view text) {
  std::memcpy(out, text.data(), text.size());
  return out + text.size();
}

char* write_string(char* out, std::string_view text) {
  *out++ = '"';
  while (true) {
    const auto plain = static_cast<std::size_t>(std::ranges::find_if(text, needs_escape) - text.begin());
    out = write_plain(out, text.substr(0, plain));
    text.remove_prefix(plain);
    if (text.empty()) break;
    *out++ = '\\';
    *out++ = text.front() == '\n' ? 'n' : text.front() == '\t' ? 't' : text.front();
    text.remove_prefix(1);
  }
  *out++ = '"';
  return out;
}

template <class Number>
char* write_digits(char* out, Number value) {
  const auto [end, error] = std::to_chars(out, out + longest_number, value);
  assert(error == std::errc());
  return end;
}

char* write_real(char* out, double value) {
  if (char* end = write_decimal(out, value)) return end;
  char* const end = write_digits(out, value);
  return std::string_view(out, end).find_first_of(".e") == std::string_view::npos ? write_plain(end, ".0") : end;
}

char* write_datum(char* out, const Datum& datum) {
  switch (datum.kind()) {
    case Datum::Kind::symbol:
      return write_plain(out, datum.text());
    case Datum::Kind::string:
      return write_string(out, datum.text());
    case Datum::Kind::integer:
      return write_digits(out, datum.integer());
    case Datum::Kind::real:
      return write_real(out, datum.number());
    case Datum::Kind::list:
      break;
  }
  *out++ = '(';
  bool first = true;
  for (const Datum& item : datum.items()) {
    if (!first) *out++ = ' ';
    first = false;
    out = write_datum(out, item);
  }
  *out++ = ')';
  return out;
}

}  // namespace

void write_to(std::string& out, const Datum& datum) {
  const std::size_t before = out.size();
  out.resize_and_overwrite(before + room_for(datum), [&](char* text, std::size_t) {
    return static_cast<std::size_t>(write_datum(text + before, datum) - text);
  });
}

void write_string_to(std::string& out, std::string_view text) {
  const std::size_t before = out.size();
  out.resize_and_overwrite(before + room_for_text(text), [&](char* begin, std::size_t) {
    return static_cast<std::size_t>(write_string(begin + before, text) - begin);
  });
}

std::string write(const Datum& datum) {
  std::string out;
  write_to(out, datum);
  return out;
}

}  // namespace pizarra
