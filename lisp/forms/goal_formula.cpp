#include "lisp/forms/goal_formula.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "lisp/pattern.hpp"

namespace pizarra::forms {

namespace {

using Way = std::set<Datum>;
using Ways = std::vector<Way>;
using Names = std::map<std::string, Datum, std::less<>>;  // of variables

bool is_quantifier(const Datum& form) {
  return form.is_form("forall") || form.is_form("exists") || form.is_form("at-least");
}

Datum named(const Datum& form, const Names& names) {
  if (form.is_symbol()) {
    const auto found = names.find(form.text());
    return found == names.end() ? form : found->second;
  }
  if (!form.is_list()) return form;
  std::vector<Datum> items;
  for (const Datum& item : form.items()) items.push_back(named(item, names));
  return Datum::list(std::move(items));
}

// A quantified form once for each object of its type: the form with the object's name in place of the variable.
std::vector<Datum> instances(const Datum& form, const TypedObjects& objects) {
  const std::size_t at = form.is_form("at-least") ? 2 : 1;
  const Datum& variable = form[at];
  std::vector<Datum> out;
  for (const auto& [name, type] : objects) {
    if (!variable[1].is_symbol(type)) continue;
    out.push_back(named(form[at + 1], {{std::string(variable[0].text()), Datum::symbol(name)}}));
  }
  return out;
}

bool contradicts_itself(const Way& way) {
  return std::ranges::any_of(way,
                             [&](const Datum& literal) { return literal.is_form("not") && way.contains(literal[1]); });
}

// A way that asks for more than another one is dropped.
Ways shortest(Ways ways) {
  std::ranges::sort(ways,
                    [](const Way& a, const Way& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; });
  Ways out;
  for (Way& way : ways) {
    const bool more = std::ranges::any_of(out, [&](const Way& less) { return std::ranges::includes(way, less); });
    if (!more) out.push_back(std::move(way));
  }
  return out;
}

std::unexpected<Failure> too_many() {
  return fail("too-many", fmt::format("the goal can be reached in more than {} ways: name fewer objects, or smaller "
                                      "numbers of them",
                                      most_ways));
}

class Expansion {
 public:
  explicit Expansion(const TypedObjects& objects) : objects_(objects) {}
  Result<Ways> ways(const Datum& form, bool wanted) const;
  Result<Ways> all_of(std::span<const Datum> forms, bool wanted) const;

 private:
  Result<Ways> any_of(std::span<const Datum> forms, bool wanted) const;
  Result<Ways> at_least(std::int64_t count, std::span<const Datum> forms, bool wanted) const;
  Result<Ways> counted(const Datum& form, bool wanted) const;

  const TypedObjects& objects_;
};

Result<Ways> Expansion::all_of(std::span<const Datum> forms, bool wanted) const {
  Ways joined{Way()};
  for (const Datum& form : forms) {
    const Result<Ways> more = ways(form, wanted);
    if (!more) return more;
    Ways next;
    for (const Way& before : joined) {
      for (const Way& way : *more) {
        Way both = before;
        both.insert(way.begin(), way.end());
        if (!contradicts_itself(both)) next.push_back(std::move(both));
        if (next.size() > most_ways * most_ways) return too_many();
      }
    }
    joined = shortest(std::move(next));
    if (joined.size() > most_ways) return too_many();
  }
  return joined;
}

Result<Ways> Expansion::any_of(std::span<const Datum> forms, bool wanted) const {
  Ways out;
  for (const Datum& form : forms) {
    Result<Ways> more = ways(form, wanted);
    if (!more) return more;
    std::ranges::move(*more, std::back_inserter(out));
    if (out.size() > most_ways * most_ways) return too_many();
  }
  out = shortest(std::move(out));
  if (out.size() > most_ways) return too_many();
  return out;
}

// With the first of the forms one fewer of the others, or as many of the others without it.
Result<Ways> Expansion::at_least(std::int64_t count, std::span<const Datum> forms, bool wanted) const {
  if (count <= 0) return Ways{Way()};
  if (static_cast<std::size_t>(count) > forms.size()) return Ways();
  if (static_cast<std::size_t>(count) == forms.size()) return all_of(forms, wanted);
  const Result<Ways> first = ways(forms.front(), wanted);
  if (!first) return first;
  const Result<Ways> rest = at_least(count - 1, forms.subspan(1), wanted);
  if (!rest) return rest;
  Result<Ways> without = at_least(count, forms.subspan(1), wanted);
  if (!without) return without;
  Ways out = std::move(*without);
  for (const Way& one : *first) {
    for (const Way& others : *rest) {
      Way both = one;
      both.insert(others.begin(), others.end());
      if (!contradicts_itself(both)) out.push_back(std::move(both));
      if (out.size() > most_ways * most_ways) return too_many();
    }
  }
  out = shortest(std::move(out));
  if (out.size() > most_ways) return too_many();
  return out;
}

Result<Ways> Expansion::counted(const Datum& form, bool wanted) const {
  const std::vector<Datum> each = instances(form, objects_);
  if (form.is_form("at-least")) {
    const std::int64_t count = form[1].integer();
    // That not as many are so means that so many of the others are not.
    const auto number = static_cast<std::int64_t>(each.size());
    return wanted ? at_least(count, each, true) : at_least(number - count + 1, each, false);
  }
  return form.is_form("forall") == wanted ? all_of(each, wanted) : any_of(each, wanted);
}

Result<Ways> Expansion::ways(const Datum& form, bool wanted) const {
  if (form.is_form("not")) return ways(form[1], !wanted);
  if (form.is_form("and") || form.is_form("or")) {
    const auto parts = form.items().subspan(1);
    return form.is_form("and") == wanted ? all_of(parts, wanted) : any_of(parts, wanted);
  }
  if (is_quantifier(form)) return counted(form, wanted);
  if (form.is_form("=")) return (form[1] == form[2]) == wanted ? Ways{Way()} : Ways();
  return Ways{Way{wanted ? form : list("not"_sym, form)}};
}

bool holds(const Datum& form, const std::set<Datum>& facts, const TypedObjects& objects) {
  const auto is_so = [&](const Datum& part) { return holds(part, facts, objects); };
  if (form.is_form("not")) return !is_so(form[1]);
  if (form.is_form("and")) return std::ranges::all_of(form.items().subspan(1), is_so);
  if (form.is_form("or")) return std::ranges::any_of(form.items().subspan(1), is_so);
  if (form.is_form("=")) return form[1] == form[2];
  if (!is_quantifier(form)) return facts.contains(form);
  const std::vector<Datum> each = instances(form, objects);
  if (form.is_form("forall")) return std::ranges::all_of(each, is_so);
  const std::int64_t wanted = form.is_form("exists") ? 1 : form[1].integer();
  return std::ranges::count_if(each, is_so) >= wanted;
}

bool is_name_of_variable(const Datum& name) {
  const std::string_view text = name.text();
  return text.size() > 2 && text.front() == '<' && text.back() == '>';
}

void collect_objects(const Datum& form, std::vector<std::string>& names) {
  const bool joins = form.is_form("and") || form.is_form("or") || form.is_form("not");
  if (joins || is_quantifier(form)) {
    const std::size_t first = joins ? 1 : form.is_form("at-least") ? 3 : 2;
    for (const Datum& part : form.items().subspan(first)) collect_objects(part, names);
    return;
  }
  for (const Datum& argument : form.items().subspan(1)) {
    if (!argument.is_symbol() || is_name_of_variable(argument)) continue;
    const std::string name(argument.text());
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
}

Quantified quantified_in(const Datum& form, bool wanted, std::string_view type) {
  if (form.is_form("not")) return quantified_in(form[1], !wanted, type);
  const bool joins = form.is_form("and") || form.is_form("or");
  if (!joins && !is_quantifier(form)) return Quantified::none;
  const std::size_t variable = form.is_form("at-least") ? 2 : 1;
  Quantified most = Quantified::none;
  const bool of_type = !joins && form[variable][1].is_symbol(type);
  if (of_type) most = form.is_form("forall") == wanted ? Quantified::all : Quantified::some;
  for (const Datum& part : form.items().subspan(joins ? 1 : variable + 1)) {
    most = std::max(most, quantified_in(part, wanted, type));
  }
  return most;
}

}  // namespace

bool literal_holds(const Datum& literal, const std::set<Datum>& facts) {
  return literal.is_form("not") ? !facts.contains(literal[1]) : facts.contains(literal);
}

Result<std::vector<GoalLiterals>> goal_alternatives(const std::vector<Datum>& goal, const TypedObjects& objects) {
  const Result<Ways> ways = Expansion(objects).all_of(goal, true);
  if (!ways) return fail(ways);
  std::vector<GoalLiterals> out;
  for (const Way& way : *ways) {
    // A goal of facts alone stays in its order.
    GoalLiterals literals;
    for (const Datum& form : goal) {
      if (way.contains(form)) literals.push_back(form);
    }
    for (const Datum& literal : way) {
      if (std::ranges::find(literals, literal) == literals.end()) literals.push_back(literal);
    }
    out.push_back(std::move(literals));
  }
  return out;
}

bool goal_holds(const std::vector<Datum>& goal, const std::set<Datum>& facts, const TypedObjects& objects) {
  return unmet_parts(goal, facts, objects).empty();
}

std::vector<Datum> unmet_parts(const std::vector<Datum>& goal, const std::set<Datum>& facts,
                               const TypedObjects& objects) {
  std::vector<Datum> unmet;
  for (const Datum& form : goal) {
    if (!holds(form, facts, objects)) unmet.push_back(form);
  }
  return unmet;
}

std::optional<TooFewObjects> too_few_objects(const std::vector<Datum>& goal, const TypedObjects& objects) {
  for (const Datum& form : goal) {
    if (form.is_form("and") || form.is_form("or")) {
      const auto parts = form.items().subspan(1);
      std::optional<TooFewObjects> within = too_few_objects({parts.begin(), parts.end()}, objects);
      if (within) return within;
    }
    const bool counts = form.is_form("at-least") || form.is_form("exists");
    if (!counts) continue;
    const std::int64_t wanted = form.is_form("exists") ? 1 : form[1].integer();
    const std::size_t there = instances(form, objects).size();
    if (wanted <= static_cast<std::int64_t>(there)) continue;
    const Datum& variable = form[form.is_form("exists") ? 1 : 2];
    return TooFewObjects{form, std::string(variable[1].text()), static_cast<std::size_t>(wanted), there};
  }
  return std::nullopt;
}

std::vector<std::string> objects_in(const std::vector<Datum>& goal) {
  std::vector<std::string> names;
  for (const Datum& form : goal) collect_objects(form, names);
  return names;
}

Quantified quantified_over(const std::vector<Datum>& goal, std::string_view type) {
  Quantified most = Quantified::none;
  for (const Datum& form : goal) most = std::max(most, quantified_in(form, true, type));
  return most;
}

Datum without_variables(const Datum& form) {
  if (is_variable(form) && form.text().size() > 1) return Datum::symbol(fmt::format("<{}>", form.text().substr(1)));
  if (!form.is_list()) return form;
  std::vector<Datum> items;
  for (const Datum& item : form.items()) items.push_back(without_variables(item));
  return Datum::list(std::move(items));
}

}  // namespace pizarra::forms
