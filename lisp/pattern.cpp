#include "lisp/pattern.hpp"

#include <algorithm>
#include <utility>

namespace pizarra {

bool is_variable(const Datum& datum) { return datum.is_symbol() && datum.text().starts_with('?'); }

bool is_ground(const Datum& datum) {
  return datum.is_list() ? std::ranges::all_of(datum.items(), is_ground) : !is_variable(datum);
}

const Datum* Bindings::find(std::string_view variable) const {
  const auto found = values_.find(variable);
  return found == values_.end() ? nullptr : &found->second;
}

bool Bindings::bind(std::string_view variable, const Datum& value) {
  const auto found = values_.lower_bound(variable);
  if (found != values_.end() && found->first == variable) return found->second == value;
  values_.emplace_hint(found, variable, value);
  return true;
}

namespace {

// Variables bound by the match in hand, kept apart until all of it fits.
using Fresh = std::vector<std::pair<std::string_view, const Datum*>>;

bool fits(const Datum& pattern, const Datum& datum, const Bindings& bindings, Fresh& fresh) {
  if (is_variable(pattern)) {
    const std::string_view name = pattern.text();
    if (name.size() == 1) return true;
    if (const Datum* bound = bindings.find(name)) return *bound == datum;
    const auto found = std::ranges::find(fresh, name, &Fresh::value_type::first);
    if (found != fresh.end()) return *found->second == datum;
    fresh.emplace_back(name, &datum);
    return true;
  }
  if (!pattern.is_list()) return pattern == datum;
  if (!datum.is_list() || pattern.size() != datum.size()) return false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (!fits(pattern[i], datum[i], bindings, fresh)) return false;
  }
  return true;
}

}  // namespace

bool match(const Datum& pattern, const Datum& datum, Bindings& bindings) {
  Fresh fresh;
  if (!fits(pattern, datum, bindings, fresh)) return false;
  for (const auto& [name, value] : fresh) bindings.bind(name, *value);
  return true;
}

Datum substitute(const Datum& pattern, const Bindings& bindings) {
  if (is_variable(pattern)) {
    const Datum* bound = bindings.find(pattern.text());
    return bound ? *bound : pattern;
  }
  if (!pattern.is_list() || is_ground(pattern)) return pattern;
  std::vector<Datum> items;
  items.reserve(pattern.size());
  for (const Datum& item : pattern.items()) items.push_back(substitute(item, bindings));
  return Datum::list(std::move(items));
}

}  // namespace pizarra
