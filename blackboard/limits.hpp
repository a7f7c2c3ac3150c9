#pragma once

// How much the board takes at once. All kinds of board refuse the same, so that an agent that works on one works on
// another; the bound is below what a frame of the wire may hold.
//
//   const Result<void> fits = check_weight(weigh(fact), "the fact");

#include <cstddef>

#include "blackboard/fact.hpp"
#include "lisp/datum.hpp"
#include "lisp/result.hpp"
#include "lisp/weight.hpp"

namespace pizarra {

// Of the fact and its provenance.
Weight weigh(const Fact& fact);

namespace limits {

constexpr std::size_t frame_bytes = 1 << 20;
constexpr std::size_t frame_elements = 200'000;
constexpr std::size_t frame_depth = 64;
// Of a transaction, so of one fact too, of an answer or of a change. The rest of the frame is its envelope.
constexpr std::size_t bytes = frame_bytes - (1 << 14);
constexpr std::size_t elements = frame_elements - 1000;
constexpr std::size_t depth = frame_depth - 8;

constexpr std::size_t steps = 10'000;     // in a transaction
constexpr std::size_t facts = 1'000'000;  // on a board
// Of an ID in a message, at most: its figures and a blank.
constexpr std::size_t id_bytes = 21;
// Of all facts of a board, as footprint() counts them.
constexpr std::size_t board_bytes = 1 << 30;
constexpr std::size_t relations = 2048;   // on a board
constexpr std::size_t name_bytes = 128;   // of a relation, of an argument, of a teller
constexpr std::size_t leases = 100'000;   // on a board
constexpr std::size_t watches = 100'000;  // on a board
// Facts looked at to answer one question or to check and do one transaction: some 25 ms, in which nobody else is
// served.
constexpr std::size_t examined = 250'000;
// Facts looked at to tell readers what holds, before others are served.
constexpr std::size_t examined_a_turn = 4000;
// What waits for a reader of a watch; one that lags further behind is resynchronised.
constexpr std::size_t pending_changes = 1024;
constexpr std::size_t pending_bytes = 4 << 20;
// A reader receives the facts that hold in parts of about this size.
constexpr std::size_t part_bytes = 1 << 18;

}  // namespace limits

// The memory that a fact takes, roughly, without its share of the indexes.
std::size_t footprint(const Fact& fact, const Weight& of_its_datum);
inline std::size_t footprint(const Fact& fact) { return footprint(fact, weigh(fact.datum)); }

// Failure too-costly.
Result<void> check_examined(std::size_t examined, const Datum& subject);
// Failure too-large.
Result<void> check_weight(const Weight& weight, const char* what);

}  // namespace pizarra
