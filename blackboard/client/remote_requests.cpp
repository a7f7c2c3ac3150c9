#include "blackboard/client/remote_requests.hpp"

#include <vector>

#include "lisp/writer.hpp"

namespace pizarra::client {

namespace {

constexpr Duration resend_after = 1s;

}  // namespace

wire::RequestId RemoteRequests::add(Request request) {
  const wire::RequestId id = next_++;
  requests_.emplace(id, std::move(request));
  return id;
}

RemoteRequests::Done RemoteRequests::take(wire::RequestId id) { return std::move(requests_.extract(id).mapped().done); }

void RemoteRequests::begin_session(wire::SessionId session) {
  if (std::exchange(session_, session) != session) fail_what_may_have_happened();
}

void RemoteRequests::send_all(bool is_session_before) {
  for (auto& [id, request] : requests_) {
    if (id < first_waiting_ && (is_session_before || !request.sent)) send(id, request);
  }
  send_waiting();
}

void RemoteRequests::send_waiting() {
  const Time now = executor_.now();
  std::string frame;
  std::vector<Request*> in_frame;
  const auto send_frame = [&] {
    const bool sent = !in_frame.empty() && socket_.send({}, frame);
    for (Request* request : in_frame) request->sent = sent ? std::optional(now) : std::nullopt;
    in_frame.clear();
    frame.clear();
  };
  for (auto next = requests_.lower_bound(first_waiting_); next != requests_.end(); ++next) {
    auto& [id, request] = *next;
    if (id >= requests_.begin()->first + most_ahead) break;
    first_waiting_ = id + 1;
    if (request.sent) continue;
    const bool fits = frame.size() + request.body.size() <= wire::bytes_together;
    if (!fits || in_frame.size() == wire::most_messages) send_frame();
    write_to(frame, id, request, now);
    in_frame.push_back(&request);
  }
  send_frame();
}

void RemoteRequests::send_again() {
  const Time now = executor_.now();
  for (auto& [id, request] : requests_) {
    const bool waits = !request.sent && id >= first_waiting_;
    const bool due = !request.sent || *request.sent + resend_after <= now;
    if (due && !waits) send(id, request);
  }
  send_waiting();
}

void RemoteRequests::send_recalls() {
  for (auto& [id, request] : requests_) {
    if (!recalls(request.body)) continue;
    send(id, request);
    request.sent.reset();
  }
}

void RemoteRequests::fail_where(const std::function<bool(Request&)>& condition, const Failure& failure) {
  std::vector<Done> over;
  for (auto request = requests_.begin(); request != requests_.end();) {
    const bool concerned = condition(request->second);
    if (concerned) over.push_back(std::move(request->second.done));
    request = concerned ? requests_.erase(request) : std::next(request);
  }
  for (const Done& done : over) done(fail(failure));
}

void RemoteRequests::fail_what_may_have_happened() {
  const auto perhaps_done = [](Request& request) {
    const bool sent = std::exchange(request.sent, {}).has_value();
    return sent && !request.repeatable;
  };
  fail_where(perhaps_done,
             {"unreachable", "the board was lost before it answered: whether this happened is not known", {}, {}});
}

void RemoteRequests::send(wire::RequestId id, Request& request) {
  const Time now = executor_.now();
  std::string frame;
  write_to(frame, id, request, now);
  if (socket_.send({}, frame)) request.sent = now;
}

void RemoteRequests::write_to(std::string& frame, wire::RequestId id, const Request& request, Time now) {
  write_number_to(frame += "(request ", session_);
  write_number_to(frame += ' ', id);
  frame += ' ';
  frame += request.body;
  if (const std::optional<Time> said = time_to_say(request, now)) {
    write_number_to(frame += ' ', said->time_since_epoch().count());
  }
  frame += ')';
}

// A hundred times a second at most, of a change that is sent for the first time.
std::optional<Time> RemoteRequests::time_to_say(const Request& request, Time now) {
  if (request.sent || request.repeatable || now - timed_ < between_timed) return std::nullopt;
  timed_ = now;
  return board_clock_.there(now);
}

}  // namespace pizarra::client
