#include "agents/runtime/stop_fact.hpp"

#include <fmt/format.h>

namespace pizarra::runtime {

Datum any_stop() { return list("stop"_sym, "?"_sym, "?"_sym); }

std::string stop_in_words(const Datum& stop) { return fmt::format("{} says stop: {}", stop[1].text(), stop[2].text()); }

}  // namespace pizarra::runtime
