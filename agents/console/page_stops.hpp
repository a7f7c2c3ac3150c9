#pragma once

// The page's STOP: a stop fact, told never behind other requests, and whatever their number.
//
//   PageStops stops(board, voice);
//   stops.stop(form);                       // (stop N "REASON")
//
// It comes two ways, and counts once: where the slower one brings it after somebody has cleared it, it stops nothing
// anew. What it is given outlives it.

#include <string>
#include <vector>

#include "agents/console/page_board.hpp"
#include "agents/console/page_voice.hpp"

namespace pizarra::console {

class PageStops {
 public:
  PageStops(PageBoard& board, PageVoice& voice) : board_(board), voice_(voice) {}

  void stop(const Datum& form);

 private:
  Task<void> tell(std::int64_t number, std::string reason);

  PageBoard& board_;
  PageVoice& voice_;
  std::int64_t newest_ = 0;
  std::vector<Job> telling_;
};

}  // namespace pizarra::console
