#include "agents/vision/agent/vision_agent.hpp"

#include <algorithm>
#include <cassert>
#include <opencv2/core/utility.hpp>

#include "agents/vision/agent/vision_contract.hpp"
#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {
namespace {

// Checks the names of the client and of the objects: all strings are names of objects.
Result<void> check_names(const Fact& request) {
  Result<void> good = ModeHolders::check_client(request.teller);
  for (const Datum& argument : request.datum[3].items()) {
    if (good && argument.is_string()) good = check_object_name(argument.text());
  }
  return good;
}

}  // namespace

VisionAgent::VisionAgent(runtime::AgentContext context, camera::StereoCamera& camera, Streams* streams,
                         VisionOptions options)
    : state_(std::make_unique<State>(std::move(context), camera, streams, std::move(options))) {}

VisionAgent::~VisionAgent() = default;

Task<Result<void>> VisionAgent::run() { return state_->run(); }

VisionAgent::State::State(runtime::AgentContext agent_context, camera::StereoCamera& stereo_camera,
                          Streams* image_streams, VisionOptions vision_options)
    : context(std::move(agent_context)),
      options(std::move(vision_options)),
      camera(stereo_camera),
      streams(image_streams),
      memory(context, options.objects_directory),
      feed(
          context.executor, stereo_camera, [this](camera::StereoFrame frame) { return on_frame(std::move(frame)); },
          [this] { return camera_changed(); }),
      turns_changed(context.executor) {}

Task<Result<void>> VisionAgent::State::run() {
  // However the run ends, nothing of it goes on.
  struct Ending {
    State& state;
    ~Ending() {
      state.again = Job();
      state.silence = Job();
      state.showing = Job();
      state.reading = Job();
      state.service.reset();
      state.feed.abandon();
    }
  };
  const Ending ending{*this};
  // Runs repeat only when no image is divided among threads.
  cv::setNumThreads(1);
  Result<runtime::Contract> contract = runtime::contract_from_text(vision_contract);
  if (!contract) co_return fail(contract);
  service.emplace(context, std::move(*contract));
  const Result<void> started = co_await service->start();
  if (!started) co_return started;
  const Result<void> recalled = co_await memory.recall();
  if (!recalled) co_return recalled;
  co_await tell_state();
  co_await tell_objects();
  if (!tags.empty()) feed.start();
  again = context.executor.spawn(tell_state_again());
  silence = context.executor.spawn(tell_silence());
  runtime::RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  const Result<void> served = co_await service->serve_requests(std::move(handler));
  co_return served;
}

const VisionAgent::State::Operation& VisionAgent::State::operation_called(std::string_view word) {
  using enum TurnQueue::Kind;
  static constexpr Operation operations[] = {
      {.word = "learn", .turn = learning, .run = &State::learn},
      {.word = "find", .turn = beside, .run = &State::find},
      {.word = "track", .turn = brief, .run = &State::track},
      {.word = "end-track", .turn = beside, .run = &State::end_track},
      {.word = "get-objects", .turn = {}, .run = &State::get_objects},
      {.word = "connect", .turn = beside, .run = &State::connect},
      {.word = "disconnect", .turn = beside, .run = &State::disconnect},
      {.word = "keep", .turn = beside, .run = &State::keep_modes},
      {.word = "accept", .turn = beside, .run = &State::accept},
      {.word = "reject", .turn = beside, .run = &State::reject},
      {.word = "forget", .turn = brief, .run = &State::forget},
      {.word = "rename", .turn = brief, .run = &State::rename},
      {.word = "learn-from", .turn = brief, .run = &State::learn_from},
  };
  const auto found = std::ranges::find(operations, word, &Operation::word);
  assert(found != std::end(operations) && "the contract offers no others");
  return *found;
}

Task<Result<Datum>> VisionAgent::State::handle(Fact request) {
  const Time came = context.executor.now();
  const Datum& asked_for = request.datum[3];
  const Operation& operation = operation_called(asked_for.head());
  const Result<void> named = check_names(request);
  if (!named) co_return fail(named);
  Result<std::unique_ptr<Turn>> turn;
  if (operation.turn) turn = co_await take_turn(request.teller, *operation.turn);
  if (!turn) co_return fail(turn);
  const std::string name = asked_for.size() > 1 ? std::string(asked_for.items().back().text()) : "";
  Asked asked{request.teller, asked_for, name, came};
  const Result<Datum> answer = co_await (this->*operation.run)(std::move(asked));
  co_return answer;
}

}  // namespace pizarra::vision
