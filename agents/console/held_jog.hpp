#pragma once

// A jog that a page holds on to: the arm moves for as long as the page says so, every 50 ms. Each word counts while it
// is younger than the deadline that held when the jog began, and keeps a (hold ROBOT CLIENT COUNT) fact new, without
// which the arm stops by itself.
//
//   HeldJog jog(board, voice, requests, pulse);
//   jog.jog(form);                          // (jog N ROBOT DIRECTION STAMP); the answer says how it ended
//   jog.hold_on(form);                      // (hold-on N STAMP)
//   jog.release(form);                      // (release N)
//
// What it is given outlives it.

#include <optional>

#include "agents/console/numbered_requests.hpp"
#include "agents/console/page_board.hpp"
#include "agents/console/pulse.hpp"

namespace pizarra::console {

class HeldJog {
 public:
  HeldJog(PageBoard& board, PageVoice& voice, NumberedRequests& requests, const Pulse& pulse)
      : board_(board), voice_(voice), requests_(requests), pulse_(pulse) {}

  // It comes two ways, and counts once: the page counts its requests upwards.
  void jog(const Datum& form);
  // One at a time is on its way to the board: where that is slow, the arm stops.
  void hold_on(const Datum& form);
  void release(const Datum& form);

 private:
  struct Jog {
    std::int64_t number;  // of the request
    Datum robot;
    Duration deadline;
    bool released = false;
  };

  bool is_fresh(const Datum& stamp, Duration deadline) const;
  bool holds(const Datum& number) const;
  Task<void> jog_while_held(std::int64_t number, Datum robot, Datum direction, Duration deadline);
  Task<Result<Revision>> tell_hold(Datum robot);
  Task<void> renew_hold(Datum robot);
  Task<void> take_hold_back(Datum robot);

  PageBoard& board_;
  PageVoice& voice_;
  NumberedRequests& requests_;
  const Pulse& pulse_;
  std::optional<Jog> jog_;
  std::int64_t newest_ = 0;
  std::int64_t holds_told_ = 0;
  Job holding_;     // the newest hold on its way to the board
  Job letting_go_;  // its end
};

}  // namespace pizarra::console
