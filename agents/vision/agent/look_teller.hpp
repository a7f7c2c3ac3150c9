#pragma once

// Tells what tracking sees: each look as one fact, and beside it of each mark since when it is seen or lost, for those
// who follow one mark alone.
//
//   LookTeller looks(facts);
//   co_await looks.tell(frame.number, sightings);
//   co_await looks.unsay();                            // nothing is tracked, or nobody is connected

#include <map>

#include "agents/vision/agent/fact_teller.hpp"
#include "agents/vision/sight/mark_tracker.hpp"

namespace pizarra::vision {

class LookTeller {
 public:
  // `facts` outlives it.
  explicit LookTeller(FactTeller& facts) : facts_(facts) {}

  // What tracking has seen up to a frame.
  Task<void> tell(std::uint64_t frame, const std::vector<TrackSighting>& sightings);
  // Retracts what was told of earlier frames.
  Task<void> unsay();

 private:
  FactTeller& facts_;
  std::uint64_t beginning_ = 0;                // of the facts that are remembered here
  std::map<std::string, std::string> states_;  // of each tracked object, as it was told last
};

}  // namespace pizarra::vision
