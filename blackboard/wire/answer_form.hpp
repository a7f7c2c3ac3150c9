#pragma once

// Facts, answers and changes as they stand in the frames of the wire; wire.hpp says where, and in which form.
//
//   write_change(frame, watch, sequence, width, kept, delta);            // the server
//   Result<Delta> delta = delta_from_datum(query, kept, message);       // the client

#include <span>
#include <string>
#include <vector>

#include "blackboard/delta.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::wire {

// Failure bad-frame, here and below.
Result<Fact> fact_from_datum(const Datum& form);
Datum fact_to_datum(const Fact& fact);

// The value of the reply to a question.
Datum answers_to_datum(const Answers& answers);
Datum answer_to_datum(const Answer& answer);
Result<std::vector<Answer>> answers_from_datum(const Query& query, std::span<const Datum> forms);

// Adds `(change ...)`, of a query whose answers have `width` facts each, to a client that keeps what it was sent or
// not.
void write_change(std::string& out, WatchId watch, std::uint64_t sequence, std::size_t width, bool kept,
                  const Delta& delta);
// The content of a `(change ...)` that has at least its watch and sequence. To a client that keeps what it was sent,
// only the id is known of a fact that went.
Result<Delta> delta_from_datum(const Query& query, bool kept, const Datum& form);

}  // namespace pizarra::wire
