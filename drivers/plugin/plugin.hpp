#pragma once

// The base of every plug-in of a driver. A plug-in is a shared library of one's own that Pizarra loads into a process
// of its own, while the robot agent keeps limits, supervision and stop. arm_plugin.hpp and camera_plugin.hpp are the
// kinds; this folder needs C++17 and no other library.
//
// Lifecycle: loaded, made once, called from one thread, one call at a time; the process ends with it, and a dead one is
// started again. What fails throws Refused; what else is thrown counts as `disconnected`. A call ends soon: within 50
// ms for an arm, since a stop waits for it.
//
//   if (!connected) throw pizarra::plugin::Refused("disconnected", "the controller has closed the line");

#include <stdexcept>
#include <string>
#include <utility>

namespace pizarra::plugin {

// Counted up with every change of these headers that a compiled plug-in would notice. Another one is refused.
inline constexpr int abi = 2;

class Refused : public std::runtime_error {
 public:
  // A symbol as of ArmDriver's failures: not-in-control, busy, joint-limit, disconnected, refused.
  Refused(std::string symbol, const std::string& sentence) : std::runtime_error(sentence), symbol_(std::move(symbol)) {}
  const std::string& symbol() const { return symbol_; }

 private:
  std::string symbol_;
};

}  // namespace pizarra::plugin
