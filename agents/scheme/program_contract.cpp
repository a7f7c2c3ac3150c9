#include "agents/scheme/program_contract.hpp"

#include <set>

#include "blackboard/query.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::scheme {

namespace {

// What every such agent tells of its file.
constexpr const char* own_relations[] = {
    "(relation program ((agent symbol) (state symbol) (text string)) (key agent))",
    "(relation program-fault ((agent symbol) (part symbol) (text string)) (key agent part))",
    "(relation rule ((agent symbol) (name symbol) (condition string)) (key agent name))",
};

// Failure bad-query, with the rule's name.
Result<void> add_relations(std::set<std::string>& read, const forms::ProgramPart& part) {
  const Result<Query> query = query_from_datum(part.head);
  if (!query) return fail("bad-program", "the condition of " + part.name + ": " + query.error().sentence, part.head);
  for (const Query::Clause& clause : query->clauses) {
    if (clause.kind != Query::Clause::Kind::compare) read.emplace(clause.form.head());
  }
  return {};
}

}  // namespace

Result<runtime::Contract> contract_of(const forms::AgentProgram* program, const std::string& agent) {
  std::vector<Datum> offers{"offers"_sym};
  std::vector<Datum> posts{"posts"_sym};
  std::vector<Datum> reads{"reads"_sym};
  std::set<std::string> read;
  for (const char* relation : own_relations) posts.push_back(read_one(relation).value());
  if (program != nullptr) {
    posts.insert(posts.end(), program->posts().begin(), program->posts().end());
    reads.insert(reads.end(), program->reads().begin(), program->reads().end());
    for (const forms::ProgramPart& part : program->parts()) {
      using enum forms::ProgramPart::Sort;
      if (part.sort == operation) offers.push_back(part.head);
      if (part.sort != rule && part.sort != conclusion) continue;
      const Result<void> added = add_relations(read, part);
      if (!added) return fail(added);
    }
  }
  for (const Datum& relation : std::span(reads).subspan(1)) {
    const Datum& name = relation.size() > 1 ? relation[1] : relation;
    if (name.is_symbol()) read.erase(std::string(name.text()));
  }
  for (const std::string& relation : read) reads.push_back(Datum::symbol(relation));
  const Datum kind = Datum::symbol(program != nullptr ? program->kind() : agent);
  return runtime::contract_from_text(write(list("contract"_sym, kind, Datum::list(std::move(offers)),
                                                Datum::list(std::move(posts)), Datum::list(std::move(reads)))));
}

}  // namespace pizarra::scheme
