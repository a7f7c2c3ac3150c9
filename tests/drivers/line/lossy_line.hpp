#pragma once

// A line of datagrams in virtual time to whatever answers them, which loses, repeats and delays them both ways as its
// seed says.
//
//   LossyLine line(executor, Random(seed), [&](std::string datagram) { return emulator.answer(std::move(datagram)); });
//   line.loss = 0.2;

#include <functional>
#include <list>

#include "blackboard/time/latch.hpp"
#include "blackboard/time/random.hpp"
#include "drivers/line/datagram_wire.hpp"

namespace pizarra::line {

class LossyLine : public DatagramWire {
 public:
  using Device = std::function<Task<std::string>(std::string)>;
  LossyLine(Executor& executor, Random random, Device device)
      : executor_(executor), random_(random), device_(std::move(device)), come_(executor) {}

  double loss = 0;
  double duplication = 0;
  Duration longest_delay = 1ms;
  bool pulled = false;                                       // the plug
  std::function<std::string(std::string)> from_device = {};  // what becomes of what it says
  std::uint64_t sent = 0;
  std::uint64_t lost = 0;
  std::uint64_t repeated = 0;

  Task<Result<void>> open(Time) override {
    if (pulled) co_return fail("disconnected", place() + " is not reached: the plug is out");
    heard_.clear();
    co_return Result<void>();
  }
  void close() override {}
  std::string place() const override { return "the end of a lossy line"; }
  Result<void> send(std::string_view datagram) override {
    for (int copies = copies_of_one(); copies > 0; --copies) begin(carry(std::string(datagram)));
    return {};
  }
  Task<Result<std::string>> receive(Time deadline) override {
    while (heard_.empty()) {
      const bool woken = co_await come_.wait(deadline);
      if (!woken) co_return fail("timeout", "nothing came");
    }
    std::string datagram = std::move(heard_.front());
    heard_.pop_front();
    co_return datagram;
  }

 private:
  int copies_of_one() {
    ++sent;
    const bool none = pulled || random_.uniform(0, 1) < loss;
    lost += none ? 1 : 0;
    if (none) return 0;
    const bool two = random_.uniform(0, 1) < duplication;
    repeated += two ? 1 : 0;
    return two ? 2 : 1;
  }
  Duration delay() {
    return Duration(static_cast<Duration::rep>(random_.below(static_cast<std::uint64_t>(longest_delay.count()) + 1)));
  }
  void begin(Task<void> task) {
    under_way_.remove_if([](const Job& job) { return job.done(); });
    under_way_.push_back(executor_.spawn(std::move(task)));
  }
  Task<void> carry(std::string datagram) {
    co_await sleep(executor_, delay());
    std::string said = co_await device_(std::move(datagram));
    if (from_device) said = from_device(std::move(said));
    if (said.empty()) co_return;
    for (int copies = copies_of_one(); copies > 0; --copies) begin(bring(said));
  }
  Task<void> bring(std::string datagram) {
    co_await sleep(executor_, delay());
    heard_.push_back(std::move(datagram));
    come_.wake_all();
  }

  Executor& executor_;
  Random random_;
  Device device_;
  std::deque<std::string> heard_;
  WaitList come_;
  std::list<Job> under_way_;
};

}  // namespace pizarra::line
