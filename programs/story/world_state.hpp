#pragma once

// The state of the simulated world, for the judge alone: nothing of it reaches an agent.
//
//   Result<WorldState> truth = co_await read_world_state(link);
//   if (truth) truth->cubes.at("circle").visible ...

#include <map>
#include <string>
#include <vector>

#include "drivers/simulation/link.hpp"

namespace pizarra::story {

struct WorldState {
  struct Cube {
    double x_mm = 0;
    double y_mm = 0;
    double z_mm = 0;
    double yaw_deg = 0;  // of its sides against the base's axes, -45..45
    bool gone = false;
    bool held = false;
    std::string on;      // the cube that it stands squarely on
    bool loose = false;  // neither stands on a face nor is held: it leans, falls, or a hand carries it
    double visible = 0;  // the part of its mark that both cameras see, 0..1
  };
  std::map<std::string, Cube> cubes;  // by the name, in small letters
};

Result<WorldState> world_state_from_datum(const Datum& head);
Task<Result<WorldState>> read_world_state(simulation::Link& link);

// A fact with its names in small letters, as the world and goals are compared.
Datum in_small_letters(const Datum& fact);

}  // namespace pizarra::story
