#pragma once

// Tells what is worth knowing of the learned objects, and keeps what was told of findings to their names.
//
//   ObjectTeller told(facts);
//   co_await told.tell({...});                                  // look-alike, to-accept, objects-damaged, limits
//   co_await told.follow_found(renames, known.objects());       // a name has changed

#include "agents/vision/agent/fact_teller.hpp"
#include "agents/vision/objects/learned.hpp"
#include "agents/vision/objects/renames.hpp"

namespace pizarra::vision {

class ObjectTeller {
 public:
  // `facts` outlives it.
  explicit ObjectTeller(FactTeller& facts) : facts_(facts) {}

  // No others of these relations stand.
  Task<void> tell(std::vector<Datum> facts);
  // `found` facts get the new names of their two objects: the one found, and the one that it is most like otherwise. A
  // fact of which either object is forgotten is retracted.
  Task<void> follow_found(Renames renames, const LearnedObjects& objects);

 private:
  FactTeller& facts_;
};

}  // namespace pizarra::vision
