#include "agents/runtime/contract.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/nearest.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::runtime {

namespace {

// An operation's arguments are declared as a relation's are, so the same code reads and checks them.
Result<Operation> operation_from_datum(const Datum& form) {
  if (form.head().empty()) return fail("bad-contract", "an operation is (NAME (ARGUMENT TYPE) ...)", form);
  std::vector<Datum> arguments(form.items().begin() + 1, form.items().end());
  const bool repeats = !arguments.empty() && arguments.back().is_symbol("...");
  if (repeats) arguments.pop_back();
  if (repeats && arguments.empty()) return fail("bad-contract", "`...` repeats the argument before it", form);
  const Result<Relation> shape = relation_from_datum(list("relation"_sym, form[0], Datum::list(std::move(arguments))));
  if (!shape) return fail(shape);
  return Operation{shape->name, shape->arguments, repeats};
}

// The part as the board shows it.
Result<Datum> read_part(Contract& contract, const Datum& part) {
  std::vector<Datum> shown{part[0]};
  for (const Datum& item : part.items().subspan(1)) {
    shown.push_back(item);
    if (part.is_form("offers")) {
      Result<Operation> operation = operation_from_datum(item);
      if (!operation) return fail(operation);
      contract.offers.push_back(std::move(*operation));
    } else if (part.is_form("posts") && !item.is_symbol()) {
      Result<Relation> relation = relation_from_datum(item);
      if (!relation) return fail(relation);
      contract.posts.push_back(std::move(*relation));
    } else if (part.is_form("reads") && !item.is_symbol()) {
      Result<Relation> relation = relation_from_datum(item);
      if (!relation) return fail(relation);
      shown.back() = Datum::symbol(relation->name);
      contract.reads.push_back(std::move(*relation));
    }
  }
  return Datum::list(std::move(shown));
}

Result<void> check_arguments(const Operation& offered, const Datum& operation) {
  Relation shape{.name = offered.name, .arguments = offered.arguments, .key = {}, .durable = false, .lease = {}};
  if (offered.repeats) {
    const Argument repeated = shape.arguments.back();
    shape.arguments.pop_back();
    if (operation.size() > shape.arguments.size() + 1) shape.arguments.resize(operation.size() - 1, repeated);
  }
  return check_shape(shape, operation);
}

}  // namespace

Result<Contract> contract_from_text(std::string_view text) {
  const Result<Datum> form = read_one(text, {}, "contract");
  if (!form) return fail(form);
  if (!form->is_form("contract") || form->size() < 2 || !(*form)[1].is_symbol()) {
    return fail("bad-contract", "a contract is (contract KIND PART ...)", *form);
  }
  Contract contract{
      .kind = std::string((*form)[1].text()), .offers = {}, .posts = {}, .reads = {}, .context = {}, .form = {}};
  std::vector<Datum> shown{(*form)[0], (*form)[1]};
  constexpr std::string_view parts[] = {"offers", "posts", "reads", "takes", "configures", "monitors"};
  for (const Datum& part : form->items().subspan(2)) {
    if (std::ranges::find(parts, part.head()) == std::end(parts)) {
      return fail("bad-contract", "a part is offers, posts, reads, takes, configures or monitors", part);
    }
    Result<Datum> read = read_part(contract, part);
    if (!read) return fail(read);
    shown.push_back(std::move(*read));
  }
  contract.form = Datum::list(std::move(shown));
  return contract;
}

Result<void> check_operation(const Contract& contract, const Datum& operation) {
  Result<void> checked = fail("unknown-operation", "");
  for (const Operation& offered : contract.offers) {
    if (offered.name != operation.head()) continue;
    Result<void> fits = check_arguments(offered, operation);
    if (fits) return fits;
    // Of several shapes the first one is told of.
    if (checked.error().symbol == "unknown-operation") checked = std::move(fits);
  }
  if (checked.error().symbol != "unknown-operation") return checked;
  std::vector<std::string> names;
  for (const Operation& known : contract.offers) names.push_back(known.name);
  const std::string nearest = nearest_name(operation.head(), names);
  return fail("unknown-operation",
              fmt::format("{} does not offer {}{}", contract.kind, write(operation),
                          nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
              operation);
}

std::vector<Relation> runtime_relations() {
  constexpr std::string_view forms[] = {
      "(relation agent ((name symbol) (kind symbol) (host string)) (key name))",
      "(relation contract ((name symbol) (form datum)) (key name))",
      "(relation request ((id symbol) (agent symbol) (operation datum)) (key id))",
      // A caller that died leaves its replies; they go by themselves.
      "(relation reply ((id symbol) (result datum)) (key id) (lease 60000))",
  };
  std::vector<Relation> relations;
  for (const std::string_view form : forms) relations.push_back(relation_from_datum(read_one(form).value()).value());
  return relations;
}

}  // namespace pizarra::runtime
