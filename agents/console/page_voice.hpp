#pragma once

// What one page is told: answers at once, and facts, of which so much is under way and no more. The page says what of
// them it has taken in.
//
//   PageVoice voice(executor, std::move(upgraded), {.text = ..., .ended = ...});
//   voice.say(reply_text(7, values));
//   co_await voice.room();                     // until it has taken in enough
//   voice.say_fact(change_text(3, change));
//   if (!voice.heard(2)) ...                   // so the page says; there were not so many

#include <deque>
#include <functional>
#include <string>
#include <string_view>

#include "blackboard/time/latch.hpp"
#include "blackboard/time/task.hpp"
#include "drivers/web/web_socket.hpp"

namespace pizarra::console {

class PageVoice {
 public:
  // The most that an answer waits behind, the system's own buffers for the page included.
  static constexpr std::size_t max_unheard_bytes = 256 << 10;

  struct Events {
    std::function<void(std::string_view message)> text;
    std::function<void()> ended;
  };
  PageVoice(Executor& executor, web::UpgradedSocket socket, Events events);

  void say(std::string text);
  void refuse(std::int64_t request, std::string symbol, std::string sentence);
  void say_fact(std::string text);
  // A picture that was asked for, as binary.
  void show(std::string picture);
  // So many messages of facts.
  bool heard(std::int64_t count);
  bool is_behind() const { return unheard_bytes_ >= max_unheard_bytes; }
  // Whether nothing keeps a stamp from going at once.
  bool is_free() const { return socket_.waiting() < web::WebSocket::low_mark; }
  Task<void> room();
  // As of a WebSocket.
  void close(unsigned short code, std::string_view reason) { socket_.close(code, reason); }

 private:
  Event room_;
  std::deque<std::size_t> unheard_;  // messages of facts, by their bytes
  std::size_t unheard_bytes_ = 0;
  web::WebSocket socket_;
};

}  // namespace pizarra::console
