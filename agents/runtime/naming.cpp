#include "agents/runtime/naming.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lisp/nearest.hpp"
#include "lisp/plain_name.hpp"
#include "lisp/reader.hpp"

namespace pizarra::runtime {

namespace {

constexpr Duration binding_look = 500ms;
const Datum any = "?"_sym;

Result<void> check(const Path& path, const Reference* reference = nullptr) {
  const bool plain = !path.empty() && path.size() <= Naming::max_depth && std::ranges::all_of(path, is_plain_name);
  if (!plain) {
    return fail("bad-name",
                fmt::format("a path has 1 to {} names of letters, digits and dashes, a letter first, {} at most",
                            Naming::max_depth, longest_plain_name),
                is_string_text(path_text(path)) ? to_datum(path_text(path)) : Datum());
  }
  const bool whole = reference == nullptr || (is_plain_name(reference->kind) && is_plain_name(reference->agent));
  if (!whole) return fail("bad-name", "a binding needs an agent and its kind", to_datum(path_text(path)));
  return {};
}

Datum path_datum(std::span<const std::string> path) {
  std::vector<Datum> names;
  for (const std::string& name : path) names.push_back(Datum::symbol(name));
  return Datum::list(std::move(names));
}

Datum parent_of(const Path& path) { return path_datum(std::span(path).first(path.size() - 1)); }
Datum name_of(const Path& path) { return Datum::symbol(path.back()); }

Datum context_form(const Path& path) { return list("context"_sym, parent_of(path), name_of(path)); }
Datum bound_form(const Path& path, Datum kind, Datum agent) {
  return list("bound"_sym, parent_of(path), name_of(path), std::move(kind), std::move(agent));
}
Datum agent_form(const Reference& reference) {
  return list("agent"_sym, Datum::symbol(reference.agent), Datum::symbol(reference.kind), any);
}

void require_parent(Transaction& transaction, const Path& path) {
  if (path.size() == 1) return;
  const Path parent(path.begin(), path.end() - 1);
  transaction.require(Transaction::Present{context_form(parent)});
}

// Says which precondition did not hold.
std::unexpected<Failure> explain(const Failure& failure, const Path& path, const Reference& reference) {
  const std::string text = path_text(path);
  if (failure.symbol != "precondition-failed") return fail(failure);
  if (failure.subject.is_form("agent")) {
    return fail("absent", fmt::format("no agent {} of kind {} is present", reference.agent, reference.kind),
                Datum::symbol(reference.agent));
  }
  const bool missing = failure.subject.is_form("context") && failure.subject != context_form(path);
  if (missing) return fail("no-context", "there is no context for " + text, failure.subject);
  return fail("already-bound", text + " is taken", failure.subject);
}

NamedEntry entry_of(const Datum& fact) {
  NamedEntry entry;
  for (const Datum& name : fact[1].items()) entry.path.emplace_back(name.text());
  entry.path.emplace_back(fact[2].text());
  if (fact.is_form("bound")) entry.reference = Reference{std::string(fact[3].text()), std::string(fact[4].text())};
  return entry;
}

Listing listing_of(const std::vector<Fact>& facts) {
  Listing listing;
  for (const Fact& fact : facts) listing.entries.push_back(entry_of(fact.datum));
  std::ranges::sort(listing.entries, {},
                    [](const NamedEntry& e) { return std::pair(e.reference.has_value(), e.path); });
  listing.cut = listing.entries.size() > Naming::max_listed;
  if (listing.cut) listing.entries.resize(Naming::max_listed);
  return listing;
}

}  // namespace

std::vector<Relation> naming_relations() {
  constexpr std::string_view forms[] = {
      "(relation context ((parent list) (name symbol)) (key parent name) (durable))",
      "(relation bound ((parent list) (name symbol) (kind symbol) (agent symbol)) (key parent name))",
  };
  std::vector<Relation> relations;
  for (const std::string_view form : forms) relations.push_back(relation_from_datum(read_one(form).value()).value());
  return relations;
}

std::string path_text(const Path& path) { return fmt::format("{}", fmt::join(path, "/")); }

Task<Result<void>> Naming::declare() {
  const std::vector<Relation> relations = naming_relations();
  co_return co_await context_.board.declare(relations);
}

Task<Result<void>> Naming::make_context(Path path) {
  const Result<void> plain = check(path);
  if (!plain) co_return plain;
  Transaction transaction;
  for (std::size_t depth = 1; depth <= path.size(); ++depth) {
    const Path branch(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(depth));
    transaction.require(Transaction::Absent{bound_form(branch, any, any)});
    transaction.tell(context_form(branch));
  }
  const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
  if (!told) co_return explain(told.error(), path, Reference());
  co_return Result<void>();
}

Task<Result<void>> Naming::put(Path path, Reference reference, bool replace) {
  const Result<void> plain = check(path, &reference);
  if (!plain) co_return plain;
  const Datum fact = bound_form(path, Datum::symbol(reference.kind), Datum::symbol(reference.agent));
  Transaction transaction;
  require_parent(transaction, path);
  transaction.require(Transaction::Present{agent_form(reference)});
  transaction.require(Transaction::Absent{context_form(path)});
  const bool ours = bound_.contains(path) && bound_.at(path) == reference;
  const bool vacant = !replace && !ours;
  if (vacant) transaction.require(Transaction::Absent{bound_form(path, any, any)});
  transaction.tell(fact, {}, service_.presence());
  const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
  if (!told) co_return explain(told.error(), path, reference);
  bound_[path] = reference;
  const bool kept = told_under_ != 0;
  if (!kept) {
    told_under_ = service_.presence();
    keeping_ = context_.executor.spawn(keep_bindings());
  }
  co_return Result<void>();
}

Task<Result<void>> Naming::bind(Path path, Reference reference) {
  co_return co_await put(std::move(path), std::move(reference), false);
}

Task<Result<void>> Naming::rebind(Path path, Reference reference) {
  co_return co_await put(std::move(path), std::move(reference), true);
}

Task<Result<void>> Naming::unbind(Path path) {
  const Result<void> plain = check(path);
  if (!plain) co_return plain;
  const Datum pattern = bound_form(path, any, any);
  const Result<Revision> retracted = co_await context_.board.retract(pattern);
  if (!retracted) co_return fail(retracted);
  bound_.erase(path);
  co_return Result<void>();
}

Task<Result<void>> Naming::unbind_all() {
  Transaction transaction;
  for (const auto& [path, reference] : bound_) {
    transaction.retract(bound_form(path, Datum::symbol(reference.kind), Datum::symbol(reference.agent)));
  }
  const Result<Revision> retracted = co_await context_.board.transact(std::move(transaction));
  if (!retracted) co_return fail(retracted);
  bound_.clear();
  co_return Result<void>();
}

Task<Result<void>> Naming::remove_context(Path path) {
  const Result<void> plain = check(path);
  if (!plain) co_return plain;
  Transaction transaction;
  transaction.require(Transaction::Absent{pizarra::list("context"_sym, path_datum(path), any)});
  transaction.require(Transaction::Absent{pizarra::list("bound"_sym, path_datum(path), any, any, any)});
  transaction.retract(context_form(path));
  const Result<Revision> retracted = co_await context_.board.transact(std::move(transaction));
  const bool occupied = !retracted && retracted.error().symbol == "precondition-failed";
  if (occupied) co_return fail("not-empty", path_text(path) + " is not empty", retracted.error().subject);
  if (!retracted) co_return fail(retracted);
  co_return Result<void>();
}

Task<Result<Reference>> Naming::resolve(Path path) {
  const Result<void> plain = check(path);
  if (!plain) co_return fail(plain);
  const Result<std::vector<Fact>> bound = co_await look(bound_form(path, any, any), 1);
  if (!bound) co_return fail(bound);
  if (!bound->empty()) co_return *entry_of(bound->front().datum).reference;
  const Result<std::vector<Fact>> beside =
      co_await look(pizarra::list("bound"_sym, parent_of(path), any, any, any), max_listed);
  if (!beside) co_return fail(beside);
  std::vector<std::string> known;
  for (const Fact& fact : *beside) known.push_back(entry_of(fact.datum).path.back());
  const std::string nearest = nearest_name(path.back(), known);
  const std::string hint = nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
  co_return fail("unbound", fmt::format("nothing is bound as {}{}", path_text(path), hint), to_datum(path_text(path)));
}

Task<Result<Reference>> Naming::await(Path path, Time deadline) {
  const Result<void> plain = check(path);
  if (!plain) co_return fail(plain);
  const Query query = query_for(bound_form(path, "?kind"_sym, "?agent"_sym));
  const Result<Answer> answer = co_await await_answer(context_.board, query, deadline, context_.executor);
  if (!answer) co_return fail(answer);
  co_return *entry_of(answer->facts.front().datum).reference;
}

Task<Result<std::vector<Fact>>> Naming::look(Datum pattern, std::size_t limit) {
  Query query = query_for(std::move(pattern));
  query.limit = limit;
  const Result<Answers> answers = co_await context_.board.ask(std::move(query));
  if (!answers) co_return fail(answers);
  std::vector<Fact> facts;
  for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front());
  co_return facts;
}

Task<Result<Listing>> Naming::list(Path path) {
  if (!path.empty()) {
    const Result<void> plain = check(path);
    if (!plain) co_return fail(plain);
    const Result<std::vector<Fact>> itself = co_await look(context_form(path), 1);
    if (!itself) co_return fail(itself);
    if (itself->empty()) co_return fail("no-context", path_text(path) + " is no context", to_datum(path_text(path)));
  }
  const Datum branches = pizarra::list("context"_sym, path_datum(path), any);
  const Datum leaves = pizarra::list("bound"_sym, path_datum(path), any, any, any);
  std::vector<Fact> facts;
  for (const Datum& pattern : {branches, leaves}) {
    const Result<std::vector<Fact>> found = co_await look(pattern, max_listed + 1);
    if (!found) co_return fail(found);
    facts.insert(facts.end(), found->begin(), found->end());
  }
  co_return listing_of(facts);
}

Task<Result<Listing>> Naming::find(std::string kind) {
  if (!is_plain_name(kind)) co_return fail("bad-name", "a kind is letters, digits and dashes");
  const Datum pattern = pizarra::list("bound"_sym, any, any, Datum::symbol(kind), any);
  const Result<std::vector<Fact>> facts = co_await look(pattern, max_listed + 1);
  if (!facts) co_return fail(facts);
  co_return listing_of(*facts);
}

// A binding that somebody else made while this was away is theirs.
Task<Result<void>> Naming::tell_bindings() {
  const std::map<Path, Reference> bindings = bound_;
  for (const auto& [path, reference] : bindings) {
    bound_.erase(path);
    const Result<void> bound = co_await bind(path, reference);
    const bool taken = !bound && bound.error().symbol == "already-bound";
    if (taken) continue;
    bound_.emplace(path, reference);
    if (!bound) co_return bound;
  }
  co_return Result<void>();
}

Task<void> Naming::keep_bindings() {
  while (true) {
    co_await sleep(context_.executor, binding_look);
    const LeaseId presence = service_.presence();
    if (presence == told_under_) continue;
    const Result<void> told = co_await tell_bindings();
    if (told) told_under_ = presence;
  }
}

}  // namespace pizarra::runtime
