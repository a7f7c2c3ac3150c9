#include "agents/vision/agent/vision_agent.hpp"

#include <opencv2/core/utility.hpp>

#include "agents/vision/agent/vision_contract.hpp"
#include "agents/vision/agent/vision_state.hpp"

namespace pizarra {

VisionAgent::VisionAgent(AgentContext context, StereoCamera& camera, Streams* streams, VisionOptions options)
    : state_(std::make_unique<State>(std::move(context), camera, streams, std::move(options))) {}

VisionAgent::~VisionAgent() = default;

Task<Result<void>> VisionAgent::run() { return state_->run(); }

VisionAgent::State::State(AgentContext agent_context, StereoCamera& stereo_camera, Streams* image_streams,
                          VisionOptions vision_options)
    : context(std::move(agent_context)),
      options(std::move(vision_options)),
      camera(stereo_camera),
      streams(image_streams),
      memory(context, options.objects_directory),
      feed(
          context.executor, stereo_camera, [this](StereoFrame frame) { return on_frame(std::move(frame)); },
          [this] { return camera_changed(); }),
      turns_changed(context.executor) {}

Task<Result<void>> VisionAgent::State::run() {
  // However the run ends, nothing of it goes on.
  struct Ending {
    State& state;
    ~Ending() {
      state.again = Job();
      state.showing = Job();
      state.service.reset();
      state.feed.abandon();
    }
  };
  const Ending ending{*this};
  // Runs repeat only when no image is divided among threads.
  cv::setNumThreads(1);
  Result<Contract> contract = contract_from_text(vision_contract);
  if (!contract) co_return fail(contract);
  service.emplace(context, std::move(*contract));
  const Result<void> started = co_await service->start();
  if (!started) co_return started;
  const Result<void> recalled = co_await memory.recall();
  if (!recalled) co_return recalled;
  co_await tell_state();
  co_await tell_objects();
  again = context.executor.spawn(tell_state_again());
  RequestHandler handler = [this](Fact request) { return handle(std::move(request)); };
  const Result<void> served = co_await service->serve_requests(std::move(handler));
  co_return served;
}

Task<Result<Datum>> VisionAgent::State::handle(Fact request) {
  const Datum& operation = request.datum[3];
  const std::string_view asked = operation.head();
  // Of operations that take one.
  const std::string name = operation.size() > 1 ? std::string(operation.items().back().text()) : "";
  if (asked == "learn") return learn(request.teller, operation[1].number(), operation[2].number(), name);
  if (asked == "find") return find(request.teller, name);
  if (asked == "track") return track(request.teller, name);
  if (asked == "end-track") return end_track(request.teller);
  if (asked == "connect") return connect(request.teller);
  if (asked == "disconnect") return disconnect(request.teller);
  if (asked == "keep") return keep_modes(request.teller);
  if (asked == "accept") return accept(request.teller, name);
  if (asked == "reject") return reject(request.teller, name);
  if (asked == "forget") return forget(request.teller, name);
  if (asked == "rename") return rename(request.teller, std::string(operation[1].text()), name);
  return get_objects();
}

}  // namespace pizarra
