#pragma once

// What a console would have kept, had it been there since the board's journal begins.
//
//   const KeptChanges::Kept earlier = journalled_changes("/run/.../board.journal", [] { return false; });
//
// Empty where the journal cannot be read. It reads all of it, so it is called on a thread of its own.

#include <functional>
#include <string>

#include "agents/console/kept_changes.hpp"

namespace pizarra::console {

KeptChanges::Kept journalled_changes(const std::string& journal, const std::function<bool()>& is_cancelled);

}  // namespace pizarra::console
