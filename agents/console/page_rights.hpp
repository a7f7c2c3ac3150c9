#pragma once

// The key of a page forbids some of its words. The page is told which and why, and shows their buttons disabled: what
// the person may not do, and for the administrator the relation that the key lacks. The board holds it to that,
// whatever it shows.
//
//   const PageRights rights = co_await rights_of(board);         // asks the board once (own-permission)
//   rights.refused();       {{"goal", "your key may not give goals (it lacks: tell request)"}, ...}, by the page's
//   words

#include <map>
#include <string>
#include <vector>

#include "blackboard/board.hpp"

namespace pizarra::console {

class PageRights {
 public:
  // As keys list them.
  PageRights(std::vector<std::string> tell, std::vector<std::string> read)
      : tell_(std::move(tell)), read_(std::move(read)) {}

  // Of the words that a page says (session.hpp), those that need more than it may, and why.
  std::map<std::string, std::string> refused() const;

 private:
  std::vector<std::string> tell_;
  std::vector<std::string> read_;
};

// Everything, where the board does not know this question: it refuses by itself what it must.
Task<PageRights> rights_of(Board& board);

}  // namespace pizarra::console
