#include "agents/repl/why_fact.hpp"

#include <fmt/format.h>
#include <map>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

constexpr int deepest = 8;
constexpr std::size_t most_lines = 200;
// Facts that are looked through for the reasons.
constexpr std::size_t most_facts = 20'000;

using FactsById = std::map<FactId, Fact>;

// How many arguments the facts of each relation have.
using Widths = std::map<std::string, std::size_t, std::less<>>;

void add_posts(Widths& widths, const Datum& contract) {
  for (const Datum& part : contract.items()) {
    if (!part.is_form("posts")) continue;
    for (const Datum& relation : part.items().subspan(1)) {
      if (relation.is_form("relation") && relation.size() > 2)
        widths[std::string(relation[1].text())] = relation[2].size();
    }
  }
}

void add_condition(Widths& widths, std::string_view condition) {
  const Result<Datum> form = read_one(condition);
  if (!form) return;
  const Result<Query> query = query_from_datum(*form);
  if (!query) return;
  for (const Query::Clause& clause : query->clauses) {
    if (clause.kind == Query::Clause::Kind::fact) widths[std::string(clause.form.head())] = clause.form.size() - 1;
  }
}

// A board has no question for a fact's number, and none for all that it holds: what agents post by their contracts and
// what rules read is asked for.
Task<Result<Widths>> known_relations(Board& board) {
  Widths widths;
  const Result<std::vector<Fact>> contracts = co_await board.facts(list("contract"_sym, "?"_sym, "?"_sym));
  if (!contracts) co_return fail(contracts);
  for (const Fact& contract : *contracts) add_posts(widths, contract.datum[2]);
  if (!widths.contains("rule")) co_return widths;
  const Result<std::vector<Fact>> rules = co_await board.facts(list("rule"_sym, "?"_sym, "?"_sym, "?"_sym));
  if (!rules) co_return fail(rules);
  for (const Fact& rule : *rules) add_condition(widths, rule.datum[3].text());
  co_return widths;
}

Task<Result<FactsById>> facts_by_id(Board& board) {
  const Result<Widths> widths = co_await known_relations(board);
  if (!widths) co_return fail(widths);
  FactsById facts;
  for (const auto& [relation, width] : *widths) {
    std::vector<Datum> pattern{Datum::symbol(relation)};
    pattern.resize(1 + width, "?"_sym);
    const Result<std::vector<Fact>> held = co_await board.facts(Datum::list(std::move(pattern)));
    // One that this client may not read has no reasons for it.
    if (!held) continue;
    for (const Fact& fact : *held) facts.emplace(fact.id, fact);
    if (facts.size() > most_facts) break;
  }
  co_return facts;
}

void add_reasons(const FactsById& facts, const Fact& fact, int depth, std::vector<std::string>& lines) {
  for (const FactId id : fact.because) {
    if (lines.size() >= most_lines) return;
    const std::string margin(2 * static_cast<std::size_t>(depth), ' ');
    const auto found = facts.find(id);
    if (found == facts.end()) {
      lines.push_back(fmt::format("{}because of fact {}, which is not there any more", margin, id));
      continue;
    }
    lines.push_back(fmt::format("{}because {}  by {}", margin, write(found->second.datum), found->second.teller));
    if (depth < deepest) add_reasons(facts, found->second, depth + 1, lines);
  }
}

}  // namespace

Task<Result<std::vector<std::string>>> why_facts(Board& board, Datum pattern) {
  const Result<std::vector<Fact>> asked = co_await board.facts(std::move(pattern));
  if (!asked) co_return fail(asked);
  std::vector<std::string> lines;
  if (asked->empty()) co_return lines;
  const Result<FactsById> facts = co_await facts_by_id(board);
  if (!facts) co_return fail(facts);
  for (const Fact& fact : *asked) {
    lines.push_back(fmt::format("{}  by {}", write(fact.datum), fact.teller));
    add_reasons(*facts, fact, 1, lines);
  }
  co_return lines;
}

}  // namespace pizarra::repl
