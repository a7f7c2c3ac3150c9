#pragma once

// The findings of the method, as text for people, as JSON, and as a picture for a paper.
//
//   const Report report = report_on(traffic, kinds, lists);
//   fmt::print("{}", text_of(report));
//   fmt::print("{}\n", json_of(report));
//   file << svg_of(report.system);

#include "programs/method/divide.hpp"
#include "programs/method/faults.hpp"
#include "programs/method/wrap.hpp"

namespace pizarra::method {

struct Report {
  System system;
  Division division;
  std::vector<Wrapping> wrappings;
  std::vector<Fault> faults;
  std::vector<Scale> scales;
  bool watches_seen = false;
};

Report report_on(const Traffic& traffic, const std::map<std::string, Component>& kinds,
                 const std::vector<Wrapped>& lists);
// Of a description there are neither contracts nor traffic.
Report report_on(System system);

std::string text_of(const Report& report);
std::string json_of(const Report& report);
// Components on a circle, an arrow for each connection, its pattern beside it.
std::string svg_of(const System& system);

}  // namespace pizarra::method
