#include "agents/console/page_voice.hpp"

#include "agents/console/change_text.hpp"

namespace pizarra::console {

PageVoice::PageVoice(Executor& executor, web::UpgradedSocket socket, Events events)
    : room_(executor),
      socket_(executor, std::move(socket),
              {.text = std::move(events.text), .room = [this] { room_.set(); }, .ended = std::move(events.ended)}) {}

void PageVoice::say(std::string text) { socket_.send(web::WebSocket::Class::control, std::move(text)); }

void PageVoice::refuse(std::int64_t request, std::string symbol, std::string sentence) {
  say(refusal_text(request, Failure{std::move(symbol), std::move(sentence), {}, {}}));
}

void PageVoice::say_fact(std::string text) {
  unheard_.push_back(text.size());
  unheard_bytes_ += text.size();
  socket_.send(web::WebSocket::Class::facts, std::move(text));
}

void PageVoice::show(std::string picture) { socket_.send(web::WebSocket::Class::images, std::move(picture)); }

bool PageVoice::heard(std::int64_t count) {
  if (count < 0 || static_cast<std::size_t>(count) > unheard_.size()) return false;
  for (std::int64_t i = 0; i < count; ++i) {
    unheard_bytes_ -= unheard_.front();
    unheard_.pop_front();
  }
  room_.set();
  return true;
}

Task<void> PageVoice::room() {
  while (!is_free() || is_behind()) {
    room_.reset();
    co_await room_.wait();
  }
}

}  // namespace pizarra::console
