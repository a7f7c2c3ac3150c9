#pragma once

// The vision agent, wired of its parts, each of which has its own state and stands on those before it. What a client
// asks is in vision_operations.cpp; what becomes of a frame, and what follows a change, in vision_agent.cpp.

#include "agents/vision/agent/camera_feed.hpp"
#include "agents/vision/agent/client_turns.hpp"
#include "agents/vision/agent/known_bodies.hpp"
#include "agents/vision/agent/known_objects.hpp"
#include "agents/vision/agent/mark_search.hpp"
#include "agents/vision/agent/picture_streams.hpp"
#include "agents/vision/agent/state_teller.hpp"
#include "agents/vision/agent/tag_teller.hpp"
#include "agents/vision/agent/tracking_turn.hpp"
#include "agents/vision/agent/vision_agent.hpp"

namespace pizarra::vision {

struct VisionAgent::State {
  State(runtime::AgentContext agent_context, camera::StereoCamera& stereo_camera, Streams* image_streams,
        VisionOptions vision_options);

  Task<Result<void>> run();
  Task<Result<Datum>> handle(Fact request);

  // What a client asks for.
  struct Asked {
    std::string client;
    Datum operation;   // (WORD ARGUMENT ...)
    std::string name;  // its last argument, of those that take one
    Time came;         // what is looked at for it was captured later
  };
  struct Operation {
    std::string_view word;
    std::optional<TurnQueue::Kind> turn;  // which it waits for; nothing: it is done at once
    Task<Result<Datum>> (State::*run)(Asked);
  };
  static const Operation& operation_called(std::string_view word);
  // What they answer stands after `ok`.
  Task<Result<Datum>> learn(Asked asked);
  Task<Result<Datum>> find(Asked asked);
  Task<Result<Datum>> track(Asked asked);
  Task<Result<Datum>> end_track(Asked asked);
  Task<Result<Datum>> get_objects(Asked);
  Task<Result<Datum>> connect(Asked asked);
  Task<Result<Datum>> disconnect(Asked asked);
  Task<Result<Datum>> keep_modes(Asked asked);
  Task<Result<Datum>> accept(Asked asked) { return known.accept(asked.client, asked.name); }
  Task<Result<Datum>> reject(Asked asked) { return known.reject(asked.client, asked.name); }
  Task<Result<Datum>> forget(Asked asked);
  Task<Result<Datum>> rename(Asked asked);
  Task<Result<Datum>> learn_from(Asked asked);
  Task<Result<Datum>> search_in(Asked asked);
  Task<Result<Datum>> search_everywhere(Asked asked);
  Task<Result<Datum>> look_at_most(Asked asked);
  Task<Result<Datum>> look_always(Asked asked);
  Task<Result<Datum>> define_body(Asked asked) { return bodies.define(asked.operation[1], asked.name); }
  Task<Result<Datum>> forget_body(Asked asked) { return bodies.forget(asked.name); }
  // What is tracked for a name: an object, or those of a body that are known; and the end-effector with them.
  Result<std::vector<const LearnedObject*>> meant_by(const std::string& name) const;
  Task<Result<Datum>> answer_failed(std::string text, Failure why);

  Task<void> know_tagged();
  Task<void> define_bodies();
  Task<void> on_frame(camera::StereoFrame frame);
  // While something is tracked and no frame comes, that nothing is seen.
  Task<void> tell_silence();
  Task<void> tell_missed();
  // To those who watch what a person likes to see.
  void show(const camera::StereoFrame& frame, std::vector<TrackSighting> sightings);

  // What follows a change: of the camera, of who holds what, of what goes on. The camera rests where nothing does.
  Task<void> camera_changed();
  Task<void> follow_holders();
  Task<void> rest_or_go_on();
  // Once a second, what has changed without a word.
  Task<void> look_around();

  runtime::AgentContext context;
  VisionOptions options;
  ModeHolders holders;
  ClientPresence presence{context};
  ClientTurns turns{context, presence, holders};
  FactTeller facts{context, service};
  KnownObjects known;
  KnownBodies bodies{context, known.objects(), holders};
  MarkTracker tracker{known.objects(), known.limits()};
  TrackingTurn tracking_turn{context.executor};
  TagTeller tags{context.executor, facts, options.tags};
  PictureStreams pictures;
  CameraFeed feed;
  MarkSearch search;
  StateTeller state;
  std::optional<runtime::Service> service;  // it ends first: its handlers wait for the feed
  Job looking_around;
  Job silence;
};

}  // namespace pizarra::vision
