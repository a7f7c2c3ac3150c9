#include "lisp/forms/goal.hpp"

#include <algorithm>
#include <cctype>

#include "lisp/guile/scheme.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::forms {

namespace {

Datum typed(const std::string& name, const std::string& type) { return list(Datum::symbol(name), Datum::symbol(type)); }

Datum predicates_form(const Domain& domain) {
  std::vector<Datum> out;
  for (const Predicate& predicate : domain.predicates) {
    std::vector<Datum> items{Datum::symbol(predicate.name)};
    for (const TypedName& argument : predicate.arguments) items.push_back(typed(argument.name, argument.type));
    out.push_back(Datum::list(std::move(items)));
  }
  return Datum::list(std::move(out));
}

// As goals are read: a string names an object as a symbol does, and case does not count.
bool same(const Datum& a, const Datum& b) {
  if (a.is_list() && b.is_list()) return std::ranges::equal(a.items(), b.items(), same);
  const auto is_name = [](const Datum& datum) { return datum.is_symbol() || datum.is_string(); };
  if (!is_name(a) || !is_name(b)) return a == b;
  const auto lower = [](unsigned char letter) { return std::tolower(letter); };
  return std::ranges::equal(a.text(), b.text(), {}, lower, lower);
}

// A variable as people type it: ?x of <x>, which requests have in its place.
Datum as_typed(const Datum& form) {
  if (form.is_list()) {
    std::vector<Datum> items;
    for (const Datum& item : form.items()) items.push_back(as_typed(item));
    return Datum::list(std::move(items));
  }
  const std::string_view name = form.is_symbol() ? form.text() : std::string_view();
  const bool is_angled = name.size() > 2 && name.front() == '<' && name.back() == '>';
  return is_angled ? Datum::symbol("?" + std::string(name.substr(1, name.size() - 2))) : form;
}

// The way to the first element that is the subject or one of it; empty where there is none.
std::vector<std::size_t> path_to(const Datum& subject, std::span<const Datum> items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto is_this = [&](const Datum& named) { return same(named, items[i]); };
    if (is_this(subject) || std::ranges::any_of(subject.items(), is_this)) return {i};
    std::vector<std::size_t> path = path_to(subject, items[i].items());
    if (path.empty()) continue;
    path.insert(path.begin(), i);
    return path;
  }
  return {};
}

// What goals are understood by; openness is `closed` where no other objects exist, or `open`.
std::vector<Datum> known(const Domain& domain, const std::vector<std::pair<std::string, std::string>>& seen,
                         const Datum& openness) {
  std::vector<Datum> objects;
  for (const auto& [name, type] : seen) objects.push_back(typed(name, type));
  for (const TypedName& object : domain.objects) objects.push_back(typed(object.name, object.type));
  return {predicates_form(domain), Datum::list(std::move(objects)), openness};
}

Result<std::vector<Datum>> facts_of(const Result<Datum>& facts) {
  if (!facts) return fail(facts);
  return std::vector<Datum>(facts->items().begin(), facts->items().end());
}

}  // namespace

Result<std::vector<Datum>> read_goal(const Domain& domain, std::string_view text,
                                     const std::vector<std::pair<std::string, std::string>>& objects_with_types) {
  const Result<Source> source = read_source(text, "goal");
  if (!source) return fail(source);
  return facts_of(guile::interpret(*source, "goals", known(domain, objects_with_types, "closed"_sym)));
}

Result<std::vector<Datum>> goal_from_data(const Domain& domain, const std::vector<Datum>& facts,
                                          const std::vector<std::pair<std::string, std::string>>& objects_with_types) {
  Result<std::vector<Datum>> goal =
      facts_of(guile::interpret_data(facts, "goals", known(domain, objects_with_types, "closed"_sym)));
  if (goal) return goal;
  // A fault is shown at its place in a text.
  std::string text;
  for (const Datum& fact : facts) text += write(as_typed(fact)) + '\n';
  goal = read_goal(domain, text, objects_with_types);
  // The failure crosses the board, which holds no ?x. Its place shows the form.
  const bool names_variable = !goal && !is_ground(goal.error().subject);
  if (names_variable) goal.error().subject = Datum();
  return goal;
}

Result<std::vector<Datum>> check_goal(const Domain& domain, std::string_view text) {
  const Result<Source> source = read_source(text, "goal");
  if (!source) return fail(source);
  return facts_of(guile::interpret(*source, "goals", known(domain, {}, "open"_sym)));
}

Failure at_its_goal(Failure refusal, std::string_view text) {
  const Result<Source> source = read_source(text, "goal");
  if (!source || !refusal.place.empty()) return refusal;
  const std::vector<std::size_t> path = path_to(refusal.subject, source->data());
  if (path.empty() && refusal.symbol != "no-plan") return refusal;
  refusal.place = source->failure_at(path, {}, {}).place;
  return refusal;
}

}  // namespace pizarra::forms
