#include "lisp/goal.hpp"

#include "lisp/interpret.hpp"

namespace pizarra {

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

Result<std::vector<Datum>> read(const Domain& domain, std::string_view text, std::vector<Datum> objects,
                                const Datum& openness) {
  const Result<Source> source = read_source(text, "goal");
  if (!source) return fail(source);
  for (const TypedName& object : domain.objects) objects.push_back(typed(object.name, object.type));
  const Result<Datum> facts =
      interpret(*source, "goals", {predicates_form(domain), Datum::list(std::move(objects)), openness});
  if (!facts) return fail(facts);
  return std::vector<Datum>(facts->items().begin(), facts->items().end());
}

}  // namespace

Result<std::vector<Datum>> read_goal(const Domain& domain, std::string_view text,
                                     const std::vector<std::pair<std::string, std::string>>& objects_with_types) {
  std::vector<Datum> objects;
  for (const auto& [name, type] : objects_with_types) objects.push_back(typed(name, type));
  return read(domain, text, std::move(objects), "closed"_sym);
}

Result<std::vector<Datum>> check_goal(const Domain& domain, std::string_view text) {
  return read(domain, text, {}, "open"_sym);
}

}  // namespace pizarra
