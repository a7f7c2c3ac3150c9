#pragma once

// The simulated world's truth for pages that lay it over what is believed. It comes from the world and goes to the
// page: no board ever has it. The world is asked five times a second, once for all pages, and only while one looks.
//
//   TruthFeed feed(executor, ask);                       // `ask` answers world.hpp's (truth)
//   auto look = feed.look([](const Result<Datum>& truth) { ... });
//
// The feed outlives the looks.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "blackboard/time/executor.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::console {

class TruthFeed {
 public:
  static constexpr Duration pause = 200ms;
  using Ask = std::function<Task<Result<Datum>>()>;
  using Receiver = std::function<void(const Result<Datum>&)>;

  // Destroying it ends the look.
  class Look {
   public:
    Look(TruthFeed& feed, std::uint64_t number) : feed_(feed), number_(number) {}
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
    ~Look();

   private:
    TruthFeed& feed_;
    std::uint64_t number_;
  };

  // Without `ask` there is no simulated world.
  TruthFeed(Executor& executor, Ask ask) : executor_(executor), ask_(std::move(ask)) {}
  TruthFeed(const TruthFeed&) = delete;
  TruthFeed& operator=(const TruthFeed&) = delete;

  bool is_there() const { return ask_ != nullptr; }
  std::unique_ptr<Look> look(Receiver receiver);

 private:
  Task<void> ask_on();
  void hand_out(const Result<Datum>& truth);

  Executor& executor_;
  Ask ask_;
  std::map<std::uint64_t, Receiver> receivers_;
  std::uint64_t next_ = 1;
  Job asking_;
};

}  // namespace pizarra::console
