#include "blackboard/server/answered.hpp"

#include <algorithm>
#include <utility>

namespace pizarra::server {

void Answered::add(wire::RequestId number, Durability::Reply reply) {
  const auto [place, fresh] = replies_.emplace(number, std::move(reply));
  if (fresh) bytes_ += place->second.text.size();
  // One is remembered whatever its size.
  while (replies_.size() > most || (bytes_ > most_bytes && replies_.size() > 1)) {
    forgotten_ = std::max(forgotten_, replies_.begin()->first);
    bytes_ -= replies_.begin()->second.text.size();
    replies_.erase(replies_.begin());
  }
}

const Durability::Reply* Answered::find(wire::RequestId number) const {
  const auto found = replies_.find(number);
  return found == replies_.end() ? nullptr : &found->second;
}

}  // namespace pizarra::server
