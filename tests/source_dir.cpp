#include "tests/source_dir.hpp"

namespace pizarra {

std::string source_dir() { return PIZARRA_SOURCE_DIR; }

}  // namespace pizarra
