#pragma once

// Which durable facts a client's request touches, and how much the journal would write of it. A body is the form
// that a request carries (wire.hpp).
//
//   if (concerns_durable(store, body)) room = bytes_at_most(body);

#include "blackboard/board.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::server {

// Whether it tells, retracts, takes, settles or declares what is durable.
bool concerns_durable(const store::Store& store, const Datum& body);
// Whether a query has a durable relation in any of its clauses.
bool asks_durable(const store::Store& store, const Datum& query);
// Whether nothing stands after it that did not stand before.
bool only_removes(const Datum& body);

// What the journal says beside the request: when and who, and its reply.
inline constexpr std::size_t said_beside = 512;
// " (retract 18446744073709551615)"
inline constexpr std::size_t bytes_of_a_removal = 31;
// Of the line, and of the reply that is remembered with it: that to a `take` has the fact.
std::size_t bytes_at_most(const Datum& body);
// The facts that its retractions may take away.
std::size_t removed_at_most(const store::Store& store, const Transaction& transaction);

}  // namespace pizarra::server
