#include "blackboard/store/index_maker.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/table_indexes.hpp"

namespace pizarra::store {

IndexTicket IndexMaker::want(TableIndexes& table, const FactIndex::Kind& kind, const std::string& client) {
  const auto is_it = [&](const Making& making) { return making.table == &table && making.kind == kind; };
  if (const auto made = std::ranges::find_if(makings_, is_it); made != makings_.end()) return made->ticket;
  const auto own = std::ranges::find(makings_, client, &Making::client);
  if (own != makings_.end()) return own->ticket;
  if (makings_.size() >= most) return makings_.front().ticket;
  table.begin(kind);
  makings_.push_back({next_ticket_++, &table, kind, client});
  on_wanted();
  return makings_.back().ticket;
}

bool IndexMaker::is_under_way(IndexTicket ticket) const {
  return std::ranges::find(makings_, ticket, &Making::ticket) != makings_.end();
}

IndexMaker::Part IndexMaker::make_some() {
  Making making = std::move(makings_.front());
  makings_.pop_front();
  Part part{.client = making.client};
  bool is_made = false;
  {
    Looking looking(part.examined, limits::examined_a_turn / Indexing::looks_a_fact);
    is_made = making.table->make_some(making.kind, looking);
  }
  part.examined *= Indexing::looks_a_fact;
  if (is_made) {
    part.made = making.ticket;
  } else {
    makings_.push_back(std::move(making));
  }
  return part;
}

}  // namespace pizarra::store
