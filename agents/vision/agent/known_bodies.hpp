#pragma once

// The bodies of which several faces bear tags, and how they are told by what is tracked: each as one object in place of
// its marks. The bodies that clients define are durable facts on the board, and outlive the agent. Those of the cell
// file are told the same way, and come first.
//
//   KnownBodies bodies(context, known.objects(), holders);
//   for (const DefinedBody& body : options.bodies) failed = co_await bodies.define(body.marks, body.name);
//   Result<void> recalled = co_await bodies.recall();
//   sightings = bodies.told(tracker.update(sight, captured));

#include <map>
#include <set>

#include "agents/runtime/agent.hpp"
#include "agents/vision/agent/body_form.hpp"
#include "agents/vision/agent/mode_holders.hpp"
#include "agents/vision/sight/body_sighting.hpp"

namespace pizarra::vision {

inline constexpr std::size_t most_bodies = 8;

// As clients say it too.
struct DefinedBody {
  std::string name;
  Datum marks;
};

class KnownBodies {
 public:
  // All outlive it.
  KnownBodies(runtime::AgentContext& context, const LearnedObjects& objects, const ModeHolders& holders)
      : context_(context), objects_(objects), holders_(holders) {}

  // Takes over the bodies that an earlier life defined. Those that contradict a known body are retracted. Failures: the
  // board's.
  Task<Result<void>> recall();
  // Null: none of this name.
  const Body* find(std::string_view name) const;
  // What there is to find and to track: the objects that are no marks of a body, then the bodies.
  std::vector<std::string> names() const;
  // The objects that are tracked for what clients asked for: those of a body in place of its name.
  std::set<std::string> marks_of(const std::set<std::string>& asked) const;
  // No body has this name. Failure: `name-taken`.
  Result<void> check_name(const std::string& name) const;
  // No body has this mark. Failure: `taken`.
  Result<void> check_no_mark(const std::string& object) const;

  // In place of what was defined under its name. Failures: those of body_from(); `busy` while it is tracked;
  // `name-taken` by an object; of its marks `not-learned`, `other-kind` where one is no tag, and `taken` where another
  // body has it; `full`; the board's.
  Task<Result<Datum>> define(Datum marks, std::string name);
  // Failures: `not-defined`, `busy` while it is tracked, and the board's.
  Task<Result<Datum>> forget(std::string name);
  // Defines the bodies of other eyes that nothing here contradicts. Failures: the board's.
  Task<Result<void>> learn_from(std::string other);
  // What was seen, of all that clients track: a body in place of its marks, and marks that are tracked as such.
  std::vector<TrackSighting> told(std::vector<TrackSighting> marks);
  // Of all bodies, as body_sighting.hpp has it.
  std::map<std::string, cv::Rect> areas_of_unseen(std::span<const TrackSighting> marks, Time captured,
                                                  double focal_px) const;

 private:
  const Body* with_mark(std::string_view mark) const;
  Result<void> check(const Body& body) const;
  Result<void> check_marks(const Body& body) const;
  Result<void> check_untracked(const std::string& name) const;
  // Whether it may stand beside the others, whatever of its marks is learned.
  bool fits(const Body& body) const;

  runtime::AgentContext& context_;
  const LearnedObjects& objects_;
  const ModeHolders& holders_;
  std::vector<Body> bodies_;
  std::map<std::string, std::string> fronts_;  // of each body, the mark that it was told by last
};

}  // namespace pizarra::vision
