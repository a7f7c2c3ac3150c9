#pragma once

// The work of a served board, in turns: what costs much is done a part at a time, and everybody is heard between the
// parts. One client has a turn at a time, however many sessions it has. After a turn everybody is heard for as long as
// the turn took; where only one session speaks, no such rest is needed. So costly questions take half of the board's
// time at most while others speak, and nobody waits for more than one.
//
//   Workload workload(executor);
//   workload.on_turn = [this] { serve_on(); };       // when somebody waits, and the board has rested
//   workload.heard(id);                              // whatever it says
//   if (!workload.is_free()) workload.wait(session.client(), id);
//   ...
//   workload.took(id, examined);                     // so many facts were looked at for it
//   ...
//   workload.begin();                                // in on_turn
//   for (std::size_t left = workload.clients(); left > 0 && workload.has_room(); --left) serve(workload.next());

#include <deque>
#include <functional>
#include <map>
#include <string>

#include "blackboard/time/executor.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

class Workload {
 public:
  // The work that a request may do out of its turn: a tenth of a millisecond.
  static constexpr std::size_t out_of_turn = 1000;

  explicit Workload(Executor& executor) : executor_(executor) {}
  Workload(const Workload&) = delete;
  Workload& operator=(const Workload&) = delete;
  ~Workload();

  std::function<void()> on_turn;

  void heard(wire::SessionId session) { others_were_heard_ = others_were_heard_ || session != newest_; }
  // So many facts were looked at for it.
  void took(wire::SessionId session, std::size_t examined);
  void took_for_request(wire::SessionId session, std::size_t examined);
  // Whether nobody waits, and a turn may begin at once.
  bool is_free() const { return waiting_.empty() && !is_resting(); }
  bool is_resting() const { return rests_at(executor_.now()); }
  // Its turn comes behind what waits of its client.
  void wait(const std::string& client, wire::SessionId session);
  // Has a turn come for the board's own work.
  void schedule();

  // A turn: what it has cost, and who has it next.
  void begin();
  void spend(std::size_t examined) { examined_ += examined; }
  std::size_t examined() const { return examined_; }
  bool has_room() const;
  bool empty() const { return waiting_.empty(); }
  std::size_t clients() const { return waiting_.size(); }
  // Of the next client; it must not be empty.
  wire::SessionId next();

  // The requests of the frame that is being heard.
  void begin_frame() { before_frame_ = for_requests_; }
  bool frame_had_its_turn() const;
  std::size_t for_requests() const { return for_requests_; }

 private:
  bool rests_at(Time when) const { return others_were_heard_ && when < rested_; }

  Executor& executor_;
  std::map<std::string, std::deque<wire::SessionId>> waiting_;  // by client
  std::string last_client_;
  wire::SessionId newest_ = 0;  // that had a turn
  bool others_were_heard_ = false;
  Time rested_{};
  std::size_t examined_ = 0;      // in this turn
  std::size_t for_requests_ = 0;  // facts looked at, in all
  std::size_t before_frame_ = 0;  // of these, before the frame that is being heard
  Executor::TimerId timer_ = 0;
};

}  // namespace pizarra::server
