#pragma once

// The state of the vision agent. vision_agent.cpp runs it; vision_operations.cpp has its operations, vision_objects.cpp
// what is learned; vision_turns.cpp says who may use it when, vision_modes.cpp what goes on for whom; vision_frames.cpp
// what becomes of a frame, vision_tags.cpp the tags in it; vision_state_telling.cpp what is told.

#include <map>
#include <optional>
#include <set>

#include "agents/vision/agent/camera_feed.hpp"
#include "agents/vision/agent/fact_teller.hpp"
#include "agents/vision/agent/frame_pace.hpp"
#include "agents/vision/agent/mode_holders.hpp"
#include "agents/vision/agent/samples_to_accept.hpp"
#include "agents/vision/agent/turn_queue.hpp"
#include "agents/vision/agent/vision_agent.hpp"
#include "agents/vision/database/object_memory.hpp"
#include "agents/vision/sight/annotate.hpp"
#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_tracker.hpp"

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
  Task<Result<Datum>> accept(Asked asked);
  Task<Result<Datum>> reject(Asked asked);
  Task<Result<Datum>> forget(Asked asked);
  Task<Result<Datum>> rename(Asked asked);
  Task<Result<Datum>> learn_from(Asked asked);

  // `clicked`: the frame that was pointed at; where none is said, the next one.
  Task<Result<LearnedSample>> learn_sample(std::string name, cv::Point2d click, std::optional<std::uint64_t> clicked,
                                           Time asked);
  Task<Result<SeenMark>> find_mark(std::string name, Time asked);
  // Why there is no object of this name: it was never learned, or is damaged.
  Failure not_known(const std::string& name) const;
  Task<Result<Datum>> answer_failed(std::string text, Failure why);
  // Changes what is known, and has everything that goes by it follow: the id of the sample that was kept, or 0.
  Task<Result<std::int64_t>> change_objects(ObjectChange change);
  // The number of the sample of that id.
  std::optional<int> number_of(const std::string& name, std::int64_t id) const;
  // The sample of that name that the client may accept or reject.
  Task<Result<SampleToAccept>> judged_by(std::string client, std::string name);

  // Facts.
  Task<void> tell_state();
  // What is worth knowing of the learned objects: damage, those that look alike, the one to be accepted.
  Task<void> tell_objects();
  // Another agent may have changed what is known: renamed what is tracked or to be accepted, or forgotten it.
  Task<void> follow_memory();
  // By their ids, which they keep. Of samples that are in no database nobody else changes the names.
  using SampleNames = std::map<std::int64_t, std::string>;
  SampleNames names_of_samples() const;
  Renames renamed_since(const SampleNames& before) const;
  // Tracked and awaited objects get their new names.
  Task<void> follow_renames(Renames renames);
  Task<void> tell_holders();
  Task<void> tell_state_again();
  Task<void> camera_changed();
  Task<void> tell_streams();
  std::string_view mode() const;

  // Modes.
  Task<Result<bool>> is_present(std::string client);
  // The client as one who can hold a mode: itself while it is present, ModeHolders::absent otherwise, from now on for
  // as long as these hold what they began.
  Task<std::string> holder_for(std::string client);
  // Failures `busy`: where another client tracks the object, has a sample of it to accept, or either.
  Result<void> check_untracked(const std::string& client, const std::string& name) const;
  Task<Result<void>> check_judged(std::string client, std::string name);
  Task<Result<void>> check_unheld(std::string client, std::string name);
  // A client's turn, until it is destroyed.
  struct Turn {
    Turn(VisionAgent::State& of, int its_number, TurnQueue::Kind its_kind, std::string whose)
        : state(of), number(its_number), kind(its_kind), client(std::move(whose)) {}
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn();
    State& state;
    int number;
    TurnQueue::Kind kind;
    std::string client;
  };
  // Waits until it comes. Failures: `busy`, its subject who holds what this excludes, or who asks for too much; and
  // `absent` for one that died meanwhile.
  Task<Result<std::unique_ptr<Turn>>> take_turn(std::string client, TurnQueue::Kind kind);
  Task<Result<void>> wait_for_turn(const Turn& turn);
  // False where it has to wait.
  Result<bool> begin_turn(const Turn& turn);
  // However much is found, every second look is the tracking's that it suspends.
  Task<void> let_tracking_look();
  // Finding suspends tracking; learning excludes it.
  Task<void> begin_finding(std::string client);
  Task<void> end_finding(std::string client);
  Task<void> begin_learning(std::string client);
  Task<void> end_learning();
  // The camera rests where nothing goes on.
  Task<void> rest_or_go_on();
  // Of those who hold modes and are not present any more, a second long, all is ended; and of those who never were,
  // a while after they asked for it last.
  Task<void> let_dead_go();
  // The tracker, and who is told, become what the holders say.
  Task<void> follow_holders();

  // Frames.
  Task<void> on_frame(camera::StereoFrame frame);
  // The tags that it shows are told, unless those of a frame before are still being read: however long that takes, one
  // look is in hand, away from this thread.
  void begin_reading_tags(const camera::StereoFrame& frame);
  Task<void> read_tags(camera::StereoFrame frame);
  // While something is tracked and no frame comes, that nothing is seen.
  Task<void> tell_silence();
  Task<void> tell_missed();
  // The name of the stream of this kind, and whether anybody watches it.
  std::string stream(std::string_view kind) const;
  bool watched(std::string_view kind) const;
  void publish(const camera::StereoFrame& frame);
  // To those who watch what a person likes to see, unless they are still being shown the frame before.
  void begin_showing(const camera::StereoFrame& frame, std::vector<TrackSighting> sightings);
  Annotation annotation_for(std::uint64_t frame, std::vector<TrackSighting> sightings) const;
  Task<void> show(camera::StereoFrame frame, Annotation annotation);

  runtime::AgentContext context;
  VisionOptions options;
  camera::StereoCamera& camera;
  Streams* streams;
  ObjectMemory memory;
  const LearnedObjects& objects = memory.objects();
  MarkFinder finder{objects};
  MarkTracker tracker{objects};
  const TagsInView tags{options.tags};
  Time tracking_asked = {};                    // for the object that was added last
  std::shared_ptr<const Image> tracked_image;  // the left one, at which the tracker may look back
  std::optional<MarkLearner> learner;
  SamplesToAccept to_accept;
  ModeHolders holders;
  TurnQueue turns;
  std::string learning_for;              // empty: nobody learns
  std::vector<std::string> finding_for;  // several, where they look at the same frame
  bool tracking_is_next = false;         // since a finding has looked at a frame that tracking did not
  std::set<std::string> missing;         // holders who were not present at the last look
  Time absent_until = {};                // how long ModeHolders::absent holds what it does
  camera::CameraDrops told_drops;
  VisionFacts facts{context, service};
  CameraFeed feed;
  WaitList turns_changed;
  std::optional<runtime::Service> service;  // it ends first: its handlers wait for the feed
  Job again;
  Job silence;
  Job showing;
  Job reading;
};

// Grey images of a frame; they share its pixels where these are grey already.
struct GreyPair {
  cv::Mat left;
  cv::Mat right;
};
GreyPair grey_pair(const camera::StereoFrame& frame);
std::shared_ptr<const Image> grey_image(const std::shared_ptr<const Image>& image);

}  // namespace pizarra::vision
