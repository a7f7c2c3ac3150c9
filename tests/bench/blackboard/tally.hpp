#pragma once

// When each frame of a run was sent and received by each of its subscribers, in memory that they share: made before the
// subscribers are forked.
//
//   Tally tally;
//   tally.received(subscriber, number);                 // in a subscriber
//   tally.expect(64);
//   tally.sent(number);                                 // in the publisher, before it sends
//   tally.await(number);
//   tally.last_us(number);

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

namespace pizarra::bench {

class Tally {
 public:
  static constexpr std::size_t max_subscribers = 64;
  static constexpr std::size_t max_frames = 1024;  // that are looked back at

  Tally();
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;
  ~Tally();

  void expect(std::uint32_t subscribers) { shared_->expected = subscribers; }
  void received(std::size_t subscriber, std::uint64_t number);
  void sent(std::uint64_t number);
  // Until all that are expected have it; what takes longer than ten seconds ends the bench.
  void await(std::uint64_t number);
  std::uint32_t arrived(std::uint64_t number) const { return frame(number).count; }
  // From sending to the last subscriber, and to one of them.
  double last_us(std::uint64_t number) const;
  double took_us(std::size_t subscriber, std::uint64_t number) const;

 private:
  struct Frame {
    std::atomic<std::uint32_t> count;
    std::atomic<double> sent_us;
    std::atomic<double> received_us[max_subscribers];
  };
  struct Shared {
    std::atomic<std::uint32_t> expected;
    Frame frames[max_frames];
  };
  Frame& frame(std::uint64_t number) const { return shared_->frames[number % max_frames]; }

  Shared* shared_;
  int whole_;  // an eventfd: a frame has reached everybody
};

}  // namespace pizarra::bench
