#include "blackboard/server/look_quota.hpp"

#include <algorithm>

namespace pizarra {

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

bool LookQuota::is_spent(const std::string& client, Time now) {
  if (debts_.empty()) return false;
  pay(now);
  if (is_alone(client, now)) return false;
  if (owed_by_all_ >= most_owed_by_all) return true;
  const auto own = debts_.find(client);
  return own != debts_.end() && own->second >= most_owed;
}

void LookQuota::looked(const std::string& client, std::size_t examined, Time now) {
  if (examined <= uncounted) return;
  std::size_t& own = debts_[client];
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

std::unexpected<Failure> LookQuota::refusal(const std::string& client) const {
  const auto own = debts_.find(client);
  const bool own_doing = own != debts_.end() && own->second >= most_owed;
  const std::string who = own_doing ? "the clients called " + client + " have" : std::string("several clients have");
  const std::string share = own_doing ? "their share of the board's time" : "the board has time for at present";
  return fail("too-many", who + " more looked at than " + share, to_datum(client));
}

}  // namespace pizarra
