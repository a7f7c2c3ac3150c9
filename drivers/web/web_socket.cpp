#include "drivers/web/web_socket.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <fcntl.h>
#include <nettle/base64.h>
#include <nettle/sha1.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <wslay/wslay.h>

#include "lisp/shortened.hpp"

namespace pizarra::web {

namespace {

constexpr Duration stall_look = 5s;
constexpr Duration longest_linger = 1s;
constexpr int kernel_buffer = 128 << 10;
constexpr std::size_t longest_reason = 120;  // a close frame holds little more

WebSocket& of(void* socket) { return *static_cast<WebSocket*>(socket); }

}  // namespace

struct WebSocket::Callbacks {
  static ssize_t receive(wslay_event_context* context, std::uint8_t* into, std::size_t size, int, void* user) {
    WebSocket& self = of(user);
    if (!self.first_bytes_.empty()) {
      const std::size_t taken = self.first_bytes_.copy(reinterpret_cast<char*>(into), size);
      self.first_bytes_.erase(0, taken);
      return static_cast<ssize_t>(taken);
    }
    const ssize_t got = ::recv(self.socket_.file(), into, size, 0);
    if (got > 0) return got;
    const bool later = got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    wslay_event_set_error(context, later ? WSLAY_ERR_WOULDBLOCK : WSLAY_ERR_CALLBACK_FAILURE);
    return -1;
  }

  static ssize_t send(wslay_event_context* context, const std::uint8_t* from, std::size_t size, int flags, void* user) {
    WebSocket& self = of(user);
    const int more = (flags & WSLAY_MSG_MORE) != 0 ? MSG_MORE : 0;
    const ssize_t sent = ::send(self.socket_.file(), from, size, MSG_NOSIGNAL | more);
    if (sent >= 0) {
      self.progress_ = self.executor_.now();
      return sent;
    }
    const bool later = errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    wslay_event_set_error(context, later ? WSLAY_ERR_WOULDBLOCK : WSLAY_ERR_CALLBACK_FAILURE);
    return -1;
  }

  static void begin_frame(wslay_event_context*, const wslay_event_on_frame_recv_start_arg*, void* user) {
    of(user).count_frame();
  }

  static void message(wslay_event_context*, const wslay_event_on_msg_recv_arg* arrived, void* user) {
    WebSocket& self = of(user);
    if (arrived->opcode != WSLAY_TEXT_FRAME || self.ended_) return;
    self.events_.text({reinterpret_cast<const char*>(arrived->msg), arrived->msg_length});
  }
};

WebSocket::WebSocket(Executor& executor, UpgradedSocket socket, Events events)
    : executor_(executor),
      socket_(std::move(socket)),
      first_bytes_(socket_.take_first_bytes()),
      events_(std::move(events)),
      poll_(epoll_create1(EPOLL_CLOEXEC)),
      progress_(executor.now()),
      second_(executor.now()) {
  assert(poll_ >= 0);
  fcntl(socket_.file(), F_SETFL, fcntl(socket_.file(), F_GETFL) | O_NONBLOCK);
  setsockopt(socket_.file(), SOL_SOCKET, SO_SNDBUF, &kernel_buffer, sizeof kernel_buffer);
  const wslay_event_callbacks callbacks{.recv_callback = &Callbacks::receive,
                                        .send_callback = &Callbacks::send,
                                        .genmask_callback = nullptr,
                                        .on_frame_recv_start_callback = &Callbacks::begin_frame,
                                        .on_frame_recv_chunk_callback = nullptr,
                                        .on_frame_recv_end_callback = nullptr,
                                        .on_msg_recv_callback = &Callbacks::message};
  [[maybe_unused]] const int made = wslay_event_context_server_init(&context_, &callbacks, this);
  assert(made == 0);
  wslay_event_config_set_max_recv_msg_length(context_, max_message);
  epoll_event wanted{.events = EPOLLIN, .data = {}};
  epoll_ctl(poll_, EPOLL_CTL_ADD, socket_.file(), &wanted);
  executor_.watch_readable(poll_, [this] { run(); });
  run_timer_ = executor_.call_at(executor_.now(), [this] { run(); });
  watch_for_stall();
}

WebSocket::~WebSocket() {
  executor_.cancel(run_timer_);
  executor_.cancel(stall_timer_);
  executor_.cancel(linger_timer_);
  executor_.unwatch_readable(poll_);
  wslay_event_context_free(context_);
  ::close(poll_);
}

void WebSocket::send(Class priority, std::string message) {
  if (ended_ || lingering_ || given_up_) return;
  if (priority == Class::control) {
    if (control_ > max_unread_control) return give_up();
    control_ += message.size();
  }
  // It has only begun to wait.
  if (waiting_ == 0) progress_ = executor_.now();
  waiting_ += message.size();
  outbox_[static_cast<std::size_t>(priority)].push_back(std::move(message));
  if (run_timer_ == 0) run_timer_ = executor_.call_at(executor_.now(), [this] { run(); });
}

// What waits goes to nobody: who does not read it learns by the close why it has ended.
void WebSocket::give_up() {
  given_up_ = true;
  for (std::deque<std::string>& waiting : outbox_) waiting.clear();
  waiting_ = under_way_;
  close(WSLAY_CODE_POLICY_VIOLATION, "too many answers are left unread");
}

void WebSocket::close(unsigned short code, std::string_view reason) {
  if (ended_) return;
  wslay_event_shutdown_read(context_);
  const std::string said = shortened(reason, longest_reason);
  wslay_event_queue_close(context_, code, reinterpret_cast<const std::uint8_t*>(said.data()), said.size());
  if (run_timer_ == 0) run_timer_ = executor_.call_at(executor_.now(), [this] { run(); });
}

void WebSocket::run() {
  executor_.cancel(run_timer_);
  run_timer_ = 0;
  if (ended_) return;
  if (lingering_) return linger();
  const bool was_full = waiting_ >= low_mark;
  receive();
  if (!ended_) transmit();
  if (!ended_ && was_full && waiting_ < low_mark) events_.room();
}

void WebSocket::receive() {
  if (wslay_event_want_read(context_) == 0) return;
  if (wslay_event_recv(context_) != 0) end();
}

void WebSocket::transmit() {
  do {
    if (wslay_event_send(context_) != 0) return end();
    if (wslay_event_want_write(context_) != 0) break;
    waiting_ -= std::exchange(under_way_, 0);
  } while (queue_next());
  const bool more = wslay_event_want_write(context_) != 0;
  if (!more && wslay_event_get_close_sent(context_) != 0) return linger();
  if (!more && wslay_event_want_read(context_) == 0) return end();
  look_for_more(more);
}

// A socket that is closed with something unread takes back what it has sent: the reason of the close, too.
void WebSocket::linger() {
  if (!lingering_) {
    lingering_ = true;
    ::shutdown(socket_.file(), SHUT_WR);
    look_for_more(false);
    linger_timer_ = executor_.call_at(executor_.now() + longest_linger, [this] { end(); });
  }
  char thrown_away[4096];
  for (int i = 0; i < 16; ++i) {
    const ssize_t got = ::recv(socket_.file(), thrown_away, sizeof thrown_away, 0);
    if (got > 0) continue;
    const bool later = got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    if (!later) end();
    return;
  }
}

// One message at a time is the library's, so that what is more urgent goes before what waits.
bool WebSocket::queue_next() {
  if (wslay_event_get_close_sent(context_) != 0) return false;
  for (std::deque<std::string>& waiting : outbox_) {
    if (waiting.empty()) continue;
    const std::string message = std::move(waiting.front());
    waiting.pop_front();
    const auto is = [&](Class priority) { return &waiting == &outbox_[static_cast<std::size_t>(priority)]; };
    const bool image = is(Class::images);
    if (is(Class::control)) control_ -= message.size();
    const wslay_event_msg whole{.opcode = static_cast<std::uint8_t>(image ? WSLAY_BINARY_FRAME : WSLAY_TEXT_FRAME),
                                .msg = reinterpret_cast<const std::uint8_t*>(message.data()),
                                .msg_length = message.size()};
    under_way_ = message.size();
    return wslay_event_queue_msg(context_, &whole) == 0;
  }
  return false;
}

void WebSocket::look_for_more(bool writable) {
  epoll_event wanted{.events = EPOLLIN, .data = {}};
  if (writable) wanted.events |= EPOLLOUT;
  epoll_ctl(poll_, EPOLL_CTL_MOD, socket_.file(), &wanted);
}

void WebSocket::count_frame() {
  const Time now = executor_.now();
  if (now - second_ >= 1s) {
    second_ = now;
    frames_ = 0;
  }
  if (++frames_ == max_frames_a_second + 1) {
    close(WSLAY_CODE_POLICY_VIOLATION, "too many messages");
  }
}

void WebSocket::watch_for_stall() {
  stall_timer_ = executor_.call_at(executor_.now() + stall_look, [this] {
    if (waiting_ > 0 && executor_.now() - progress_ >= longest_stall) return end();
    watch_for_stall();
  });
}

// No more is read or written; whoever owns this is told once all that is under way here has returned.
void WebSocket::end() {
  if (ended_) return;
  ended_ = true;
  executor_.cancel(stall_timer_);
  executor_.cancel(linger_timer_);
  stall_timer_ = 0;
  epoll_ctl(poll_, EPOLL_CTL_DEL, socket_.file(), nullptr);
  executor_.cancel(run_timer_);
  run_timer_ = executor_.call_at(executor_.now(), [this] {
    run_timer_ = 0;
    // It may destroy this.
    const auto told = events_.ended;
    told();
  });
}

std::string web_socket_accept(std::string_view key) {
  constexpr std::string_view fixed = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
  sha1_ctx hash;
  sha1_init(&hash);
  sha1_update(&hash, key.size(), reinterpret_cast<const std::uint8_t*>(key.data()));
  sha1_update(&hash, fixed.size(), reinterpret_cast<const std::uint8_t*>(fixed.data()));
  std::uint8_t digest[SHA1_DIGEST_SIZE];
  sha1_digest(&hash, sizeof digest, digest);
  std::string out(BASE64_ENCODE_RAW_LENGTH(sizeof digest), ' ');
  base64_encode_raw(out.data(), sizeof digest, digest);
  return out;
}

}  // namespace pizarra::web
