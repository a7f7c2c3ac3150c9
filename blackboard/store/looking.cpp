#include "blackboard/store/looking.hpp"

namespace pizarra::store {

Result<void> check_looking(std::size_t examined, const Datum& subject) {
  if (Indexing::is_awaiting()) return awaits_index(subject);
  return check_examined(examined, subject);
}

std::unexpected<Failure> awaits_index(const Datum& subject) {
  return fail("awaits-index", "this is found by an index that is being made", subject);
}

}  // namespace pizarra::store
