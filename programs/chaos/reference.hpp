#pragma once

// The outcome of some runs, kept as a file. Later code must do no worse with the same seeds: no more runs fail, are
// unsafe or hang, and every point of the coverage that they came to often is come to again.
//
//   Result<Reference> reference = read_reference("chaos-coverage.txt");
//   for (const std::string& sentence : worse_than(*reference, reference_of(1, tally))) ...
//
// A line each: "runs 200", "first-seed 1", "failed 3", "unsafe 0", "hung 0", and then "POINT COUNT".

#include "programs/chaos/tally.hpp"

namespace pizarra::chaos {

struct Reference {
  std::uint64_t runs = 0;
  std::uint64_t first_seed = 0;
  std::uint64_t failed = 0;
  std::uint64_t unsafe = 0;
  std::uint64_t hung = 0;
  Coverage coverage;
};

Reference reference_of(std::uint64_t first_seed, const Tally& tally);
std::string text_of(const Reference& reference);

// Failures: bad-reference, with the file and line.
Result<Reference> read_reference(const std::string& file);

// A sentence each; none: not worse. Both are of the same seeds.
std::vector<std::string> worse_than(const Reference& reference, const Reference& now);
// Counts that went down: the file is to be written anew, so that they stay there.
std::vector<std::string> better_than(const Reference& reference, const Reference& now);

}  // namespace pizarra::chaos
