#include "programs/chaos/plant_search.hpp"

#include "programs/story/seed_pool.hpp"

namespace pizarra::chaos {

PlantSearch find_plant(const SwarmOptions& options) {
  const auto work = [&](std::uint64_t seed) -> std::string {
    const ChaosStory story = draw_story(options.cell, seed, options.only);
    const bool fails = play_quietly(story, {.plant = options.plant}).has_failed();
    return fails && !play_quietly(story, {}).has_failed() ? "found" : "not";
  };
  PlantSearch search;
  story::SeedPool pool(
      {.first = options.first_seed, .seeds = options.runs, .jobs = options.jobs, .longest = 2 * longest_run}, work);
  const story::SeedPool::End end = pool.run([&](std::uint64_t seed, const story::SeedPool::Answer& answer) {
    // A plant that brings a whole run down is found too.
    const bool is_found = answer.text == "found" || !answer.trouble.empty();
    if (is_found) search.found_by = seed - options.first_seed + 1;
    return !is_found;
  });
  search.whole = end == story::SeedPool::End::heard;
  return search;
}

}  // namespace pizarra::chaos
