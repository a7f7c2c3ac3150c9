#pragma once

// Requests that disturb the arm's work, as in world.hpp, understood and begun: to the hand, `(hand push NAME DX DY)`
// and so on, and those that make the gripper's fingers clumsy.
//
//   const Result<void> begun = begin_hand(cell, request);      // (hand push circle 20 0)

#include "drivers/simulation/physics/physical_cell.hpp"

namespace pizarra::simulation {

// The text of a request's symbol or string at `index`; empty where there is none.
std::string_view word(const Datum& request, std::size_t index);
std::unexpected<Failure> bad_request(const Datum& request);

// Failures: unknown-object, busy, bad-request.
Result<void> begin_hand(Cell& cell, const Datum& request);

// Failures: bad-request; not-held, where nothing is held that could slip.
Result<void> make_clumsy(Cell& cell, const Datum& request);

}  // namespace pizarra::simulation
