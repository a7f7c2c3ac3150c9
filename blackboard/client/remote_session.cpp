// How a RemoteBoard keeps its session with the server: greeting, pinging, repeating, beginning again.

#include <algorithm>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/client/remote_watch.hpp"
#include "blackboard/client/replicas.hpp"
#include "lisp/writer.hpp"

namespace pizarra::client {

namespace {

constexpr Duration tick_length = 50ms;
constexpr Duration tick_while_idle = 250ms;
constexpr Duration greet_again_after = 500ms;
constexpr Duration ping_length = 500ms;
constexpr Duration silence_means_lost = 2s;
constexpr Duration resend_after = 1s;
// Where another board may take over: it serves within half a second.
constexpr Duration ping_among_others = 100ms;
constexpr Duration silence_among_others = 400ms;
constexpr Duration tries_first_for = 120ms;
constexpr Duration tries_longest_for = 2s;

}  // namespace

void RemoteBoard::receive(std::string_view frame) {
  const Result<std::vector<Datum>> messages = wire::read_messages(frame);
  // A wrong message of the server counts as lost: the client asks again.
  if (!messages || messages->empty()) return;
  // One that does not know whether it leads gives no sign of life.
  if (!messages->front().is_form("unavailable")) heard_ = executor_.now();
  for (const Datum& message : *messages) hear(message);
}

void RemoteBoard::hear(const Datum& message) {
  if (message.is_form("reply")) return replied(message);
  if (message.is_form("goodbye")) {
    goodbye_ = heard_;
    return lose_session();
  }
  if (message.is_form("refused") && message.size() == 2) return refused(failure_from_datum(message[1]));
  const std::optional<std::uint64_t> number = wire::count_at(message, 1);
  if (!number) return;
  if (message.is_form("pong")) {
    const Time said{Duration(static_cast<Duration::rep>(*number))};
    // Of several it answers an earlier one than the last.
    if (pings_under_way_ == 1) board_clock_.heard(pinged_, heard_, said);
    pings_under_way_ = std::max(pings_under_way_ - 1, 0);
    return;
  }
  if (message.is_form("unavailable")) return be_in_doubt(Duration(static_cast<Duration::rep>(*number)));
  if (message.is_form("welcome")) return welcomed(*number, wire::count_at(message, 2).value_or(0));
  if (message.is_form("unknown-session") && *number == session_) return lose_session();
  const auto stream = streams_.find(*number);
  if (message.is_form("change")) {
    const std::optional<std::uint64_t> sequence = wire::count_at(message, 2);
    if (stream == streams_.end()) {
      send(list("unwatch"_sym, session_, *number));
    } else if (sequence) {
      stream->second->receive(*sequence, message);
    }
  }
  if (message.is_form("watch-failed") && message.size() == 3 && stream != streams_.end()) {
    stream->second->end(failure_from_datum(message[2]));
  }
}

// Goes nowhere before the connection is let in, or after it broke.
void RemoteBoard::greet() {
  const Datum of_the_first = list("hello"_sym, teller_, session_);
  const Datum hello = list("hello"_sym, teller_, session_, wire::protocol, "doubts"_sym);
  const bool sent = send(is_of_the_first_ ? of_the_first : hello);
  if (!sent) return;
  greeted_ = executor_.now();
  if (!is_of_the_first_) ++newer_hellos_;
}

void RemoteBoard::welcomed(wire::SessionId session, wire::SessionId life) {
  if (joined_) return;
  joined_ = true;
  in_doubt_.reset();
  tries_for_ = {};
  goodbye_.reset();
  pings_under_way_ = 0;
  const bool same_session = std::exchange(session_, session) == session;
  const bool same_life = std::exchange(life_, life) == life;
  if (!same_session) fail_what_may_have_happened();
  if (!same_life) board_clock_.forget();
  if (!same_session || !same_life) {
    redeclare();
    replicas_->begin_again();
    std::vector<RemoteChanges*> streaming;
    for (const auto& [id, stream] : streams_) streaming.push_back(stream);
    for (RemoteChanges* stream : streaming) stream->begin_again();
  }
  for (auto& [request, pending] : pending_) {
    if (request < first_waiting_ && (same_session || !pending.sent)) transmit(request, pending);
  }
  transmit_waiting();
}

void RemoteBoard::lose_session() {
  joined_ = false;
  forget_greetings();
}

void RemoteBoard::forget_greetings() {
  greeted_ = {};
  is_of_the_first_ = false;
  newer_hellos_ = 0;
}

// One that does not welcome within its time stands by, or is gone; over a slow line it may take longer.
void RemoteBoard::try_others(Time now) {
  if (!has_others() || joined_ || now < tried_ + tries_for_) return;
  const bool all_were_tried = at_ + 1 == addresses_.size();
  if (all_were_tried) tries_for_ = std::min(tries_for_ * 5 / 4, tries_longest_for);
  tries_for_ = std::max(tries_for_, tries_first_for);
  at_ = (at_ + 1) % addresses_.size();
  tried_ = now;
  forget_greetings();
  socket_->connect_to(addresses_[at_]);
}

template <class Condition>
void RemoteBoard::fail_where(const Condition& condition, const Failure& failure) {
  std::vector<Done> over;
  for (auto request = pending_.begin(); request != pending_.end();) {
    const bool concerned = condition(request->second);
    if (concerned) over.push_back(std::move(request->second.done));
    request = concerned ? pending_.erase(request) : std::next(request);
  }
  for (const Done& done : over) done(fail(failure));
}

void RemoteBoard::fail_what_may_have_happened() {
  const auto perhaps_done = [](Pending& pending) {
    const bool sent = std::exchange(pending.sent, {}).has_value();
    return sent && !pending.repeatable;
  };
  fail_where(perhaps_done,
             {"unreachable", "the board was lost before it answered: whether this happened is not known", {}, {}});
}

// Of a hello, on which everything waits; or of what the board could not read, any of what was sent to it.
void RemoteBoard::refused(const Failure& failure) {
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
  fail_where([this](const Pending& pending) { return !joined_ || pending.sent; }, failure);
}

// None of these boards may answer. Those who want to know how it was are told so by one of them.
void RemoteBoard::be_in_doubt(Duration age) {
  in_doubt_ = age;
  if (joined_) return;
  for (auto& [request, pending] : pending_) {
    if (!recalls(pending.body)) continue;
    transmit(request, pending);
    // A board that leads is asked anew.
    pending.sent.reset();
  }
  if (waits_for_quorum_) return;
  fail_where([](const Pending& pending) { return !pending.sent && !recalls(pending.body); }, unavailable(false));
}

Failure RemoteBoard::unavailable(bool sent) const {
  const char* done = sent ? ": whether this happened is not known" : ": this was not done";
  return {"unavailable", std::string("the board has no quorum of its log") + done, to_datum(address_), {}};
}

void RemoteBoard::redeclare() {
  if (declared_.empty()) return;
  std::vector<Datum> body = {"declare"_sym};
  for (const auto& [name, relation] : declared_) body.push_back(relation_to_datum(relation));
  // A refusal shows when the relation is used.
  begin(write(Datum::list(std::move(body))), true, [](const Result<Datum>&) {});
}

void RemoteBoard::replied(const Datum& message) {
  const std::optional<std::uint64_t> request = wire::count_at(message, 1);
  const bool formed = request && (message.size() == 3 || message.size() == 5);
  const auto found = formed ? pending_.find(*request) : pending_.end();
  if (found == pending_.end()) return;
  const std::optional<std::uint64_t> revision = wire::count_at(message, 3);
  if (revision && message[4].is_symbol()) {
    replicas_->answered_at(*revision, message[4].is_symbol("yes"));
  } else {
    replicas_->answered();
  }
  const Done done = std::move(found->second.done);
  pending_.erase(found);
  if (first_waiting_ < next_request_) transmit_soon();
  const Datum& result = message[2];
  if (result.is_form("ok") && result.size() == 2) {
    done(result[1]);
  } else {
    done(fail(failure_from_datum(result)));
  }
}

void RemoteBoard::tick() {
  const Time now = executor_.now();
  const Time next = now + (pending_.empty() && !has_others() ? tick_while_idle : tick_length);
  tick_timer_ = executor_.call_at(next, [this, next] {
    // A client that does not run cannot say that the board is silent.
    heard_ = std::min(heard_ + (executor_.now() - next), executor_.now());
    tick();
  });
  give_up_overdue(now);
  if (connect_again_ && *connect_again_ <= now) {
    connect_again_.reset();
    socket_->connect_again();
  }
  const bool lost = joined_ && heard_ + (has_others() ? silence_among_others : silence_means_lost) <= now;
  if (lost) lose_session();
  if (!joined_) {
    try_others(now);
    if (greeted_ + greet_again_after <= now) greet();
    return;
  }
  if (pinged_ + (has_others() ? ping_among_others : ping_length) <= now && send(list("ping"_sym, session_))) {
    pinged_ = now;
    ++pings_under_way_;
  }
  retransmit(now);
}

void RemoteBoard::retransmit(Time now) {
  for (auto& [request, pending] : pending_) {
    const bool waits = !pending.sent && request >= first_waiting_;
    const bool due = !pending.sent || *pending.sent + resend_after <= now;
    if (due && !waits) transmit(request, pending);
  }
  transmit_waiting();
  for (const auto& [id, stream] : streams_) stream->acknowledge();
}

void RemoteBoard::give_up_overdue(Time now) {
  const auto late = [now](const Pending& pending) { return pending.deadline && *pending.deadline <= now; };
  if (in_doubt_) {
    fail_where([&](const Pending& pending) { return late(pending) && !pending.sent; }, unavailable(false));
    fail_where(late, unavailable(true));
  }
  fail_where(late, {"unreachable", silence_, to_datum(address_), {}});
}

}  // namespace pizarra::client
