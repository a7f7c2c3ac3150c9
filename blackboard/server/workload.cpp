#include "blackboard/server/workload.hpp"

#include "blackboard/limits.hpp"

namespace pizarra::server {

Workload::~Workload() {
  if (timer_ != 0) executor_.cancel(timer_);
}

void Workload::took_for_request(wire::SessionId session, std::size_t examined) {
  took(session, examined);
  for_requests_ += examined;
}

void Workload::wait(const std::string& client, wire::SessionId session) {
  costly_.wait(client, session);
  schedule();
}

void Workload::schedule() {
  if (timer_ != 0) return;
  // Not at once: what is due at once is done several times before anybody is heard.
  const Time soon = executor_.now() + 1us;
  timer_ = executor_.call_at(costly_.is_resting(soon) ? costly_.rested() : soon, [this] {
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
