#include "agents/repl/trading.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "agents/repl/commands.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/json.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

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

}  // namespace

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

Task<Evaluation> Interpreter::find(Datum form) {
  if (form.size() < 2 || !form[1].is_symbol()) co_return usage("find");
  const Result<std::vector<Wish>> wishes = wishes_from(form);
  if (!wishes) co_return show(wishes.error(), Evaluation::malformed);
  const Result<runtime::Listing> bound = co_await naming_.find(std::string(form[1].text()));
  const bool nobody = !bound && bound.error().symbol == "undeclared-relation";
  if (!bound && !nobody) co_return show(bound.error());
  const Result<std::vector<Fact>> agents = co_await context_.board.facts(read_pattern("(agent ? ? ?)"));
  if (!agents) co_return show(agents.error());
  const Result<std::vector<Fact>> told =
      co_await runtime::facts_if_declared(context_.board, read_pattern("(property ? ? ?)"));
  if (!told) co_return show(told.error());
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
    say(fmt::format("  {} as {}{}{}", agent, named, met->empty() ? "" : ": ", *met),
        fmt::format("{{\"agent\":{},\"path\":{},\"properties\":{}}}", json_string(agent), json_string(named),
                    json_string(*met)));
  }
  if (any) co_return Evaluation::done;
  const std::string none = fmt::format("no {} that is bound has all of this", form[1].text());
  const Failure failure{"not-found", none, form[1], {}};
  co_return show(failure);
}

}  // namespace pizarra::repl
