#include "programs/method/divide.hpp"

namespace pizarra::method {

Division divide(const System& system) {
  Division division;
  for (const Component& component : system.components) {
    ++division.components;
    division.first_level += component.level == 1 ? 1 : 0;
    division.physical += component.physical ? 1 : 0;
    division.performance += component.performance ? 1 : 0;
    division.abstraction += component.abstraction ? 1 : 0;
    division.connections += static_cast<std::size_t>(component.connections);
  }
  const auto n = static_cast<double>(division.components);
  if (division.components == 0) return division;
  division.i_cpx = static_cast<double>(division.first_level) / n;
  division.i_struct = static_cast<double>(division.physical + division.performance + division.abstraction) / n;
  if (division.components > 1) division.i_cnx = static_cast<double>(division.connections) / (n * (n - 1));
  return division;
}

}  // namespace pizarra::method
