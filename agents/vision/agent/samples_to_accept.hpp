#pragma once

// The samples that may still be taken back: of each client the one that it learned last, until it is accepted or
// rejected. For a minute that is its learner's to say; afterwards anybody's.
//
//   SamplesToAccept to_accept;
//   to_accept.add({"person", "circle", 1, 0, now + SamplesToAccept::lease});
//   to_accept.other_judges("planner", "circle", now);          // {"person"}
//   const SampleToAccept* sample = to_accept.find("person", "circle");

#include <string>
#include <vector>

#include "agents/vision/objects/learned.hpp"
#include "agents/vision/objects/renames.hpp"
#include "blackboard/time/clock.hpp"

namespace pizarra::vision {

struct SampleToAccept {
  std::string client;
  std::string name;
  int number;
  std::int64_t id;  // 0 in no database
  Time held_until;
};

class SamplesToAccept {
 public:
  static constexpr Duration lease = 60s;

  // With its next learning a client accepts its last one.
  void add(SampleToAccept sample);
  // The client's own, or else the newest of that name; null: none.
  const SampleToAccept* find(const std::string& client, const std::string& name) const;
  // Other clients whose choice it still is.
  std::vector<std::string> other_judges(const std::string& client, const std::string& name, Time now) const;
  void remove(const SampleToAccept& sample);
  // By their ids; those that are in no database by their names and numbers. What is learned no more goes.
  void follow(const Renames& renames, const LearnedObjects& objects);
  // (to-accept NAME NUM) of each.
  std::vector<Datum> facts() const;

 private:
  static constexpr std::size_t most = 64;  // the oldest goes

  std::vector<SampleToAccept> samples_;  // as they were learned, one a client
};

}  // namespace pizarra::vision
