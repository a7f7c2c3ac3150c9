#include "agents/launcher/words.hpp"

#include <fmt/format.h>

namespace pizarra {

int complain(const Failure& failure, ExitCode code) {
  fmt::print(stderr, "pizarra: {}\n", describe(failure));
  return code;
}

std::string shipped_file(const std::string& path) { return std::string(PIZARRA_SOURCE_DIR) + "/" + path; }

}  // namespace pizarra
