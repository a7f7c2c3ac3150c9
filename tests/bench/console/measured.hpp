#pragma once

// What the browser measured, as measure.mjs prints it: a line `NAME VALUE` a figure, and what it says beside that.
//
//   const Measured loopback = measure({node, script, "--cell", PIZARRA_CELL, ...});
//   loopback.value("interval-mean");                    // nothing: it could not be measured

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pizarra::bench {

struct Measured {
  std::map<std::string, double> values;
  std::string trouble;  // why there are none

  std::optional<double> value(const std::string& name) const;
};

// Runs it to its end. A line that is one word is an order, for who obeys them.
Measured measure(const std::vector<std::string>& command, const std::function<void(const std::string&)>& obey = {});

}  // namespace pizarra::bench
