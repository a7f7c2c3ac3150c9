#include "agents/vision/objects/look_alike.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/vision/objects/mark_choice.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::vision {

std::vector<Datum> look_alikes(const LearnedObjects& objects) {
  std::vector<Datum> out;
  for (std::size_t later = 1; later < objects.all().size(); ++later) {
    for (std::size_t i = 0; i < later; ++i) {
      const LearnedObject& object = objects.all()[later];
      const LearnedObject& other = objects.all()[i];
      const double error = likeness_error(object, other);
      if (error >= alike_below) continue;
      const double told = rounded(error, 1000);
      const std::string sentence =
          fmt::format("{} and {} look much alike: they differ by {}, where {} is safe; one may be taken for the other",
                      object.name, other.name, told, alike_below);
      out.push_back(list("look-alike"_sym, object.name, other.name, told, sentence));
    }
  }
  return out;
}

}  // namespace pizarra::vision
