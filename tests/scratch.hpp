#pragma once

// A folder of this test process alone, gone when the process ends, with all that was put there.
//
//   const std::string file = scratch_folder() + "cell.scm";
//
// Programs that a test starts find it as their temporary folder (TMPDIR) and as the one where cells run
// (XDG_RUNTIME_DIR) once it was asked for.

#include <string>

namespace pizarra {

// Ends with a slash.
const std::string& scratch_folder();

}  // namespace pizarra
