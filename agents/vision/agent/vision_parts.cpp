#include "agents/vision/agent/vision_parts.hpp"

namespace pizarra::vision {

VisionParts::VisionParts(runtime::AgentContext agent_context, camera::StereoCamera& stereo_camera,
                         Streams* image_streams, VisionOptions vision_options,
                         const std::optional<runtime::Service>& service, CameraNews news)
    : context(std::move(agent_context)),
      options(std::move(vision_options)),
      facts(context, service),
      known(context, options.objects_directory, holders, presence, facts,
            [this](const Renames& renames) {
              search.rename(renames);
              tracker.rename(renames);
            }),
      pictures(context, stereo_camera, image_streams),
      feed(context.executor, stereo_camera, std::move(news.on_frame), std::move(news.on_change)),
      search(context.executor, feed, known,
             [this, on_searched = std::move(news.on_searched)](const camera::StereoFrame& frame) {
               tracking_turn.was_passed_over(frame);
               on_searched(frame);
             }),
      state(stereo_camera, feed, holders, tracker, pictures, facts) {}

Task<void> VisionParts::follow_holders() {
  tracker.keep_only(bodies.marks_of(holders.tracked()));
  if (tracker.empty()) tracking_turn.let_go();
  turns.wake();
  co_await rest_or_go_on();
  if (!tracker.empty() && holders.connected()) co_return;
  co_await looks.unsay();
}

Task<void> VisionParts::rest_or_go_on() {
  const bool busy = holders.learning() || holders.finding() || !tracker.empty() || !tags.empty();
  if (!busy && !holders.connected()) feed.stop();
  co_await state.tell();
}

Task<Result<Datum>> VisionParts::answer_failed(std::string text, Failure why) {
  const Datum symbol = Datum::symbol(why.symbol);
  const std::string sentence = describe(why);
  std::vector<Datum> failed{list("vision-failed"_sym, feed.frame_number(), text, symbol, sentence)};
  co_await facts.tell(std::move(failed));
  co_return list(text, symbol, sentence);
}

}  // namespace pizarra::vision
