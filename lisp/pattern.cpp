#include "lisp/pattern.hpp"

#include <algorithm>

#include "lisp/elements_looked_at.hpp"

namespace pizarra {

bool is_variable(const Datum& datum) { return datum.is_symbol() && datum.text().starts_with('?'); }

bool is_ground(const Datum& datum) {
  elements_looked_at += datum.size();
  return datum.is_list() ? std::ranges::all_of(datum.items(), is_ground) : !is_variable(datum);
}

const Datum* Bindings::find(std::string_view variable) const {
  const auto found = std::ranges::find_if(values_, [&](const Binding& b) { return b.variable.text() == variable; });
  return found == values_.end() ? nullptr : &found->value;
}

const Datum* Bindings::find(const Datum& variable) const {
  const auto found = std::ranges::find(values_, variable, &Binding::variable);
  return found == values_.end() ? nullptr : &found->value;
}

bool Bindings::bind(const Datum& variable, const Datum& value) {
  if (const Datum* bound = find(variable)) return *bound == value;
  const auto place = std::ranges::lower_bound(values_, variable, {}, &Binding::variable);
  values_.insert(place, {variable, value});
  return true;
}

// New variables are put at the end; match() puts them where they belong, or takes them away.
bool Bindings::extend(const Datum& pattern, const Datum& datum) {
  if (is_variable(pattern)) {
    if (pattern.text().size() == 1) return true;
    if (const Datum* bound = find(pattern)) return *bound == datum;
    if (values_.capacity() == 0) values_.reserve(4);
    values_.push_back({pattern, datum});
    return true;
  }
  if (!pattern.is_list()) return pattern == datum;
  const std::span<const Datum> wanted = pattern.items();
  const std::span<const Datum> given = datum.items();
  if (!datum.is_list() || wanted.size() != given.size()) return false;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    ++elements_looked_at;
    if (!extend(wanted[i], given[i])) return false;
  }
  return true;
}

bool match(const Datum& pattern, const Datum& datum, Bindings& bindings) {
  std::vector<Bindings::Binding>& values = bindings.values_;
  const std::size_t before = values.size();
  if (!bindings.extend(pattern, datum)) {
    values.resize(before);
    return false;
  }
  for (std::size_t i = std::max<std::size_t>(before, 1); i < values.size(); ++i) {
    std::size_t place = i;
    while (place > 0 && values[i].variable < values[place - 1].variable) --place;
    if (place == i) continue;
    const auto begin = values.begin();
    Bindings::Binding moved = std::move(values[i]);
    std::move_backward(begin + static_cast<std::ptrdiff_t>(place), begin + static_cast<std::ptrdiff_t>(i),
                       begin + static_cast<std::ptrdiff_t>(i) + 1);
    values[place] = std::move(moved);
  }
  return true;
}

std::optional<FlatPattern> FlatPattern::of(const Datum& pattern) {
  if (!pattern.is_list()) return std::nullopt;
  FlatPattern flat;
  flat.size_ = pattern.size();
  for (std::size_t place = 0; place < pattern.size(); ++place) {
    const Datum& element = pattern[place];
    if (!is_variable(element) && !is_ground(element)) return std::nullopt;
    if (is_variable(element) && element.text().size() == 1) continue;
    (is_variable(element) ? flat.variables_ : flat.ground_).push_back({element, place});
  }
  std::ranges::sort(flat.variables_, {}, &Element::datum);
  const bool twice = std::ranges::adjacent_find(flat.variables_, {}, &Element::datum) != flat.variables_.end();
  return twice ? std::nullopt : std::optional(std::move(flat));
}

std::optional<Bindings> FlatPattern::match(const Datum& datum) const {
  const std::span<const Datum> items = datum.items();
  if (!datum.is_list() || items.size() != size_) return std::nullopt;
  elements_looked_at += size_;
  for (const Element& element : ground_) {
    if (element.datum != items[element.place]) return std::nullopt;
  }
  std::optional<Bindings> bindings(std::in_place);
  bindings->values_.reserve(variables_.size());
  for (const Element& element : variables_) bindings->values_.push_back({element.datum, items[element.place]});
  return bindings;
}

bool resembles(const Datum& pattern, const Datum& datum) {
  if (is_variable(pattern)) return true;
  if (!pattern.is_list()) return pattern == datum;
  return datum.is_list() && std::ranges::equal(pattern.items(), datum.items(), resembles);
}

Datum substitute(const Datum& pattern, const Bindings& bindings) {
  if (is_variable(pattern)) {
    const Datum* bound = bindings.find(pattern);
    return bound ? *bound : pattern;
  }
  if (!pattern.is_list() || is_ground(pattern)) return pattern;
  std::vector<Datum> items;
  items.reserve(pattern.size());
  for (const Datum& item : pattern.items()) items.push_back(substitute(item, bindings));
  return Datum::list(std::move(items));
}

}  // namespace pizarra
