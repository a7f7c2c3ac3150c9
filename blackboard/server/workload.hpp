#pragma once

// The work of a served board, in turns: what costs much is done a part at a time, and everybody is heard between the
// parts. It counts what the turn and the frame in hand have cost.
//
//   Workload workload(executor);
//   workload.on_turn = [this] { serve_on(); };       // when somebody waits, and the board has rested
//   workload.wait(session.client(), id);
//   ...
//   workload.begin();                                // in on_turn
//   for (std::size_t left = workload.clients(); left > 0 && workload.has_room(); --left) serve(workload.next());

#include <functional>

#include "blackboard/server/costly_turns.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::server {

class Workload {
 public:
  explicit Workload(Executor& executor) : executor_(executor) {}
  Workload(const Workload&) = delete;
  Workload& operator=(const Workload&) = delete;
  ~Workload();

  std::function<void()> on_turn;

  void heard(wire::SessionId session) { costly_.heard(session); }
  // So many facts were looked at for it.
  void took(wire::SessionId session, std::size_t examined) { costly_.took(session, examined, executor_.now()); }
  void took_for_request(wire::SessionId session, std::size_t examined);
  bool is_free() const { return costly_.is_free(executor_.now()); }
  bool is_resting() const { return costly_.is_resting(executor_.now()); }
  // Its turn comes behind what waits of its client.
  void wait(const std::string& client, wire::SessionId session);
  // Has a turn come for the board's own work.
  void schedule();

  // A turn: what it has cost, and who has it next.
  void begin();
  void spend(std::size_t examined) { examined_ += examined; }
  std::size_t examined() const { return examined_; }
  bool has_room() const;
  bool empty() const { return costly_.empty(); }
  std::size_t clients() const { return costly_.clients(); }
  wire::SessionId next() { return costly_.next(); }

  // The requests of the frame that is being heard.
  void begin_frame() { before_frame_ = for_requests_; }
  bool frame_had_its_turn() const;
  std::size_t for_requests() const { return for_requests_; }

 private:
  Executor& executor_;
  CostlyTurns costly_;
  std::size_t examined_ = 0;      // in this turn
  std::size_t for_requests_ = 0;  // facts looked at, in all
  std::size_t before_frame_ = 0;  // of these, before the frame that is being heard
  Executor::TimerId timer_ = 0;
};

}  // namespace pizarra::server
