#pragma once

// The parts of one vision agent, each of which has its own state and stands on those before it, and what follows a
// change of theirs. The agent (vision_agent.cpp) wires them and gives them its frames; the clients' operations
// (vision_operations.hpp) work on them.

#include <functional>

#include "agents/vision/agent/camera_feed.hpp"
#include "agents/vision/agent/client_turns.hpp"
#include "agents/vision/agent/known_bodies.hpp"
#include "agents/vision/agent/known_objects.hpp"
#include "agents/vision/agent/look_teller.hpp"
#include "agents/vision/agent/mark_search.hpp"
#include "agents/vision/agent/picture_streams.hpp"
#include "agents/vision/agent/state_teller.hpp"
#include "agents/vision/agent/tag_teller.hpp"
#include "agents/vision/agent/tracking_turn.hpp"
#include "agents/vision/agent/vision_agent.hpp"

namespace pizarra::vision {

// What the agent does when its camera has news.
struct CameraNews {
  std::function<Task<void>(camera::StereoFrame)> on_frame;
  std::function<Task<void>()> on_change;
  std::function<void(const camera::StereoFrame&)> on_searched;  // this frame was taken for a search
};

struct VisionParts {
  // The service may be constructed later: until it runs it is only referred to.
  VisionParts(runtime::AgentContext agent_context, camera::StereoCamera& stereo_camera, Streams* image_streams,
              VisionOptions vision_options, const std::optional<runtime::Service>& service, CameraNews news);

  // What goes on has changed, or who holds what. The camera rests where nothing goes on.
  Task<void> rest_or_go_on();
  Task<void> follow_holders();
  // Tells that a look was in vain, and answers what its request is answered then.
  Task<Result<Datum>> answer_failed(std::string text, Failure why);

  runtime::AgentContext context;
  VisionOptions options;
  ModeHolders holders;
  ClientPresence presence{context};
  ClientTurns turns{context, presence, holders};
  FactTeller facts;
  LookTeller looks{facts};
  KnownObjects known;
  KnownBodies bodies{context, known.objects(), holders};
  MarkTracker tracker{known.objects(), known.limits()};
  TrackingTurn tracking_turn{context.executor};
  TagTeller tags{context.executor, facts, options.tags};
  PictureStreams pictures;
  CameraFeed feed;
  MarkSearch search;
  StateTeller state;
};

}  // namespace pizarra::vision
