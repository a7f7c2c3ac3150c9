#include "blackboard/store/index_maker.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/table_indexes.hpp"

namespace pizarra::store {

IndexTicket IndexMaker::want(TableIndexes& table, const FactIndex::Kind& kind) {
  const auto is_it = [&](const Making& making) { return making.table == &table && making.kind == kind; };
  if (makings_.size() < most && std::ranges::none_of(makings_, is_it)) {
    table.begin(kind);
    makings_.push_back({&table, kind});
    on_wanted();
  }
  return made_ + 1;
}

std::size_t IndexMaker::make_some() {
  const Making making = makings_.front();
  makings_.pop_front();
  std::size_t examined = 0;
  bool is_made = false;
  {
    Looking looking(examined, limits::examined_a_turn / Indexing::looks_a_fact);
    is_made = making.table->make_some(making.kind, looking);
  }
  if (is_made) ++made_;
  if (!is_made) makings_.push_back(making);
  return examined * Indexing::looks_a_fact;
}

}  // namespace pizarra::store
