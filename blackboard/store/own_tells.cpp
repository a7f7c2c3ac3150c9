#include "blackboard/store/own_tells.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/store/looking.hpp"

namespace pizarra::store {

std::size_t OwnTells::candidates(const FactTable& table, const Datum& pattern) {
  if (table.key_is_ground(pattern)) return 0;
  for (; sorted_ < told_.size(); ++sorted_) relations_[told_[sorted_]->head()].facts.push_back(told_[sorted_]);
  const auto told = relations_.find(pattern.head());
  if (told == relations_.end()) return 0;
  auto& [facts, by_arguments] = told->second;
  if (FactTable::is_few(facts.size())) return facts.size();
  const FactTable::Mask mask = table.found_by(pattern);
  auto& [counted, alike] = by_arguments[mask];
  for (; counted < facts.size(); ++counted) ++alike[FactIndex::arguments_in(mask, *facts[counted])];
  const auto found = alike.find(FactIndex::arguments_in(mask, pattern));
  return found == alike.end() ? 0 : found->second;
}

std::size_t OwnTells::heaviest() {
  for (; weighed_ < told_.size(); ++weighed_) {
    heaviest_ = std::max(heaviest_, weigh(*told_[weighed_]).elements / Looking::elements_a_fact);
  }
  return heaviest_;
}

}  // namespace pizarra::store
