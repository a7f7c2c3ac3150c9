#include "blackboard/store/provenance.hpp"

#include <deque>
#include <set>

#include "blackboard/boards_own.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::store {

namespace {

constexpr std::size_t most_facts = 200;
constexpr std::size_t most_bytes = 256 << 10;
// To find one by its number.
constexpr std::size_t looks_a_fact = 4;

Relation about_provenance() {
  return {.name = std::string(provenance),
          .arguments = {{"root", ArgumentType::integer},
                        {"id", ArgumentType::integer},
                        {"fact", ArgumentType::list},
                        {"teller", ArgumentType::string},
                        {"when", ArgumentType::integer},
                        {"because", ArgumentType::list}},
          .key = {0, 1},
          .durable = false,
          .lease = {}};
}

Result<FactId> root_in(const Query& query) {
  const Datum& pattern = query.clauses.front().form;
  const bool alone = query.clauses.size() == 1 && query.clauses.front().kind == Query::Clause::Kind::fact;
  const bool says_root = alone && pattern.size() > 1 && pattern[1].is_integer() && pattern[1].integer() >= 0;
  if (says_root) return static_cast<FactId>(pattern[1].integer());
  return fail("bad-query", "provenance is asked for alone, with the number of a fact as its first argument",
              query_to_datum(query));
}

Datum form_of(FactId root, const Fact& fact) {
  std::vector<Datum> because;
  for (const FactId reason : fact.because) because.push_back(to_datum(reason));
  return list(Datum::symbol(provenance), root, fact.id, fact.datum, fact.teller, fact.when.time_since_epoch().count(),
              Datum::list(std::move(because)));
}

std::vector<Datum> forms_from(FactId root, const Store& store) {
  std::vector<Datum> forms;
  std::deque<FactId> next{root};
  std::set<FactId> met{root};
  std::size_t bytes = 0;
  while (!next.empty() && forms.size() < most_facts) {
    const Fact* fact = store.fact(next.front());
    next.pop_front();
    if (fact == nullptr) continue;
    forms.push_back(form_of(root, *fact));
    bytes += weigh(forms.back()).bytes;
    if (bytes > most_bytes) {
      forms.pop_back();
      break;
    }
    for (const FactId reason : fact->because) {
      if (met.insert(reason).second) next.push_back(reason);
    }
  }
  return forms;
}

}  // namespace

Result<Answers> provenance_of(const Query& query, const Store& store, const AskedAt& asked, std::size_t& examined) {
  const Result<FactId> root = root_in(query);
  if (!root) return fail(root);
  std::vector<Datum> forms = forms_from(*root, store);
  examined += looks_a_fact * (forms.size() + 1);
  return answer_from(about_provenance(), std::move(forms), query, asked, examined);
}

}  // namespace pizarra::store
