#pragma once

// Puts whoever answers messages at the device's end of a line of bytes: one client after another, what nobody takes is
// lost.
//
//   const Job serving = executor.spawn(serve_frames(executor, {.reader = frame_of_line, .answer = ...}, *port));

#include <functional>

#include "blackboard/time/executor.hpp"
#include "drivers/line/frames.hpp"

namespace pizarra::simulation {

struct FrameService {
  line::FrameReader reader;
  std::function<std::string()> greet = [] { return std::string(); };  // what a new client hears
  std::function<Task<std::string>(std::string)> answer = {};          // empty: nothing is said
  std::function<bool(std::string_view)> last = {};  // whether it hangs up after the answer; never, where there is none
};

// Until destroyed. Executor and port outlive it.
Task<void> serve_frames(Executor& executor, FrameService service, line::ByteWire& port);

}  // namespace pizarra::simulation
