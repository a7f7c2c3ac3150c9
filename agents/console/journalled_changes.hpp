#pragma once

// The changes since the board's journal begins, as a console keeps them that was there all the time.
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
