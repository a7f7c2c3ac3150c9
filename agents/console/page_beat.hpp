#pragma once

// The stamps that go to a page and come back (pulse.hpp): 20 a second while an arm is in the page's hands, else one.
//
//   PageBeat beat(board, voice);
//   beat.start();                           // the page has been greeted
//   beat.stamp(form);                       // (stamp N)
//   beat.pulse().deadline();
//
// A page that takes in nothing gets no stamps, and what it says counts as late. What it is given outlives it.

#include "agents/console/page_board.hpp"
#include "agents/console/page_voice.hpp"
#include "agents/console/pulse.hpp"

namespace pizarra::console {

class PageBeat {
 public:
  PageBeat(PageBoard& board, PageVoice& voice);

  void start();
  void stamp(const Datum& form);
  const Pulse& pulse() const { return pulse_; }

 private:
  Task<void> keep_beating();
  Task<void> follow_hands();

  PageBoard& board_;
  PageVoice& voice_;
  Pulse pulse_;
  bool in_hand_ = false;  // an arm is
  WaitList hands_changed_;
  Job beating_;
  Job following_;
};

}  // namespace pizarra::console
