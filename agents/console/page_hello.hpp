#pragma once

// The first word to a page, {"hello":{...}}: the version of the page that is served, its name, the cell as its file
// says it, what the page may not do, and where it opens lanes for images.

#include "agents/console/cell_view.hpp"
#include "agents/console/page_rights.hpp"

namespace pizarra::console {

struct PageHello {
  std::string version;  // of the page's files that are served
  int page;             // its number
  std::string name;     // on the board
  PageRights rights;
  bool truth;  // whether there is any to lay over what is believed
};

std::string hello_text(const CellView& cell, const PageHello& hello);

}  // namespace pizarra::console
