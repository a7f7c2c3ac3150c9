#include "agents/repl/name_commands.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/runtime/declared.hpp"
#include "lisp/json.hpp"
#include "lisp/nearest.hpp"
#include "lisp/result.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

// A condition of (find KIND CONDITION ...).
struct Wish {
  std::string name;
  std::string compare;  // empty: whatever it is
  Datum value;
};

constexpr std::array comparisons = {">", ">=", "<", "<=", "=", "/="};

bool is_met(const Wish& wish, const Datum& value) {
  if (wish.compare.empty()) return true;
  const bool numbers = value.is_number() && wish.value.is_number();
  // A text is compared with a name as it is spelled: hosts are texts, and typed as names.
  const bool same = numbers ? value.number() == wish.value.number() : value.text() == wish.value.text();
  if (wish.compare == "=") return same;
  if (wish.compare == "/=") return !same;
  if (!numbers) return false;
  const double difference = value.number() - wish.value.number();
  if (wish.compare == ">") return difference > 0;
  if (wish.compare == ">=") return difference >= 0;
  return wish.compare == "<" ? difference < 0 : difference <= 0;
}

// Failure malformed.
Result<std::vector<Wish>> wishes_from(const Datum& form) {
  std::vector<Wish> wishes;
  for (const Datum& item : form.items().subspan(2)) {
    const bool named = item.size() > 1 && item[0].is_symbol();
    if (named && item.size() == 2 && item[1].is_symbol("?")) {
      wishes.push_back({std::string(item[0].text()), {}, {}});
      continue;
    }
    const bool compared = named && item.size() == 3 && item[1].is_symbol() &&
                          std::ranges::find(comparisons, item[1].text()) != comparisons.end() && !item[2].is_list();
    if (!compared) {
      return fail("malformed", "a condition is (NAME ?) or (NAME OP VALUE), OP one of > >= < <= = /=", item);
    }
    wishes.push_back({std::string(item[0].text()), std::string(item[1].text()), item[2]});
  }
  return wishes;
}

// "reach 710, host bench" where the properties meet every wish; nothing where one is missing or differs. Only numbers
// are compared as greater or less.
std::optional<std::string> met_by(const std::vector<Wish>& wishes, const std::map<std::string, Datum>& properties) {
  std::string text;
  for (const Wish& wish : wishes) {
    const auto found = properties.find(wish.name);
    if (found == properties.end() || !is_met(wish, found->second)) return std::nullopt;
    const Datum& value = found->second;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", wish.name,
                        value.is_string() ? std::string(value.text()) : write(value));
  }
  return text;
}

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

Task<Evaluation> NameCommands::bind(Typed typed) {
  const std::optional<runtime::Path> path = typed.form.size() == 3 ? path_from(typed.form[1]) : std::nullopt;
  if (!path || !typed.form[2].is_symbol()) co_return prompt_.misused(typed);
  const Result<runtime::Reference> agent = co_await agent_called(std::string(typed.form[2].text()));
  if (!agent) co_return prompt_.show(agent.error());
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return prompt_.show(declared.error());
  Result<void> named;
  if (typed.form.is_form("bind")) {
    named = co_await naming_.bind(*path, *agent);
  } else {
    named = co_await naming_.rebind(*path, *agent);
  }
  if (!named) co_return prompt_.show(named.error());
  prompt_.say(fmt::format("{} is {} for as long as this prompt lives", runtime::path_text(*path), agent->agent),
              entry_json({*path, *agent}));
  co_return Evaluation::done;
}

Task<Result<runtime::Reference>> NameCommands::agent_called(std::string name) {
  const Result<std::vector<Fact>> agents = co_await prompt_.board.facts(read_pattern("(agent ? ? ?)"));
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

Task<Evaluation> NameCommands::unbind(Typed typed) {
  const std::optional<runtime::Path> path = typed.form.size() == 2 ? path_from(typed.form[1]) : std::nullopt;
  if (!path) co_return prompt_.misused(typed);
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return prompt_.show(declared.error());
  const Result<runtime::Reference> bound = co_await naming_.resolve(*path);
  if (!bound) co_return prompt_.show(bound.error());
  const Result<void> unbound = co_await naming_.unbind(*path);
  if (!unbound) co_return prompt_.show(unbound.error());
  prompt_.say(fmt::format("{} is nobody", runtime::path_text(*path)),
              fmt::format("{{\"unbound\":{}}}", json_string(runtime::path_text(*path))));
  co_return Evaluation::done;
}

Task<Evaluation> NameCommands::resolve(Typed typed) {
  const std::optional<runtime::Path> path = typed.form.size() == 2 ? path_from(typed.form[1]) : std::nullopt;
  if (!path) co_return prompt_.misused(typed);
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return prompt_.show(declared.error());
  const Result<runtime::Reference> bound = co_await naming_.resolve(*path);
  if (!bound) co_return prompt_.show(bound.error());
  prompt_.say(fmt::format("{} ({})", bound->agent, bound->kind), entry_json({*path, *bound}));
  co_return Evaluation::done;
}

Task<Evaluation> NameCommands::list_names(Typed typed) {
  const std::optional<runtime::Path> path =
      typed.form.size() == 2 ? path_from(typed.form[1]) : std::optional<runtime::Path>(runtime::Path());
  if (typed.form.size() > 2 || !path) co_return prompt_.misused(typed);
  const Result<void> declared = co_await naming_.declare();
  if (!declared) co_return prompt_.show(declared.error());
  const Result<runtime::Listing> listing = co_await naming_.list(*path);
  if (!listing) co_return prompt_.show(listing.error());
  for (const runtime::NamedEntry& entry : listing->entries) prompt_.say(entry_text(entry), entry_json(entry));
  if (listing->entries.empty()) prompt_.print("nothing is bound there");
  if (listing->cut) prompt_.print(fmt::format("the first {} of them", listing->entries.size()));
  co_return Evaluation::done;
}

Task<Evaluation> NameCommands::find(Typed typed) {
  if (typed.form.size() < 2 || !typed.form[1].is_symbol()) co_return prompt_.misused(typed);
  const Result<std::vector<Wish>> wishes = wishes_from(typed.form);
  if (!wishes) co_return prompt_.show(wishes.error(), Evaluation::malformed);
  const Result<runtime::Listing> bound = co_await naming_.find(std::string(typed.form[1].text()));
  const bool nobody = !bound && bound.error().symbol == "undeclared-relation";
  if (!bound && !nobody) co_return prompt_.show(bound.error());
  const Result<std::vector<Fact>> agents = co_await prompt_.board.facts(read_pattern("(agent ? ? ?)"));
  if (!agents) co_return prompt_.show(agents.error());
  const Result<std::vector<Fact>> told =
      co_await runtime::facts_if_declared(prompt_.board, read_pattern("(property ? ? ?)"));
  if (!told) co_return prompt_.show(told.error());
  std::map<std::string, std::map<std::string, Datum>> properties;
  for (const Fact& fact : *agents) properties[std::string(fact.datum[1].text())]["host"] = fact.datum[3];
  for (const Fact& fact : *told) {
    properties[std::string(fact.datum[1].text())][std::string(fact.datum[2].text())] = fact.datum[3];
  }
  std::map<std::string, std::string> paths;
  const std::vector<runtime::NamedEntry> entries = nobody ? std::vector<runtime::NamedEntry>() : bound->entries;
  for (const runtime::NamedEntry& entry : entries) {
    std::string& all = paths[entry.reference->agent];
    all += (all.empty() ? "" : ", ") + runtime::path_text(entry.path);
  }
  bool any = false;
  for (const auto& [agent, named] : paths) {
    const std::optional<std::string> met = met_by(*wishes, properties[agent]);
    if (!met) continue;
    any = true;
    prompt_.say(fmt::format("  {} as {}{}{}", agent, named, met->empty() ? "" : ": ", *met),
                fmt::format("{{\"agent\":{},\"path\":{},\"properties\":{}}}", json_string(agent), json_string(named),
                            json_string(*met)));
  }
  if (any) co_return Evaluation::done;
  const std::string none = fmt::format("no {} that is bound has all of this", typed.form[1].text());
  const Failure failure{"not-found", none, typed.form[1], {}};
  co_return prompt_.show(failure);
}

}  // namespace pizarra::repl
