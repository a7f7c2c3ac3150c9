#pragma once

// Ends the program where the clock is over while files are read: what is read may never end, such as a pipe that nobody
// writes to, and no reader asks for the time.
//
//   PlanClock clock(10.0);
//   {
//     const ReadingWatch watch(clock, [&] { return report(clock); });
//     task = read_task_files(domain, problem);
//   }
//
// While there is one, nobody else asks the clock.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "programs/plan/plan_clock.hpp"

namespace pizarra::programs {

class ReadingWatch {
 public:
  // `report` says what has happened and answers the exit status; the program ends with it at once.
  ReadingWatch(PlanClock& clock, std::function<int()> report);
  ReadingWatch(const ReadingWatch&) = delete;
  ReadingWatch& operator=(const ReadingWatch&) = delete;

 private:
  void watch(const std::stop_token& read, PlanClock& clock, const std::function<int()>& report);

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // the last: it ends before what it waits on
};

}  // namespace pizarra::programs
