#include "blackboard/store/indexing.hpp"

#include "blackboard/store/index_maker.hpp"

namespace pizarra::store {

bool Indexing::makes_at_once(std::size_t facts) {
  // Of all indexes that one request has made: some 3 ms.
  constexpr std::size_t few = 1024;
  return innermost == nullptr || innermost->may_ == May::make_at_once || innermost->facts_ + facts <= few;
}

void Indexing::await(TableIndexes& table, const FactIndex::Kind& kind) {
  // Work that makes everything at once skips an index that somebody else is making.
  const bool may_await = innermost != nullptr && innermost->may_ == May::make_in_parts;
  if (may_await) await(innermost->maker_->want(table, kind));
}

}  // namespace pizarra::store
