#pragma once

// The strict reading of a text (reader.hpp), for those who go on where it cannot be read.
//
//   StrictReading read = read_strictly(text, limits, &spots);
//   if (!read.data) mend(text, read.trouble);

#include <optional>
#include <vector>

#include "lisp/reader.hpp"

namespace pizarra {

struct StrictReading {
  std::optional<std::vector<Datum>> data;
  SourceError trouble;  // the first, where there are no data
};

// Fills `spots`, which may be null.
StrictReading read_strictly(std::string_view text, const ReadLimits& limits, std::vector<Spot>* spots);

}  // namespace pizarra
