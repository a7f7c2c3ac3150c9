#pragma once

// What the rows of this bench share. A row is a function that measures and says figures.

#include "tests/bench/figures.hpp"
#include "tests/bench/vision/learned_marks.hpp"
#include "tests/bench/vision/tag_detectors.hpp"

namespace pizarra::bench {

struct VisionBench {
  Figures& figures;
  std::vector<TagDetector> peers;
  vision::LearnedObjects marks;
  std::uint64_t seed = 1;
  int scenes = 10000;
  int runs = 1000;
  int photograph_scenes = 40;
  int films = 4;
  std::string photographs = {};  // a folder with some; else they are made
};

void find_time(VisionBench& bench);     // five objects in one image; and all that one FIND is
void track_time(VisionBench& bench);    // five objects in both, with depth
void tag_time(VisionBench& bench);      // five tags in both, with depth
void recall(VisionBench& bench);        // over random scenes
void solids(VisionBench& bench);        // the same with solid convex things among the clutter
void unlearned(VisionBench& bench);     // shapes that are like the learned ones
void depth(VisionBench& bench);         // at 0.6 m
void orientation(VisionBench& bench);   // how tilted marks are turned, at 0.6 m
void photographs(VisionBench& bench);   // on photographs that are not of our renderer
void films(VisionBench& bench);         // the same of films
void sequences(VisionBench& bench);     // hidden for half a second, and moving fast
void coverings(VisionBench& bench);     // partly covered by a hand
void arrival(VisionBench& bench);       // from a frame to the fact that says what was seen, in another process
void computing(VisionBench& bench);     // what one thread does for it
void agent_memory(VisionBench& bench);  // of an agent's process

}  // namespace pizarra::bench
