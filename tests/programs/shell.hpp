#pragma once

// A command line as a person types it, and what came of it.
//
//   const Said said = shell(std::string(PIZARRA_CELL) + " demo --sed 3 2>&1");

#include <string>

namespace pizarra::programs {

struct Said {
  int status = 0;  // the exit status, or 128 and the signal that ended it, as shells count
  std::string text;
};

Said shell(const std::string& command);
// In the scratch folder, with what it says on standard error.
Said shell_in_scratch(const std::string& command);
bool contains(const Said& said, const std::string& text);

}  // namespace pizarra::programs
