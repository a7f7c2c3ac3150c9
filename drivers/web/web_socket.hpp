#pragma once

// A WebSocket on the executor (wslay): whole messages in, and three classes of messages out, each class before the
// next: what was asked for, facts, images.
//
//   WebSocket socket(executor, std::move(upgraded), {.text = ..., .room = ..., .ended = ...});
//   socket.send(WebSocket::Class::control, "{}");
//   if (socket.waiting() < bound) socket.send(WebSocket::Class::facts, ...);    // `room` says when it is below again
//
// A message of more than 16 kB ends it (1009). More than 400 frames a second end it (1008), and more than 1 MB of
// answers that the peer leaves unread (1008). A peer that takes nothing for 30 s, while something waits, ends it too.
// None of that is kept. `ended` is called once, never from within send() or the constructor.

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "drivers/web/http_server.hpp"

struct wslay_event_context;

namespace pizarra::web {

class WebSocket {
 public:
  enum class Class : std::uint8_t { control, facts, images };
  static constexpr std::size_t max_message = 16 << 10;
  static constexpr int max_frames_a_second = 400;
  static constexpr std::size_t max_unread_control = 1 << 20;
  static constexpr Duration longest_stall = 30s;
  // Below this much the next may be made ready to go.
  static constexpr std::size_t low_mark = 256 << 10;

  struct Events {
    std::function<void(std::string_view message)> text;
    std::function<void()> room;  // what waits has come below the low mark
    std::function<void()> ended;
  };

  WebSocket(Executor& executor, UpgradedSocket socket, Events events);
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;
  ~WebSocket();

  // Images go as binary, the rest as text.
  void send(Class priority, std::string message);
  // Bytes that have not gone to the system.
  std::size_t waiting() const { return waiting_; }
  // Nothing that the peer says counts from here on. The reason is cut to what a close frame holds.
  void close(unsigned short code, std::string_view reason);

 private:
  struct Callbacks;
  void run();
  void receive();
  void transmit();
  bool queue_next();
  void look_for_more(bool writable);
  void count_frame();
  void give_up();
  void linger();
  void end();
  void watch_for_stall();

  Executor& executor_;
  UpgradedSocket socket_;
  std::string first_bytes_;
  Events events_;
  wslay_event_context* context_ = nullptr;
  int poll_;                // readable whenever the socket can be read or, where that is wanted, written
  bool lingering_ = false;  // our close has gone; what the peer still says is thrown away until it has read that
  bool ended_ = false;
  std::deque<std::string> outbox_[3];
  std::size_t waiting_ = 0;
  std::size_t control_ = 0;    // of these, what was asked for
  bool given_up_ = false;      // more of it than may wait: nothing is sent but the close
  std::size_t under_way_ = 0;  // bytes of the message that the library holds
  Time progress_{};
  Time second_{};
  int frames_ = 0;
  Executor::TimerId run_timer_ = 0;
  Executor::TimerId stall_timer_ = 0;
  Executor::TimerId linger_timer_ = 0;
};

// What a server answers to Sec-WebSocket-Key.
std::string web_socket_accept(std::string_view key);

}  // namespace pizarra::web
