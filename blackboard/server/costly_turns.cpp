#include "blackboard/server/costly_turns.hpp"

#include <algorithm>

namespace pizarra::server {

void CostlyTurns::took(wire::SessionId session, std::size_t examined, Time now) {
  if (examined <= out_of_turn) return;
  newest_ = session;
  others_were_heard_ = false;
  rested_ = now + Duration(examined / looks_a_us);
}

void CostlyTurns::wait(const std::string& client, wire::SessionId session) {
  std::deque<wire::SessionId>& sessions = waiting_[client];
  if (std::ranges::find(sessions, session) == sessions.end()) sessions.push_back(session);
}

wire::SessionId CostlyTurns::next() {
  auto client = waiting_.upper_bound(last_client_);
  if (client == waiting_.end()) client = waiting_.begin();
  last_client_ = client->first;
  const wire::SessionId session = client->second.front();
  client->second.pop_front();
  if (client->second.empty()) waiting_.erase(client);
  return session;
}

}  // namespace pizarra::server
