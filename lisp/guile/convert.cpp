#include "lisp/guile/convert.hpp"

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace pizarra::guile {

namespace {

constexpr int max_depth = 200;
constexpr std::size_t max_elements = 1'000'000;

}  // namespace

SCM to_scheme(const Datum& datum) {
  switch (datum.kind()) {
    case Datum::Kind::symbol:
      return scm_from_utf8_symboln(datum.text().data(), datum.text().size());
    case Datum::Kind::string:
      return scm_from_utf8_stringn(datum.text().data(), datum.text().size());
    case Datum::Kind::integer:
      return scm_from_int64(datum.integer());
    case Datum::Kind::real:
      return scm_from_double(datum.number());
    case Datum::Kind::list:
      break;
  }
  SCM out = SCM_EOL;
  for (std::size_t i = datum.size(); i > 0; --i) out = scm_cons(to_scheme(datum[i - 1]), out);
  return out;
}

bool Builder::refuse(const char* problem) {
  problem_ = problem;
  return false;
}

bool Builder::add(Datum datum) {
  if (++elements_ > max_elements) return refuse("a Scheme procedure returned too much");
  data_.push_back(std::move(datum));
  return true;
}

bool Builder::take(SCM value, int depth) {
  if (depth > max_depth) return refuse("a Scheme procedure returned lists that nest too deep");
  if (scm_is_pair(value) || scm_is_null(value)) return take_list(value, depth);
  if (scm_is_symbol(value)) return take_text(scm_symbol_to_string(value), true);
  if (scm_is_string(value)) return take_text(value, false);
  if (scm_is_signed_integer(value, std::numeric_limits<std::int64_t>::min(),
                            std::numeric_limits<std::int64_t>::max())) {
    const std::int64_t integer = scm_to_int64(value);
    return add(Datum::integer(integer));
  }
  if (scm_is_exact_integer(value)) return refuse("a Scheme procedure returned a whole number that does not fit");
  if (scm_is_real(value)) return take_real(value);
  return refuse("a Scheme procedure returned a value that is no datum");
}

bool Builder::take_list(SCM value, int depth) {
  open_.push_back(data_.size());
  while (scm_is_pair(value)) {
    if (!take(scm_car(value), depth + 1)) return false;
    value = scm_cdr(value);
  }
  if (!scm_is_null(value)) return refuse("a Scheme procedure returned an improper list");
  const auto first = data_.begin() + static_cast<std::ptrdiff_t>(open_.back());
  open_.pop_back();
  std::vector<Datum> items(std::make_move_iterator(first), std::make_move_iterator(data_.end()));
  data_.erase(first, data_.end());
  return add(Datum::list(std::move(items)));
}

bool Builder::take_text(SCM value, bool symbol) {
  std::size_t size = 0;
  char* const characters = scm_to_utf8_stringn(value, &size);
  const std::string_view text(characters, size);
  const bool writable = symbol ? is_symbol_name(text) : is_string_text(text);
  const bool added = writable && add(symbol ? Datum::symbol(text) : Datum::string(text));
  std::free(characters);
  if (!writable) return refuse("a Scheme procedure returned a text that cannot be written");
  return added;
}

bool Builder::take_real(SCM value) {
  const double real = scm_to_double(value);
  if (!std::isfinite(real)) return refuse("a Scheme procedure returned a number that is not finite");
  return add(Datum::real(real));
}

}  // namespace pizarra::guile
