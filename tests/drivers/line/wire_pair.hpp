#pragma once

// The two ends of a line of bytes in virtual time, which may be cut, garbled and mended; the device's end may hang up.
//
//   WirePair line(executor);
//   UniversalArm arm(..., line.near, ...);      // who drives
//   serve_rtde(executor, emulator, line.far);   // the device

#include <functional>

#include "blackboard/time/latch.hpp"
#include "drivers/line/byte_wire.hpp"

namespace pizarra::line {

class WirePair {
 public:
  class End : public ByteWire {
   public:
    End(Executor& executor, WirePair& pair, bool device) : pair_(pair), device_(device), come_(executor) {}
    std::function<std::string(std::string)> spoil = {};  // what becomes of what is written here
    std::string written = {};                            // all of it

    Task<Result<void>> open(Time deadline) override {
      if (!device_ && pair_.cut_) co_return fail("disconnected", "the line is cut");
      if (!device_) {
        unread_.clear();
        pair_.far.unread_.clear();
        ++pair_.connections_;
        pair_.far.come_.wake_all();
      }
      // A device waits for somebody, as a port does.
      while (device_ && served_ == pair_.connections_) {
        const bool woken = co_await come_.wait(deadline);
        if (!woken) co_return fail("timeout", "nobody connected");
      }
      served_ = pair_.connections_;
      co_return Result<void>();
    }
    void close() override {
      if (!device_) return;
      pair_.hung_up_ = served_;
      pair_.near.come_.wake_all();
    }
    Result<void> write(std::string_view bytes) override {
      if (over()) return fail("disconnected", "the line is cut");
      written += bytes;
      End& other = device_ ? pair_.near : pair_.far;
      other.unread_ += spoil ? spoil(std::string(bytes)) : std::string(bytes);
      other.come_.wake_all();
      return {};
    }
    Task<Result<std::string>> read(Time deadline) override {
      while (unread_.empty() && !over()) {
        const bool woken = co_await come_.wait(deadline);
        if (!woken) co_return fail("timeout", "nothing came");
      }
      // What came over a connection is of no other.
      if (unread_.empty() || (device_ && over())) co_return fail("disconnected", "the line is cut");
      co_return std::exchange(unread_, {});
    }

   private:
    friend class WirePair;
    bool over() const {
      const bool of_another = device_ && served_ != pair_.connections_;
      return pair_.cut_ || pair_.hung_up_ == pair_.connections_ || of_another;
    }
    WirePair& pair_;
    bool device_;
    std::string unread_;
    int served_ = 0;
    WaitList come_;
  };

  explicit WirePair(Executor& executor) : near(executor, *this, false), far(executor, *this, true) {}
  End near;
  End far;

  void cut(bool now) {
    cut_ = now;
    near.unread_.clear();
    far.unread_.clear();
    near.come_.wake_all();
    far.come_.wake_all();
  }

 private:
  bool cut_ = false;
  int connections_ = 0;
  int hung_up_ = 0;  // the last connection that the device has ended
};

}  // namespace pizarra::line
