#include "blackboard/store/made_up.hpp"

#include <algorithm>

#include "blackboard/boards_own.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/query_tables.hpp"

namespace pizarra::store {

bool asks_for(const Query& query, std::string_view relation) {
  return std::ranges::any_of(query.clauses, [&](const Query::Clause& clause) {
    return clause.kind != Query::Clause::Kind::compare && clause.form.head() == relation;
  });
}

Result<Answers> answer_from(const Relation& about, std::vector<Datum> forms, const Query& query, const AskedAt& asked,
                            std::size_t& examined) {
  Tables tables;
  FactTable& table = tables.try_emplace(about.name, about).first->second;
  FactId id = 0;
  for (Datum& form : forms) {
    Fact fact;
    fact.datum = std::move(form);
    fact.id = ++id;
    fact.teller = board_teller;
    fact.when = asked.when;
    fact.revision = asked.revision;
    table.insert({std::move(fact)});
  }
  const Result<void> checked = check_query_on(query, tables);
  if (!checked && checked.error().symbol == "undeclared-relation") {
    return fail("bad-query", about.name + " is asked for alone", query_to_datum(query));
  }
  if (!checked) return fail(checked);
  // These tables are gone when others have been served.
  const Indexing indexing(Indexing::May::make_at_once);
  Result<std::vector<Answer>> answers = evaluate(query, tables, examined);
  examined += indexing.examined();
  if (!answers) return fail(answers);
  return Answers{asked.revision, std::move(*answers)};
}

}  // namespace pizarra::store
