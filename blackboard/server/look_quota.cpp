#include "blackboard/server/look_quota.hpp"

#include <algorithm>

namespace pizarra::server {

namespace {

// Who asked then is company.
constexpr Duration lately = 100ms;

}  // namespace

void LookQuota::asked(wire::SessionId session, const std::string& client, Time now) {
  if (newest_.session != session) {
    other_asked_ = newest_.when;
    newest_.session = session;
    newest_.client = client;
  }
  newest_.when = now;
}

// Not who asks on several connections: whoever comes then would wait for a question of each.
bool LookQuota::is_alone(const std::string& client, Time now) const {
  const auto is_company = [now](std::optional<Time> asked) { return asked && now - *asked < lately; };
  return !is_company(other_asked_) && (newest_.client == client || !is_company(newest_.when));
}

LookQuota::Standing LookQuota::standing(const std::string& client, Time now) {
  if (debts_.empty()) return Standing::free;
  pay(now);
  if (is_alone(client, now)) return Standing::free;
  const auto own = debts_.find(client);
  if (own != debts_.end() && own->second >= most_owed) return Standing::spent;
  return owed_by_all_ >= most_owed_by_all && now < next_turn_ ? Standing::waits : Standing::free;
}

void LookQuota::looked(const std::string& client, std::size_t examined, Time now) {
  if (examined <= uncounted) return;
  std::size_t& own = debts_[client];
  const bool had_a_turn = owed_by_all_ >= most_owed_by_all && own < most_owed;
  if (had_a_turn) next_turn_ = std::max(next_turn_, now) + std::chrono::milliseconds(examined / paid_a_millisecond);
  owed_by_all_ -= std::min(own, most_owed);
  own += examined;
  if (is_alone(client, now)) own = std::min(own, most_kept);
  owed_by_all_ += std::min(own, most_owed);
  paid_until_ = now;
}

// Who owes less than an even part leaves the rest of it to the others.
void LookQuota::pay(Time now) {
  const auto passed = std::chrono::floor<std::chrono::milliseconds>(now - paid_until_);
  if (passed <= Duration::zero()) return;
  paid_until_ += passed;
  std::size_t left = static_cast<std::size_t>(passed.count()) * paid_a_millisecond;
  while (left > 0 && !debts_.empty()) {
    const std::size_t part = std::max(left / debts_.size(), std::size_t{1});
    for (auto& [client, debt] : debts_) {
      const std::size_t paid = std::min({part, debt, left});
      debt -= paid;
      left -= paid;
    }
    std::erase_if(debts_, [](const auto& entry) { return entry.second == 0; });
  }
  owed_by_all_ = 0;
  for (const auto& [client, debt] : debts_) owed_by_all_ += std::min(debt, most_owed);
}

std::unexpected<Failure> LookQuota::refusal(const std::string& client) {
  return fail("too-many", "the clients called " + client + " have more looked at than their share of the board's time",
              to_datum(client));
}

}  // namespace pizarra::server
