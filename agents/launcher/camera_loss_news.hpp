#pragma once

// News of a cell's cameras, in sentences: when one is lost and why, when it gives images again, and the first time that
// images of it are left out and why.
//
//   CameraLossNews news;
//   news.sentence_of(camera_state);                // "vision has no images: the camera: /dev/video0 cannot be opened"
//   Job told = executor.spawn(log_camera_losses(board, "vision", stderr));     // a line each, until destroyed

#include <cstdio>
#include <map>
#include <set>
#include <string>

#include "blackboard/board.hpp"

namespace pizarra::launcher {

class CameraLossNews {
 public:
  // Of a (camera-state EYES STATE TROUBLE); empty: it is no news.
  std::string sentence_of(const Datum& camera_state);

 private:
  std::map<std::string, std::string> troubles_;  // of the eyes whose camera is lost
  std::set<std::string> leaving_out_;            // eyes of which that was said
};

// Of these eyes alone. The board outlives it.
Task<void> log_camera_losses(Board& board, std::string eyes, std::FILE* out);

}  // namespace pizarra::launcher
