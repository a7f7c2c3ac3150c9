#include "tests/campaign.hpp"

#include <cstdlib>

namespace pizarra {

bool is_nightly() {
  static const bool nightly = std::getenv("PIZARRA_NIGHTLY") != nullptr;
  return nightly;
}

}  // namespace pizarra
