#include "blackboard/memory/own_permissions.hpp"

#include "blackboard/boards_own.hpp"

namespace pizarra::memory {

ListedPermissions every_permission() { return {{"tell", "*"}, {"take", "*"}, {"read", "*"}, {"override", "*"}}; }

Result<Answers> own_permissions(const ListedPermissions& listed, const Query& query, const store::AskedAt& asked,
                                std::size_t& examined) {
  const Relation about{.name = std::string(own_permission),
                       .arguments = {{"verb", ArgumentType::symbol}, {"relation", ArgumentType::symbol}},
                       .key = {0, 1},
                       .durable = false,
                       .lease = {}};
  std::vector<Datum> forms;
  for (const auto& [verb, relation] : listed) {
    forms.push_back(list(Datum::symbol(own_permission), Datum::symbol(verb), Datum::symbol(relation)));
  }
  return store::answer_from(about, std::move(forms), query, asked, examined);
}

}  // namespace pizarra::memory
