#include "blackboard/server/workload.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"

namespace pizarra::server {

namespace {

constexpr std::size_t looks_a_us = 10;

}  // namespace

Workload::~Workload() {
  if (timer_ != 0) executor_.cancel(timer_);
}

void Workload::took(wire::SessionId session, std::size_t examined) {
  if (examined <= out_of_turn) return;
  newest_ = session;
  others_were_heard_ = false;
  rested_ = executor_.now() + Duration(examined / looks_a_us);
}

void Workload::took_for_request(wire::SessionId session, std::size_t examined) {
  took(session, examined);
  for_requests_ += examined;
}

void Workload::wait(const std::string& client, wire::SessionId session) {
  std::deque<wire::SessionId>& sessions = waiting_[client];
  if (std::ranges::find(sessions, session) == sessions.end()) sessions.push_back(session);
  schedule();
}

wire::SessionId Workload::next() {
  auto client = waiting_.upper_bound(last_client_);
  if (client == waiting_.end()) client = waiting_.begin();
  last_client_ = client->first;
  const wire::SessionId session = client->second.front();
  client->second.pop_front();
  if (client->second.empty()) waiting_.erase(client);
  return session;
}

void Workload::schedule() {
  if (timer_ != 0) return;
  // Not at once: what is due at once is done several times before anybody is heard.
  const Time soon = executor_.now() + 1us;
  timer_ = executor_.call_at(rests_at(soon) ? rested_ : soon, [this] {
    timer_ = 0;
    if (is_resting()) return schedule();
    on_turn();
  });
}

void Workload::begin() {
  examined_ = 0;
  begin_frame();
}

bool Workload::has_room() const { return examined_ < limits::examined_a_turn; }

bool Workload::frame_had_its_turn() const { return for_requests_ - before_frame_ >= limits::examined_a_turn; }

}  // namespace pizarra::server
