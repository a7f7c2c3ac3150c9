#include "blackboard/cluster/troubles.hpp"

#include <algorithm>

namespace pizarra::cluster {

namespace {

constexpr Duration first_pause = 1s;
constexpr Duration quiet = std::chrono::minutes(10);

}  // namespace

bool Troubles::Gate::opens(Time now) {
  if (now < next_) return false;
  pause_ = now > next_ + quiet ? first_pause : std::clamp(2 * pause_, first_pause, longest_);
  next_ = now + pause_;
  return true;
}

std::optional<std::string> Troubles::news(const Result<void>& result, Time now) {
  std::string sentence = result ? "" : describe(result.error());
  if (sentence == said_) return std::nullopt;
  Gate& gate = sentence.empty() == said_.empty() ? sentences_ : turns_;
  if (!gate.opens(now)) return std::nullopt;
  said_ = std::move(sentence);
  return said_.empty() ? "the log answers again" : said_;
}

}  // namespace pizarra::cluster
