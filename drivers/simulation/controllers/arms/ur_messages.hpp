#pragma once

// The primary interface's messages about programs that were not sent yet.
//
//   messages.say(ur_text_message(messages.now_us(), "popup"));
//   port.write(messages.take());

#include <cstdint>
#include <deque>
#include <string>

#include "blackboard/time/executor.hpp"

namespace pizarra::simulation {

class UrMessages {
 public:
  explicit UrMessages(Executor& executor) : executor_(executor) {}
  std::uint64_t now_us() const;
  // It is lost where `most` wait.
  void say(std::string message);
  std::string take();

 private:
  static constexpr std::size_t most = 100;

  Executor& executor_;
  std::deque<std::string> said_;
};

}  // namespace pizarra::simulation
