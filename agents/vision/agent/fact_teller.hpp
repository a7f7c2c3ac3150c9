#pragma once

// How the vision agent tells: everything under its name and its presence, so that it goes with the agent. Facts that a
// lapsed presence or an absent board took away are lost() until they are told anew. Facts of a single frame are not
// repeated: the next frame brings its own.
//
//   FactTeller facts(context, service);
//   facts.begin_anew();
//   co_await facts.tell({...});
//   co_await facts.tell_look(frame.number, sightings);
//   if (facts.lost()) ...                             // tell all that lasts again

#include <map>
#include <optional>
#include <vector>

#include "agents/runtime/service.hpp"
#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_tracker.hpp"

namespace pizarra::vision {

class FactTeller {
 public:
  // Both outlive it; `service` is there before anything is told.
  FactTeller(runtime::AgentContext& context, const std::optional<runtime::Service>& service)
      : context_(context), service_(service) {}

  bool lost() const { return told_under_ != service_->presence(); }
  // Facts that are told from here on stand under the current presence.
  void begin_anew();

  // These as they come, in one transaction.
  Task<void> tell(std::vector<Datum> facts);
  // Who holds which mode: of the facts told last by this, those are retracted that are not among these.
  Task<void> tell_held(std::vector<Datum> facts);
  // What is worth knowing of the learned objects: no others of these relations stand.
  Task<void> tell_objects(std::vector<Datum> facts);
  // What tracking has seen up to a frame; of each mark, since when it is seen or lost.
  Task<void> tell_look(std::uint64_t frame, const std::vector<TrackSighting>& sightings);
  // `found` facts get the new names of their two objects: the one found, and the one that it is most like otherwise. A
  // fact of which either object is forgotten is retracted.
  Task<void> follow_found(Renames renames, const LearnedObjects& objects);
  // The tags that a frame shows, which was captured then. That there are none is told once.
  Task<void> tell_tags(std::uint64_t frame, Time captured, std::vector<FoundMark> seen);
  // Retracts what was told of earlier frames: of tracking, and of tags.
  Task<void> unsay();
  Task<void> unsay_tags();
  // Streams have the agent's name already, so these facts do not begin with it.
  Task<void> tell_streams(std::vector<Datum> facts);

 private:
  Task<void> transact(Transaction transaction);
  void add(Transaction& transaction, const std::vector<Datum>& facts) const;
  // The facts of a relation, as many arguments as they may have besides the agent's name.
  void retract_all(Transaction& transaction, Datum relation, std::size_t arguments) const;

  runtime::AgentContext& context_;
  const std::optional<runtime::Service>& service_;
  LeaseId told_under_ = 0;
  std::map<std::string, std::string> told_tracks_;  // the state of each tracked object as it was told last
  std::vector<Datum> told_held_;
  bool no_tags_told_ = false;  // by what was told of tags last
};

}  // namespace pizarra::vision
