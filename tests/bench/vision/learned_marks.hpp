#pragma once

// The five marks as the eyes learn them: by a click on each, in a quiet scene.

#include "agents/vision/sight/mark_learner.hpp"
#include "tests/bench/vision/scene.hpp"

namespace pizarra::bench {

// The five in a row, at scale 1.
Scene learning_scene();

// Throws where one cannot be learned.
vision::LearnedObjects learn_marks(std::uint64_t seed);

}  // namespace pizarra::bench
