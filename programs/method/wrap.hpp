#pragma once

// Wrap: how much a component hides of what it wraps (equation 4.4), and which parts of a wrapper it has.
//
//   const std::vector<Wrapped> lists = known_wrapped().value();       // drivers/*/wrapped.scm
//   for (const Wrapping& wrapping : wrap(traffic, lists, kinds)) wrapping.indices.front().value;    // 17/182 = 0.093

#include <array>

#include "programs/method/description.hpp"

namespace pizarra::method {

// Of the interface: abstraction, monitoring, configuration; of the code between: the others.
inline constexpr std::array wrapper_parts = {"abstraction",    "monitoring",   "configuration", "transformation",
                                             "interpretation", "distribution", "collection",    "processing"};

struct AbstractionIndex {
  std::string wrapped;
  std::size_t operations = 0;  // of the wrapper, that stand for it
  std::size_t functions = 0;
  double value = 0;
};

struct Wrapping {
  std::string component;
  std::size_t offered = 0;
  std::vector<AbstractionIndex> indices;
  std::set<std::string> parts;
};

std::vector<Wrapping> wrap(const Traffic& traffic, const std::vector<Wrapped>& lists,
                           const std::map<std::string, Component>& kinds);

}  // namespace pizarra::method
