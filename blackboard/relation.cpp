#include "blackboard/relation.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "blackboard/boards_own.hpp"
#include "blackboard/limits.hpp"
#include "lisp/pattern.hpp"
#include "lisp/shortened.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr std::array<std::pair<ArgumentType, std::string_view>, 6> type_names = {{{ArgumentType::symbol, "symbol"},
                                                                                  {ArgumentType::string, "string"},
                                                                                  {ArgumentType::integer, "integer"},
                                                                                  {ArgumentType::number, "number"},
                                                                                  {ArgumentType::list, "list"},
                                                                                  {ArgumentType::datum, "datum"}}};
constexpr std::array<std::string_view, 11> query_words = {"and", "not", "query", "order", "limit", "<",
                                                          "<=",  ">",   ">=",    "=",     "/="};
constexpr std::size_t max_arguments = 32;
constexpr std::int64_t max_lease_ms = 1'000'000'000;

std::string name_of(ArgumentType type) {
  const auto* entry =
      std::find_if(type_names.begin(), type_names.end(), [&](const auto& t) { return t.first == type; });
  return std::string(entry->second);
}

std::unexpected<Failure> malformed(std::string sentence, const Datum& subject) {
  return fail("wrong-shape", std::move(sentence), subject);
}

Result<void> check_name(const Datum& name) {
  if (name.text().size() <= limits::name_bytes) return {};
  return fail("too-large", "the name of a relation or of an argument has at most " +
                               std::to_string(limits::name_bytes) + " bytes, and this one " +
                               std::to_string(name.text().size()));
}

Result<Argument> argument_from_datum(const Datum& form) {
  if (form.size() == 2 && form[0].is_symbol() && form[1].is_symbol() && !is_variable(form[0])) {
    for (const auto& [type, name] : type_names) {
      if (form[1].is_symbol(name)) return Argument{std::string(form[0].text()), type};
    }
  }
  return malformed("an argument is (NAME TYPE) with the type symbol, string, integer, number, list or datum", form);
}

Result<void> read_arguments(const Datum& form, Relation& relation) {
  if (!form.is_list()) return malformed("a relation's arguments are a list", form);
  if (form.size() > max_arguments) {
    return malformed("a relation has at most " + std::to_string(max_arguments) + " arguments", form);
  }
  for (const Datum& item : form.items()) {
    const Result<Argument> argument = argument_from_datum(item);
    if (!argument) return fail(argument);
    const Result<void> named = check_name(item[0]);
    if (!named) return named;
    for (const Argument& other : relation.arguments) {
      if (other.name == argument->name) return malformed("two arguments have the same name", item);
    }
    relation.arguments.push_back(*argument);
  }
  return {};
}

Result<void> read_key(const Datum& form, Relation& relation) {
  relation.key.clear();
  for (const Datum& name : form.items().subspan(1)) {
    const auto argument = std::find_if(relation.arguments.begin(), relation.arguments.end(),
                                       [&](const Argument& a) { return name.is_symbol(a.name); });
    if (argument == relation.arguments.end()) return malformed("the key names an argument that is not there", name);
    relation.key.push_back(static_cast<std::size_t>(argument - relation.arguments.begin()));
  }
  std::sort(relation.key.begin(), relation.key.end());
  if (std::adjacent_find(relation.key.begin(), relation.key.end()) != relation.key.end()) {
    return malformed("the key names an argument twice", form);
  }
  return {};
}

Result<void> read_option(const Datum& form, Relation& relation) {
  if (form.is_form("key")) return read_key(form, relation);
  if (form.is_form("durable") && form.size() == 1) {
    relation.durable = true;
    return {};
  }
  if (form.is_form("lease") && form.size() == 2 && form[1].is_integer()) {
    if (form[1].integer() <= 0 || form[1].integer() > max_lease_ms) {
      return malformed("a relation's lease is from 1 to 1000000000 ms", form);
    }
    relation.lease = std::chrono::milliseconds(form[1].integer());
    return {};
  }
  return malformed("a relation's options are (key ARGUMENT ...), (durable) and (lease MS)", form);
}

// Enough of a value to recognise it.
std::string brief(const Datum& value) { return shortened(write(value), 60); }

}  // namespace

Result<Relation> relation_from_datum(const Datum& form) {
  if (!form.is_form("relation") || form.size() < 3 || !form[1].is_symbol()) {
    return malformed("a relation is (relation NAME ((ARGUMENT TYPE) ...) OPTION ...)", form);
  }
  Result<void> read = check_name(form[1]);
  if (!read) return fail(read);
  Relation relation;
  relation.name = form[1].text();
  if (is_variable(form[1])) return malformed("a relation's name begins with a question mark", form[1]);
  if (std::ranges::find(query_words, relation.name) != query_words.end()) {
    return malformed("a relation has a name that queries use", form[1]);
  }
  if (is_made_up(relation.name)) return fail(left_to_the_board(relation.name));
  read = read_arguments(form[2], relation);
  if (!read) return fail(read);
  relation.key.resize(relation.arguments.size());
  std::iota(relation.key.begin(), relation.key.end(), 0);
  for (const Datum& option : form.items().subspan(3)) {
    read = read_option(option, relation);
    if (!read) return fail(read);
  }
  return relation;
}

Datum relation_to_datum(const Relation& relation) {
  std::vector<Datum> arguments;
  for (const Argument& argument : relation.arguments) {
    arguments.push_back(list(Datum::symbol(argument.name), Datum::symbol(name_of(argument.type))));
  }
  std::vector<Datum> key = {"key"_sym};
  for (const std::size_t position : relation.key) key.push_back(Datum::symbol(relation.arguments[position].name));
  std::vector<Datum> form = {"relation"_sym, Datum::symbol(relation.name), Datum::list(std::move(arguments)),
                             Datum::list(std::move(key))};
  if (relation.durable) form.push_back(list("durable"_sym));
  if (relation.lease) {
    form.push_back(list("lease"_sym, std::chrono::duration_cast<std::chrono::milliseconds>(*relation.lease).count()));
  }
  return Datum::list(std::move(form));
}

bool fits_type(ArgumentType type, const Datum& value) {
  switch (type) {
    case ArgumentType::symbol:
      return value.is_symbol();
    case ArgumentType::string:
      return value.is_string();
    case ArgumentType::integer:
      return value.is_integer();
    case ArgumentType::number:
      return value.is_number();
    case ArgumentType::list:
      return value.is_list();
    case ArgumentType::datum:
      return true;
  }
  return false;
}

namespace {

// "2 arguments (direction mm)"
std::string counted_arguments(const Relation& relation) {
  const std::size_t count = relation.arguments.size();
  std::string out = std::to_string(count) + (count == 1 ? " argument" : " arguments");
  for (std::size_t i = 0; i < count; ++i) out += (i == 0 ? " (" : " ") + relation.arguments[i].name;
  return count == 0 ? out : out + ")";
}

}  // namespace

Result<void> check_pattern_shape(const Relation& relation, const Datum& pattern) {
  if (!pattern.is_form(relation.name)) return malformed("not a fact of the relation " + relation.name, pattern);
  if (pattern.size() != relation.arguments.size() + 1) {
    return malformed(
        relation.name + " has " + counted_arguments(relation) + ", not " + std::to_string(pattern.size() - 1), pattern);
  }
  for (std::size_t i = 0; i < relation.arguments.size(); ++i) {
    const Argument& argument = relation.arguments[i];
    if (!is_variable(pattern[i + 1]) && !fits_type(argument.type, pattern[i + 1])) {
      const std::string article = argument.type == ArgumentType::integer ? " is an " : " is a ";
      return malformed("argument " + argument.name + " of " + relation.name + article + name_of(argument.type) +
                           ", which " + brief(pattern[i + 1]) + " is not",
                       pattern);
    }
  }
  return {};
}

namespace {

bool has_shape(const Relation& relation, const Datum& fact) {
  if (fact.size() != relation.arguments.size() + 1 || fact.head() != relation.name) return false;
  auto value = fact.items().begin();
  return std::ranges::all_of(relation.arguments, [&](const Argument& argument) {
    ++value;
    return fits_type(argument.type, *value) && is_ground(*value);
  });
}

}  // namespace

// What is wrong is looked for where something is.
Result<void> check_shape(const Relation& relation, const Datum& fact) {
  if (has_shape(relation, fact)) return {};
  Result<void> shaped = check_pattern_shape(relation, fact);
  if (!shaped) return shaped;
  for (std::size_t i = 0; i < relation.arguments.size(); ++i) {
    if (is_ground(fact[i + 1])) continue;
    const std::string& argument = relation.arguments[i].name;
    return malformed("argument " + argument + " of " + relation.name + " holds a variable, and facts hold none", fact);
  }
  return {};
}

Datum key_of(const Relation& relation, const Datum& fact) {
  std::vector<Datum> key;
  key.reserve(relation.key.size() + 1);
  key.push_back(fact[0]);
  for (const std::size_t position : relation.key) key.push_back(fact[position + 1]);
  return Datum::list(std::move(key));
}

}  // namespace pizarra
