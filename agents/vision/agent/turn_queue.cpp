#include "agents/vision/agent/turn_queue.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ranges>

namespace pizarra::vision {

std::optional<std::size_t> TurnQueue::position(int number) const {
  const auto found = std::ranges::find(turns_, number, &Turn::number);
  if (found == turns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - turns_.begin());
}

std::size_t TurnQueue::count_of(const std::string& client) const {
  return static_cast<std::size_t>(std::ranges::count(turns_, client, &Turn::client));
}

Result<int> TurnQueue::enter(const std::string& client, Kind kind, Time now) {
  const std::size_t own = count_of(client);
  if (own >= most_of_one) {
    return fail("busy", fmt::format("{} requests of {} wait already", own, client), Datum::symbol(client));
  }
  const bool full = turns_.size() >= most && (own > 0 || !make_room());
  if (full) return fail("busy", "vision is asked for too much at once", Datum::symbol(client));
  turns_.push_back({.number = ++last_number_, .client = client, .kind = kind});
  if (own == 0) line_up(client, now);
  return last_number_;
}

bool TurnQueue::make_room() {
  const auto most_asking =
      std::ranges::max_element(turns_, {}, [this](const Turn& turn) { return count_of(turn.client); });
  if (count_of(most_asking->client) == 1) return false;
  const auto last = std::ranges::find(turns_ | std::views::reverse, most_asking->client, &Turn::client);
  turns_.erase(last.base() - 1);
  return true;
}

void TurnQueue::line_up(const std::string& client, Time now) {
  const auto first = std::ranges::find(turns_, client, &Turn::client);
  if (first == turns_.end()) return;
  const auto kept = kept_places_.extract(client);
  first->place = kept.empty() ? ++last_place_ : kept.mapped();
  first->first_since = now;
}

bool TurnQueue::is_first_of_its_client(int number) const { return turns_[*position(number)].place != 0; }

bool TurnQueue::is_next(int number) const {
  const Turn& mine = turns_[*position(number)];
  if (mine.place == 0) return false;
  if (mine.kind == Kind::beside) return true;
  return std::ranges::none_of(turns_, [&](const Turn& other) {
    if (other.kind == Kind::beside || other.place == 0 || other.number == number) return false;
    return other.begun || other.rank() < mine.rank();
  });
}

std::string TurnQueue::served() const {
  const Turn* served = nullptr;
  for (const Turn& turn : turns_) {
    if (turn.kind == Kind::beside || turn.place == 0) continue;
    if (turn.begun) return turn.client;
    if (served == nullptr || turn.rank() < served->rank()) served = &turn;
  }
  return served == nullptr ? "" : served->client;
}

void TurnQueue::leave(int number, Time now) {
  const std::optional<std::size_t> at = position(number);
  if (!at) return;
  const Turn left = turns_[*at];
  turns_.erase(turns_.begin() + static_cast<std::ptrdiff_t>(*at));
  if (left.place == 0) return;
  if (!left.begun) keep_place(left);
  line_up(left.client, now);
}

void TurnQueue::keep_place(const Turn& turn) {
  kept_places_.insert_or_assign(turn.client, turn.place);
  if (kept_places_.size() <= most) return;
  kept_places_.erase(std::ranges::min_element(kept_places_, {}, [](const auto& kept) { return kept.second; }));
}

}  // namespace pizarra::vision
