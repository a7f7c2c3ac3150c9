// Names of agents in the tree of contexts: what the prompt shows of them, and changes in them.

#include <fmt/format.h>

#include "agents/repl/commands.hpp"
#include "agents/runtime/naming.hpp"
#include "lisp/json.hpp"
#include "lisp/nearest.hpp"

namespace pizarra::repl {

namespace {

// (cell arms left); nothing where it is not a list of symbols.
std::optional<runtime::Path> path_from(const Datum& form) {
  if (!form.is_list()) return std::nullopt;
  runtime::Path path;
  for (const Datum& name : form.items()) {
    if (!name.is_symbol()) return std::nullopt;
    path.emplace_back(name.text());
  }
  return path;
}

std::string entry_text(const runtime::NamedEntry& entry) {
  const std::string& name = entry.path.back();
  if (!entry.reference) return fmt::format("  {}/", name);
  return fmt::format("  {}: {} ({})", name, entry.reference->agent, entry.reference->kind);
}

std::string entry_json(const runtime::NamedEntry& entry) {
  const std::string path = json_string(runtime::path_text(entry.path));
  if (!entry.reference) return fmt::format("{{\"context\":{}}}", path);
  return fmt::format("{{\"path\":{},\"agent\":{},\"kind\":{}}}", path, json_string(entry.reference->agent),
                     json_string(entry.reference->kind));
}

}  // namespace

// (bind PATH AGENT), (rebind PATH AGENT)
Task<Evaluation> Interpreter::name_agent(Datum form) {
  const std::string command(form.head());
  const std::optional<runtime::Path> path = form.size() == 3 ? path_from(form[1]) : std::nullopt;
  if (!path || !form[2].is_symbol()) co_return usage(command);
  const Result<runtime::Reference> agent = co_await agent_called(std::string(form[2].text()));
  if (!agent) co_return show(agent.error());
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return show(declared.error());
  Result<void> named;
  if (form.is_form("bind")) {
    named = co_await naming_.bind(*path, *agent);
  } else {
    named = co_await naming_.rebind(*path, *agent);
  }
  if (!named) co_return show(named.error());
  say(fmt::format("{} is {} for as long as this prompt lives", runtime::path_text(*path), agent->agent),
      entry_json({*path, *agent}));
  co_return Evaluation::done;
}

// What is present under this name.
Task<Result<runtime::Reference>> Interpreter::agent_called(std::string name) {
  const Result<std::vector<Fact>> agents = co_await context_.board.facts(read_pattern("(agent ? ? ?)"));
  if (!agents) co_return fail(agents);
  std::vector<std::string> known;
  for (const Fact& agent : *agents) {
    if (agent.datum[1].is_symbol(name)) co_return runtime::Reference{std::string(agent.datum[2].text()), name};
    known.emplace_back(agent.datum[1].text());
  }
  const std::string near = nearest_name(name, known);
  const std::string hint = near.empty() ? "" : fmt::format("; did you mean {}?", near);
  co_return fail("absent", fmt::format("no agent {} is present{}", name, hint), Datum::symbol(name));
}

Task<Evaluation> Interpreter::unbind(Datum form) {
  const std::optional<runtime::Path> path = form.size() == 2 ? path_from(form[1]) : std::nullopt;
  if (!path) co_return usage("unbind");
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return show(declared.error());
  const Result<runtime::Reference> bound = co_await naming_.resolve(*path);
  if (!bound) co_return show(bound.error());
  const Result<void> unbound = co_await naming_.unbind(*path);
  if (!unbound) co_return show(unbound.error());
  say(fmt::format("{} is nobody", runtime::path_text(*path)),
      fmt::format("{{\"unbound\":{}}}", json_string(runtime::path_text(*path))));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::resolve(Datum form) {
  const std::optional<runtime::Path> path = form.size() == 2 ? path_from(form[1]) : std::nullopt;
  if (!path) co_return usage("resolve");
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return show(declared.error());
  const Result<runtime::Reference> bound = co_await naming_.resolve(*path);
  if (!bound) co_return show(bound.error());
  say(fmt::format("{} ({})", bound->agent, bound->kind), entry_json({*path, *bound}));
  co_return Evaluation::done;
}

// (list), (list PATH)
Task<Evaluation> Interpreter::list_names(Datum form) {
  const std::optional<runtime::Path> path =
      form.size() == 2 ? path_from(form[1]) : std::optional<runtime::Path>(runtime::Path());
  if (form.size() > 2 || !path) co_return usage("list");
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return show(declared.error());
  const Result<runtime::Listing> listing = co_await naming_.list(*path);
  if (!listing) co_return show(listing.error());
  for (const runtime::NamedEntry& entry : listing->entries) say(entry_text(entry), entry_json(entry));
  if (listing->entries.empty()) output_("nothing is bound there");
  if (listing->cut) output_(fmt::format("the first {} of them", listing->entries.size()));
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
