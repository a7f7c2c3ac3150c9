#include "blackboard/client/remote_session.hpp"

#include <algorithm>

#include "blackboard/time/latch.hpp"
#include "lisp/writer.hpp"

namespace pizarra::client {

namespace {

constexpr Duration connect_again_after = 1s;
constexpr Duration tick_length = 50ms;
constexpr Duration tick_while_idle = 250ms;
constexpr Duration greet_again_after = 500ms;
constexpr Duration ping_length = 500ms;
constexpr Duration silence_means_lost = 2s;
// Where another board may take over: it serves within half a second.
constexpr Duration ping_among_others = 100ms;
constexpr Duration silence_among_others = 400ms;
constexpr Duration tries_first_for = 120ms;
constexpr Duration tries_longest_for = 2s;

}  // namespace

RemoteSession::RemoteSession(Executor& executor, std::string address, std::vector<std::string> addresses,
                             std::string teller, Client& client, wire::Transport& transport)
    : executor_(executor),
      address_(std::move(address)),
      addresses_(std::move(addresses)),
      tried_(executor.now()),
      teller_(std::move(teller)),
      client_(client),
      socket_(transport.open(executor, wire::FrameSocket::Kind::dealer,
                             [this](const std::string&, std::optional<std::string_view> frame) {
                               if (frame) receive(*frame);
                             })),
      requests_(executor, *socket_, board_clock_) {
  tick_timer_ = executor_.call_at(executor_.now(), [this] { tick(); });
}

RemoteSession::~RemoteSession() {
  executor_.cancel(tick_timer_);
  if (transmit_timer_ != 0) executor_.cancel(transmit_timer_);
  if (joined_) send(list("bye"_sym, id_));
}

Result<void> RemoteSession::connect(const wire::ClientKeys* keys) {
  wire::FrameSocket::Listener listener;
  listener.let_in = [this] {
    silence_ = no_answer;
    if (!joined_) greet();
  };
  listener.refused = [this](const Failure& failure) {
    connect_again_ = executor_.now() + connect_again_after;
    lose();
    refused(failure);
  };
  return socket_->connect(addresses_.front(), keys, std::move(listener));
}

Task<Result<Datum>> RemoteSession::call(std::string body, bool repeatable, Duration timeout) {
  struct Registration {
    RemoteSession& session;
    wire::RequestId request;
    ~Registration() { session.forget(request); }
  };
  if (requests_.is_full()) co_return fail("too-large", "too many requests to the board are under way");
  const bool refused = in_doubt_ && !waits_for_quorum_ && !RemoteRequests::recalls(body);
  if (refused) co_return fail(unavailable(false));
  std::optional<Result<Datum>> reply;
  WaitList answered(executor_);
  RemoteRequests::Request request;
  request.body = std::move(body);
  request.repeatable = repeatable;
  request.deadline = executor_.now() + timeout;
  request.done = [&](Result<Datum> result) {
    reply = std::move(result);
    answered.wake_all();
  };
  const Registration registration{*this, requests_.add(std::move(request))};
  transmit_soon();
  while (!reply) {
    co_await answered.wait();
  }
  co_return std::move(*reply);
}

bool RemoteSession::send(const Datum& message) { return socket_->send({}, write(message)); }

wire::RequestId RemoteSession::begin(std::string body, RemoteRequests::Done done) {
  const wire::RequestId request = requests_.add({.body = std::move(body), .repeatable = true, .done = std::move(done)});
  if (joined_) requests_.send(request);
  return request;
}

void RemoteSession::transmit_soon() {
  if (transmit_timer_ != 0) return;
  transmit_timer_ = executor_.call_at(executor_.now(), [this] {
    transmit_timer_ = 0;
    if (joined_) requests_.send_waiting();
  });
}

void RemoteSession::receive(std::string_view frame) {
  const Result<std::vector<Datum>> messages = wire::read_messages(frame);
  // A wrong message of the server counts as lost: the client asks again.
  if (!messages || messages->empty()) return;
  // One that does not know whether it leads gives no sign of life.
  if (!messages->front().is_form("unavailable")) heard_ = executor_.now();
  for (const Datum& message : *messages) hear(message);
}

void RemoteSession::hear(const Datum& message) {
  if (message.is_form("reply")) return replied(message);
  if (message.is_form("goodbye")) {
    goodbye_ = heard_;
    return lose();
  }
  if (message.is_form("refused") && message.size() == 2) return refused(failure_from_datum(message[1]));
  const std::optional<std::uint64_t> number = wire::count_at(message, 1);
  if (!number) return;
  if (message.is_form("pong")) return ponged(Time(Duration(static_cast<Duration::rep>(*number))));
  if (message.is_form("unavailable")) return be_in_doubt(Duration(static_cast<Duration::rep>(*number)));
  if (message.is_form("welcome")) return welcomed(*number, wire::count_at(message, 2).value_or(0));
  if (message.is_form("unknown-session") && *number == id_) return lose();
  client_.heard(*number, message);
}

// Goes nowhere before the connection is let in, or after it broke.
void RemoteSession::greet() {
  const Datum of_the_first = list("hello"_sym, teller_, id_);
  const Datum hello = list("hello"_sym, teller_, id_, wire::protocol, "doubts"_sym);
  const bool sent = send(is_of_the_first_ ? of_the_first : hello);
  if (!sent) return;
  greeted_ = executor_.now();
  if (!is_of_the_first_) ++newer_hellos_;
}

void RemoteSession::welcomed(wire::SessionId session, wire::SessionId life) {
  if (joined_) return;
  joined_ = true;
  in_doubt_.reset();
  tries_for_ = {};
  goodbye_.reset();
  pings_under_way_ = 0;
  const bool same_session = std::exchange(id_, session) == session;
  const bool same_life = std::exchange(life_, life) == life;
  requests_.begin_session(session);
  if (!same_life) board_clock_.forget();
  if (!same_session || !same_life) client_.begin_again();
  requests_.send_all(same_session);
}

void RemoteSession::ponged(Time said) {
  // Of several it answers an earlier one than the last.
  if (pings_under_way_ == 1) board_clock_.heard(pinged_, heard_, said);
  pings_under_way_ = std::max(pings_under_way_ - 1, 0);
}

void RemoteSession::lose() {
  joined_ = false;
  forget_greetings();
}

void RemoteSession::forget_greetings() {
  greeted_ = {};
  is_of_the_first_ = false;
  newer_hellos_ = 0;
}

// One that does not welcome within its time stands by, or is gone; over a slow line it may take longer.
void RemoteSession::try_others(Time now) {
  if (!has_others() || joined_ || now < tried_ + tries_for_) return;
  const bool all_were_tried = at_ + 1 == addresses_.size();
  if (all_were_tried) tries_for_ = std::min(tries_for_ * 5 / 4, tries_longest_for);
  tries_for_ = std::max(tries_for_, tries_first_for);
  at_ = (at_ + 1) % addresses_.size();
  tried_ = now;
  forget_greetings();
  socket_->connect_to(addresses_[at_]);
}

// Of a hello, on which everything waits; or of what the board could not read, any of what was sent to it.
void RemoteSession::refused(const Failure& failure) {
  // What breaks off may come back: `unreachable` is for the timeout to say.
  if (failure.symbol == "unreachable") {
    silence_ = failure.sentence;
    return;
  }
  // A board of the first protocol cannot read the hello of another one, of which two may be under way.
  const bool may_be_of_the_first = !joined_ && failure.symbol == "bad-frame" && wire::check_protocol(1);
  if (may_be_of_the_first && newer_hellos_ > 0) {
    --newer_hellos_;
    if (!std::exchange(is_of_the_first_, true)) greet();
    return;
  }
  requests_.fail_where([this](const auto& request) { return !joined_ || request.sent; }, failure);
}

// None of these boards may answer. Those who want to know how it was are told so by one of them.
void RemoteSession::be_in_doubt(Duration age) {
  in_doubt_ = age;
  if (joined_) return;
  requests_.send_recalls();
  if (waits_for_quorum_) return;
  requests_.fail_where([](const auto& request) { return !request.sent && !RemoteRequests::recalls(request.body); },
                       unavailable(false));
}

Failure RemoteSession::unavailable(bool sent) const {
  const char* done = sent ? ": whether this happened is not known" : ": this was not done";
  return {"unavailable", std::string("the board has no quorum of its log") + done, to_datum(address_), {}};
}

void RemoteSession::replied(const Datum& message) {
  const std::optional<std::uint64_t> request = wire::count_at(message, 1);
  const bool formed = request && (message.size() == 3 || message.size() == 5);
  if (!formed || !requests_.contains(*request)) return;
  const std::optional<std::uint64_t> revision = wire::count_at(message, 3);
  const bool is_dated = revision && message[4].is_symbol();
  client_.reply_comes(is_dated ? revision : std::nullopt, is_dated && message[4].is_symbol("yes"));
  const RemoteRequests::Done done = requests_.take(*request);
  if (requests_.some_wait()) transmit_soon();
  const Datum& result = message[2];
  if (result.is_form("ok") && result.size() == 2) {
    done(result[1]);
  } else {
    done(fail(failure_from_datum(result)));
  }
}

void RemoteSession::tick() {
  const Time now = executor_.now();
  const Time next = now + (requests_.empty() && !has_others() ? tick_while_idle : tick_length);
  tick_timer_ = executor_.call_at(next, [this, next] {
    // A client that does not run cannot say that the board is silent.
    heard_ = std::min(heard_ + (executor_.now() - next), executor_.now());
    give_up_overdue(next);
    tick();
  });
  if (connect_again_ && *connect_again_ <= now) {
    connect_again_.reset();
    socket_->connect_again();
  }
  const bool lost = joined_ && heard_ + (has_others() ? silence_among_others : silence_means_lost) <= now;
  if (lost) lose();
  if (joined_) return keep_alive(now);
  try_others(now);
  if (greeted_ + greet_again_after <= now) greet();
}

void RemoteSession::keep_alive(Time now) {
  if (pinged_ + (has_others() ? ping_among_others : ping_length) <= now && send(list("ping"_sym, id_))) {
    pinged_ = now;
    ++pings_under_way_;
  }
  requests_.send_again();
  client_.say_again();
}

// A request that came due while the client did not run stays for one more tick: its answer may have come meanwhile.
void RemoteSession::give_up_overdue(Time due) {
  const auto late = [due](const RemoteRequests::Request& request) {
    return request.deadline && *request.deadline <= due;
  };
  if (in_doubt_) {
    requests_.fail_where([&](const auto& request) { return late(request) && !request.sent; }, unavailable(false));
    requests_.fail_where(late, unavailable(true));
  }
  requests_.fail_where(late, {"unreachable", silence_, to_datum(address_), {}});
}

}  // namespace pizarra::client
