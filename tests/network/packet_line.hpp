#pragma once

// One direction of a link between two hosts: it takes packets and gives them back later, or not at all.
//
//   PacketLine line(seed);
//   Result of reading "delay 80 loss 1 rate 1000 cut":  line.set(*LineConditions::from(words));
//   line.take(packet, now);                 // lost, or on its way
//   while (auto packet = line.give(now)) ...
//   line.next();                            // when the next one is due, if one is under way
//
// Packets under way when the conditions change keep their times. The same seed loses the same packets.

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace pizarra::network {

using Moment = std::chrono::steady_clock::time_point;
using Packet = std::vector<std::uint8_t>;

struct LineConditions {
  std::chrono::milliseconds delay{0};
  double loss = 0;               // of 1
  std::uint64_t kbit_per_s = 0;  // 0: no limit
  bool cut = false;

  // Words such as `delay 80 loss 1 rate 1000 cut`: milliseconds, percent, kbit/s. None: nothing is the matter.
  static std::optional<LineConditions> from(const std::vector<std::string>& words);
};

class PacketLine {
 public:
  // What is more than that waits nowhere: as in a router, it is lost.
  static constexpr std::size_t most_bytes = 128 << 10;

  explicit PacketLine(std::uint64_t seed) : random_(seed) {}
  void set(const LineConditions& conditions) { conditions_ = conditions; }
  void take(Packet packet, Moment now);
  std::optional<Packet> give(Moment now);
  std::optional<Moment> next() const;
  std::uint64_t lost() const { return lost_; }

 private:
  struct UnderWay {
    Moment due;
    Packet packet;
  };
  bool is_lost(const Packet& packet, Moment now);

  LineConditions conditions_;
  std::mt19937_64 random_;
  Moment free_{};  // when the last packet will have been sent
  std::deque<UnderWay> under_way_;
  std::size_t waiting_bytes_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace pizarra::network
