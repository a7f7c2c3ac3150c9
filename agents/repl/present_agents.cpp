#include "agents/repl/present_agents.hpp"

#include "agents/runtime/declared.hpp"

namespace pizarra::repl {

Task<bool> is_present(Board& board, std::string agent) {
  if (agent.empty()) co_return false;
  const Result<std::vector<Fact>> present =
      co_await board.facts(list("agent"_sym, Datum::symbol(agent), "?"_sym, "?"_sym));
  co_return present.has_value() && !present->empty();
}

Task<std::vector<Datum>> offers_of(Board& board, Datum agent) {
  const Result<std::vector<Fact>> contracts = co_await board.facts(list("contract"_sym, agent, "?"_sym));
  std::vector<Datum> out;
  for (const Fact& contract : contracts.value_or(std::vector<Fact>())) {
    for (const Datum& part : contract.datum[2].items()) {
      if (!part.is_form("offers")) continue;
      out.insert(out.end(), part.items().begin() + 1, part.items().end());
    }
  }
  co_return out;
}

Task<std::set<std::string>> names_on(Board& board) {
  std::set<std::string> names;
  const Result<std::vector<Fact>> contracts = co_await board.facts(read_pattern("(contract ?name ?form)"));
  for (const Fact& fact : contracts.value_or(std::vector<Fact>())) {
    names.emplace(fact.datum[1].text());
    for (const Datum& part : fact.datum[2].items()) {
      if (!part.is_list()) continue;
      for (const Datum& item : part.items()) {
        if (part.is_form("offers") && item.is_list()) names.emplace(item.head());
        if (item.is_form("relation") && item.size() > 1) names.emplace(item[1].text());
      }
    }
  }
  const Result<std::vector<Fact>> learned =
      co_await runtime::facts_if_declared(board, read_pattern("(learned ? ? ? ? ? ? ? ? ?)"));
  for (const Fact& fact : learned.value_or(std::vector<Fact>())) names.emplace(fact.datum[2].text());
  co_return names;
}

}  // namespace pizarra::repl
