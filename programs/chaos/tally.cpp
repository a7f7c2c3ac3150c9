#include "programs/chaos/tally.hpp"

#include <fmt/format.h>

namespace pizarra::chaos {

void Tally::count(const RunResult& result) {
  ++runs;
  if (result.kind == RunResult::Kind::reached) ++reached;
  if (result.kind == RunResult::Kind::refused) ++refused;
  if (result.has_failed()) ++failed;
  if (!result.unsafe.empty()) ++unsafe;
  if (result.hung) ++hung;
  cell_s += result.cell_s;
  cpu_s += result.cpu_s;
  coverage.add(result.coverage);
}

std::string last_line(const Tally& tally) {
  return fmt::format("chaos runs {} reached {} refused {} failed {} unsafe {} hung {} unreached {}", tally.runs,
                     tally.reached, tally.refused, tally.failed, tally.unsafe, tally.hung,
                     tally.coverage.unreached().size());
}

bool passes(const Tally& tally) { return tally.unsafe == 0 && 100 * tally.failed <= tally.runs; }

}  // namespace pizarra::chaos
