#pragma once

// The pictures that a page looks at: images of streams as they come, and those that were kept. Nothing is shown of a
// stream whose fact, (stream NAME KIND PLACE), the page's own session may not read.
//
//   PagePictures pictures(board, voice, requests, images, kept);
//   pictures.look(form);                    // (look STREAM), and so on: see session.hpp
//
// Destroying it ends the looks. What it is given outlives it.

#include <map>
#include <string>

#include "agents/console/numbered_requests.hpp"
#include "agents/console/page_board.hpp"
#include "agents/console/page_images.hpp"
#include "agents/console/picture_store.hpp"

namespace pizarra::console {

class PagePictures {
 public:
  // `kept`: null where this console keeps none.
  PagePictures(PageBoard& board, PageVoice& voice, NumberedRequests& requests, PageImages& images,
               const PictureStore* kept)
      : board_(board), voice_(voice), requests_(requests), images_(images), kept_(kept) {}

  void look(const Datum& form);
  void look_away(const Datum& form);
  void picture(const Datum& form);

 private:
  Task<void> look_if_readable(std::string stream);
  Task<void> show_kept(std::int64_t number, std::string stream, Time moment);

  PageBoard& board_;
  PageVoice& voice_;
  NumberedRequests& requests_;
  PageImages& images_;
  const PictureStore* const kept_;
  std::map<std::string, Job> looks_;
};

}  // namespace pizarra::console
