#pragma once

// Divide: the indices of a system's division (equations 5.1 to 5.3 of the thesis).
//
//   const Division division = divide(system);     // of the thesis' six: 1, 1.667, 0.467

#include "programs/method/system.hpp"

namespace pizarra::method {

struct Division {
  std::size_t components = 0, first_level = 0;
  std::size_t physical = 0, performance = 0, abstraction = 0;
  std::size_t connections = 0;
  double i_cpx = 0;     // first level / all: 1 where no component is part of another
  double i_struct = 0;  // criteria met / components: above 1 some are divided for more than one reason
  double i_cnx = 0;     // connections / n (n - 1): 1 where each pair is connected both ways
};

Division divide(const System& system);

}  // namespace pizarra::method
