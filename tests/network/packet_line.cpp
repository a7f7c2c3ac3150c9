#include "tests/network/packet_line.hpp"

#include <algorithm>
#include <charconv>

namespace pizarra::network {

namespace {

std::optional<double> number_from(const std::string& word) {
  double number = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == word.data() + word.size();
  return whole && number >= 0 ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<LineConditions> LineConditions::from(const std::vector<std::string>& words) {
  LineConditions conditions;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "cut") {
      conditions.cut = true;
      continue;
    }
    const std::optional<double> number = i + 1 < words.size() ? number_from(words[i + 1]) : std::nullopt;
    if (!number) return std::nullopt;
    if (words[i] == "delay") {
      conditions.delay = std::chrono::milliseconds(static_cast<std::int64_t>(*number));
    } else if (words[i] == "loss" && *number <= 100) {
      conditions.loss = *number / 100;
    } else if (words[i] == "rate") {
      conditions.kbit_per_s = static_cast<std::uint64_t>(*number);
    } else {
      return std::nullopt;
    }
    ++i;
  }
  return conditions;
}

bool PacketLine::is_lost(const Packet& packet, Moment now) {
  if (conditions_.cut) return true;
  // Drawn in any case, so that one condition does not change what another loses.
  const bool unlucky = std::uniform_real_distribution<double>()(random_) < conditions_.loss;
  if (unlucky) return true;
  if (conditions_.kbit_per_s == 0) return false;
  const auto backlog = std::chrono::duration<double>(std::max(free_, now) - now);
  const double waiting = backlog.count() * static_cast<double>(conditions_.kbit_per_s) * 1000 / 8;
  return waiting + static_cast<double>(packet.size()) > most_bytes;
}

void PacketLine::take(Packet packet, Moment now) {
  if (is_lost(packet, now) || waiting_bytes_ + packet.size() > (std::size_t{16} << 20)) {
    ++lost_;
    return;
  }
  Moment sent = now;
  if (conditions_.kbit_per_s > 0) {
    const std::chrono::duration<double> takes(static_cast<double>(packet.size()) * 8 /
                                              (static_cast<double>(conditions_.kbit_per_s) * 1000));
    free_ = std::max(free_, now) + std::chrono::duration_cast<Moment::duration>(takes);
    sent = free_;
  }
  // A link keeps the order of its packets.
  Moment due = sent + conditions_.delay;
  if (!under_way_.empty()) due = std::max(due, under_way_.back().due);
  waiting_bytes_ += packet.size();
  under_way_.push_back({due, std::move(packet)});
}

std::optional<Packet> PacketLine::give(Moment now) {
  while (!under_way_.empty() && under_way_.front().due <= now) {
    Packet packet = std::move(under_way_.front().packet);
    under_way_.pop_front();
    waiting_bytes_ -= packet.size();
    // A cable that was cut delivers nothing that was in it.
    if (!conditions_.cut) return packet;
    ++lost_;
  }
  return std::nullopt;
}

std::optional<Moment> PacketLine::next() const {
  if (under_way_.empty()) return std::nullopt;
  return under_way_.front().due;
}

}  // namespace pizarra::network
