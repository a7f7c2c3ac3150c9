#pragma once

// The simulated world's pan-tilt unit and the near end of its line: what drivers say reaches it as bytes, and what it
// says waits here until it is heard. The requests stand in world.hpp.
//
// Lifecycle: the world makes it with its cell; the executor outlives it.
//
//   HeadLine line(executor, model);
//   Result<Message> heard = co_await line.handle(request);

#include "drivers/simulation/controllers/ptu_emulator.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::simulation {

class HeadLine {
 public:
  HeadLine(Executor& executor, const PtuModel& model);
  PtuEmulator& unit() { return unit_; }
  Task<Result<Message>> handle(Datum request);

 private:
  static constexpr std::size_t most_unheard = 4096;
  static constexpr Duration hearing_time = 50ms;
  Task<Result<Message>> hear();

  Executor& executor_;
  PtuEmulator unit_;
  std::string unheard_;
  WaitList said_;
};

}  // namespace pizarra::simulation
