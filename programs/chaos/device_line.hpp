#pragma once

// The line from a process to the devices of the simulated world, which is another process. Requests and answers take a
// little time, and what DeviceFaults says goes wrong with them does.
//
//   DeviceLine line(process, world, faults, spy);
//   Result<simulation::Message> answer = co_await line.call(request, 2s);
//
// An arm's controller may have a silence limit: where nothing reaches it for so long, it stops its arm.

#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <optional>

#include "blackboard/simulated/process.hpp"
#include "drivers/simulation/open_calls.hpp"
#include "drivers/simulation/world.hpp"
#include "programs/chaos/device_faults.hpp"

namespace pizarra::chaos {

// The world with the process that it runs in.
struct WorldProcess {
  WorldProcess(Executor& time, simulated::Process::Clock clock, std::string the_plant)
      : process(time, clock), plant(std::move(the_plant)) {}
  simulated::Process process;
  std::unique_ptr<simulation::World> world;
  DeviceFaults faults;
  // Of each request as it arrives.
  std::function<void(const std::string& from, const Datum& request)> on_request;
  // Of each motion, of the arm or its fingers, that the controller has begun.
  std::function<void(const Datum& request)> on_motion;
  // A fault that is planted (plants.hpp), and what it needs to know: the servo's state.
  std::string plant;
  std::function<int()> servo_state;
  Time stopped_at{};
  std::optional<Datum> to_repeat;
  // When a request to the arm or its answer was last lost, and when it last answered.
  Time arm_lost_at{};
  Time arm_answered_at{};
  std::optional<Duration> silence_limit;  // of the arm's controller
  Executor::TimerId silence = 0;          // runs out at the limit
  std::deque<std::vector<std::shared_ptr<const Image>>> old_images;
  std::shared_ptr<const Image> frozen_left;
  std::shared_ptr<const Image> frozen_right;
  // A frame that is to come once more.
  std::optional<simulation::Message> given_once;
  // Requests in hand, of whoever asked.
  std::list<Job> jobs;
};

class DeviceLine : public simulation::Link {
 public:
  // All outlive it. It outlives its calls.
  DeviceLine(std::string name, simulated::Process& process, WorldProcess& world)
      : name_(std::move(name)),
        process_(process),
        world_(world),
        calls_(std::make_shared<simulation::OpenCalls>(process)) {}
  Task<Result<simulation::Message>> call(Datum request, Duration timeout) override;

 private:
  const std::string name_;
  simulated::Process& process_;
  WorldProcess& world_;
  // Answers under way find it gone when their process has ended.
  const std::shared_ptr<simulation::OpenCalls> calls_;
};

}  // namespace pizarra::chaos
