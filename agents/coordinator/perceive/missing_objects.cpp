#include "agents/coordinator/perceive/missing_objects.hpp"

#include <fmt/format.h>

namespace pizarra::coordinator {

Failure missing_objects(const std::vector<std::string>& names) {
  std::string listed;
  std::vector<Datum> subject;
  for (std::size_t i = 0; i < names.size(); ++i) {
    listed += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    subject.push_back(Datum::symbol(names[i]));
  }
  const bool one = names.size() == 1;
  return {"missing-object",
          fmt::format("{} {} not seen", listed, one ? "is" : "are"),
          one ? subject.front() : Datum::list(std::move(subject)),
          {}};
}

std::vector<std::string> names_of_missing(const Failure& failure) {
  if (failure.subject.is_symbol()) return {std::string(failure.subject.text())};
  std::vector<std::string> names;
  for (const Datum& name : failure.subject.items()) names.emplace_back(name.text());
  return names;
}

}  // namespace pizarra::coordinator
