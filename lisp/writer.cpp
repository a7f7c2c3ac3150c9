#include "lisp/writer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include "lisp/decimal.hpp"
#include "lisp/escapes.hpp"

namespace pizarra {

namespace {

void write_string(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const auto plain = static_cast<std::size_t>(std::ranges::find_if(text, needs_escape) - text.begin());
    out += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    out += '\\';
    out += text.front() == '\n' ? 'n' : text.front() == '\t' ? 't' : text.front();
    text.remove_prefix(1);
  }
  out += '"';
}

template <class Number>
std::string_view digits_of(std::array<char, 32>& buffer, Number value) {
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  assert(error == std::errc());
  return {buffer.data(), static_cast<std::size_t>(end - buffer.data())};
}

}  // namespace

void write_to(std::string& out, const Datum& datum) {
  std::array<char, 32> buffer;
  switch (datum.kind()) {
    case Datum::Kind::symbol:
      out += datum.text();
      return;
    case Datum::Kind::string:
      write_string(out, datum.text());
      return;
    case Datum::Kind::integer:
      out += digits_of(buffer, datum.integer());
      return;
    case Datum::Kind::real: {
      if (char* end = write_decimal(buffer.data(), datum.number())) {
        out.append(buffer.data(), end);
        return;
      }
      const std::string_view digits = digits_of(buffer, datum.number());
      out += digits;
      if (digits.find_first_of(".e") == std::string_view::npos) out += ".0";
      return;
    }
    case Datum::Kind::list:
      break;
  }
  out += '(';
  bool first = true;
  for (const Datum& item : datum.items()) {
    if (!first) out += ' ';
    first = false;
    write_to(out, item);
  }
  out += ')';
}

std::string write(const Datum& datum) {
  std::string out;
  write_to(out, datum);
  return out;
}

}  // namespace pizarra
