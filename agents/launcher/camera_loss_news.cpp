#include "agents/launcher/camera_loss_news.hpp"

#include <fmt/format.h>

#include "agents/runtime/declared.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::launcher {

std::string CameraLossNews::sentence_of(const Datum& camera_state) {
  const std::string eyes(camera_state[1].text());
  const std::string trouble(camera_state[3].text());
  if (camera_state[2].is_symbol("lost")) {
    std::string& told = troubles_[eyes];
    if (told == trouble) return "";
    told = trouble;
    return fmt::format("{} has no images: {}", eyes, trouble);
  }
  if (camera_state[2].is_symbol("opening")) return "";
  const bool was_lost = troubles_.erase(eyes) > 0;
  if (!camera_state[2].is_symbol("open")) return "";
  if (was_lost) return eyes + " has images again";
  const bool first = !trouble.empty() && leaving_out_.insert(eyes).second;
  return first ? fmt::format("{} leaves out images that cannot be read: {}", eyes, trouble) : "";
}

Task<void> log_camera_losses(Board& board, std::string eyes, std::FILE* out) {
  const Datum states = list("camera-state"_sym, Datum::symbol(eyes), "?"_sym, "?"_sym);
  const Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(board, query_for(states));
  if (!watch) co_return;
  CameraLossNews news;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    for (const Answer& answer : change->added) {
      const std::string sentence = news.sentence_of(answer.facts.front().datum);
      if (sentence.empty()) continue;
      fmt::print(out, "pizarra: {}\n", text_of_bytes(sentence));
      std::fflush(out);
    }
  }
}

}  // namespace pizarra::launcher
