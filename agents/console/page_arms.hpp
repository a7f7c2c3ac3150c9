#pragma once

// Where the links of every known arm are, told to a page as its joints change: {"arm":NAME,"points":[...],...}.
//
//   PageArms arms(board, voice, cell);                    // follows (arm-joints ROBOT JOINTS) from now on
//   arms.say(answers, "1700000000000000");                // where they were then, from answers of the past
//
// What it is given outlives it.

#include <string>
#include <vector>

#include "agents/console/cell_view.hpp"
#include "agents/console/page_board.hpp"
#include "agents/console/page_voice.hpp"

namespace pizarra::console {

class PageArms {
 public:
  PageArms(PageBoard& board, PageVoice& voice, const CellView& cell);
  // Those of the answers that are joints of an arm that is known here. `past`: the moment; empty: now.
  void say(const std::vector<Answer>& answers, const std::string& past);

 private:
  Task<void> follow(Board& board);

  PageVoice& voice_;
  const CellView& cell_;
  const Job following_;
};

}  // namespace pizarra::console
