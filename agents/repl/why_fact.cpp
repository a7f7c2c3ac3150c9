#include "agents/repl/why_fact.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "blackboard/boards_own.hpp"
#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

constexpr int deepest = 8;
constexpr std::size_t most_lines = 200;

using FactsById = std::map<FactId, Fact>;

void add_facts(const Answers& answers, FactsById& facts) {
  for (const Answer& answer : answers.answers) {
    const Datum& said = answer.facts.front().datum;
    Fact fact;
    fact.id = static_cast<FactId>(said[2].integer());
    fact.datum = said[3];
    fact.teller = said[4].text();
    for (const Datum& reason : said[6].items()) fact.because.push_back(static_cast<FactId>(reason.integer()));
    facts.emplace(fact.id, std::move(fact));
  }
}

bool lacks_reasons(const FactsById& facts) {
  return std::ranges::any_of(facts, [&](const auto& entry) {
    const std::vector<FactId>& because = entry.second.because;
    return std::ranges::any_of(because, [&](FactId reason) { return !facts.contains(reason); });
  });
}

// The facts that it goes back to: what stands, and what stood when it was told, where the board keeps a journal.
Task<Result<FactsById>> facts_behind(Board& board, const Fact& root) {
  FactsById facts;
  Query query = query_for(list(Datum::symbol(provenance), root.id, "?"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym));
  const Result<Answers> standing = co_await board.ask(query);
  if (!standing) co_return fail(standing);
  add_facts(*standing, facts);
  if (!lacks_reasons(facts)) co_return facts;
  query.at = Moment{.revision = root.revision};
  const Result<Answers> stood = co_await board.ask(query);
  // Where there is no journal, they are said to have gone.
  if (stood) add_facts(*stood, facts);
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
  for (const Fact& fact : *asked) {
    const Result<FactsById> facts = co_await facts_behind(board, fact);
    if (!facts) co_return fail(facts);
    lines.push_back(fmt::format("{}  by {}", write(fact.datum), fact.teller));
    add_reasons(*facts, fact, 1, lines);
  }
  co_return lines;
}

}  // namespace pizarra::repl
