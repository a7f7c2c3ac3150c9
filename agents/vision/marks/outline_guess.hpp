#pragma once

// Where an image may show an outline of which a part is enough: a hidden mark's, or one that a shadow's edge or another
// thing joins with what is beside it.
//
//   for (const OutlineGuess& guess : outline_guesses(edges, outline, MarkTone::dark, {4, 40}, 0.4)) ...
//
// Two places of an edge, with the ways to their lighter sides, and two of the outline that lie to each other alike,
// make a turn, a size and a place (B. Drost et al., Model globally, match locally, CVPR 2010: pairs of oriented points,
// here in a plane). Each such guess is tried on the edges all around the outline. It faces the camera: a face that is
// turned away by more than some 25 degrees is not guessed.

#include "agents/vision/marks/edge_chains.hpp"
#include "agents/vision/marks/mark_patch.hpp"
#include "agents/vision/marks/plane_outline.hpp"

namespace pizarra::vision {

struct OutlineGuess {
  cv::Matx33d to_image;  // from the outline's plane
  double shown = 0;      // the part of the outline where edges are
};

// How large: px a standard deviation.
struct SizeRange {
  double least_px;
  double most_px;
};

// Those with the longest edges first, of each place and size one; no more than most_guesses.
std::vector<OutlineGuess> outline_guesses(const EdgeChains& edges, const PlaneOutline& outline, MarkTone tone,
                                          const SizeRange& sizes, double least_shown);
inline constexpr std::size_t most_guesses = 512;

}  // namespace pizarra::vision
