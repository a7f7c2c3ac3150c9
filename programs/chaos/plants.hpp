#pragma once

// Faults of the cell's own parts, planted to see whether the observers and the judge find them: at most one in a run,
// at the seams between an agent and its board, its devices or its disk. No part of the product knows of them.
//
//   for (const Plant& plant : plants()) fmt::print("{} {}\n", plant.name, plant.sentence);
//   PlantedBoard board(inner, process, "robot", "stop-unheard");

#include <string>
#include <vector>

namespace pizarra::chaos {

struct Plant {
  const char* name;
  const char* sentence;
};
const std::vector<Plant>& plants();
bool is_plant(const std::string& name);

}  // namespace pizarra::chaos
