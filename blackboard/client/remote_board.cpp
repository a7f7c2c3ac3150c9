#include "blackboard/client/remote_board.hpp"

#include "blackboard/client/remote_watch.hpp"
#include "blackboard/client/replicas.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/teller.hpp"
#include "blackboard/time/latch.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "blackboard/wire/wire_address.hpp"
#include "lisp/writer.hpp"

namespace pizarra::client {

namespace {

constexpr Duration connect_again_after = 1s;
constexpr std::size_t envelope_bytes = 64;  // that a request has around its body

std::unexpected<Failure> nonsense(const Datum& value) {
  return fail("unreachable", "the board's answer is not understood", value);
}

// Whether the request fits a frame, whatever the numbers of its session and its own.
bool fits_frame(const Weight& weight, const std::string& text) {
  constexpr std::size_t envelope_depth = 4;
  return weight.depth + envelope_depth <= limits::frame_depth &&
         weight.elements + envelope_bytes <= limits::frame_elements &&
         text.size() + envelope_bytes <= limits::frame_bytes;
}

std::unexpected<Failure> too_large() { return fail("too-large", "the request does not fit one message of the board"); }

Result<void> nothing_from(const Result<Datum>& reply) {
  if (!reply) return fail(reply);
  return {};
}

Result<std::uint64_t> count_from(const Result<Datum>& reply) {
  if (!reply) return fail(reply);
  const std::optional<std::uint64_t> count = wire::count_from(*reply);
  if (!count) return nonsense(*reply);
  return *count;
}

}  // namespace

Result<std::unique_ptr<RemoteBoard>> RemoteBoard::connect(Executor& executor, const std::string& address,
                                                          std::string teller, Duration timeout,
                                                          const std::optional<wire::ClientKeys>& keys,
                                                          wire::Transport& transport) {
  Result<std::vector<std::string>> addresses = wire::addresses_from(address);
  if (!addresses) return fail(addresses);
  const Result<void> named = check_teller_name(teller);
  if (!named) return fail(named);
  if (keys && !wire::may_call_itself(keys->own.name, teller)) teller = keys->own.name + "/" + teller;
  std::unique_ptr<RemoteBoard> board(
      new RemoteBoard(executor, address, std::move(*addresses), std::move(teller), timeout, transport));
  // Whoever reaches the file of an ipc address is this machine's: no keys there.
  const wire::ClientKeys* shown = keys && !wire::is_ipc(address) ? &*keys : nullptr;
  wire::FrameSocket::Listener listener;
  listener.let_in = [board = board.get()] {
    board->silence_ = no_answer;
    if (!board->joined_) board->greet();
  };
  listener.refused = [board = board.get()](const Failure& failure) {
    board->connect_again_ = board->executor_.now() + connect_again_after;
    board->lose_session();
    board->refused(failure);
  };
  const Result<void> connected = board->socket_->connect(board->addresses_.front(), shown, std::move(listener));
  if (!connected) return fail(connected);
  return board;
}

RemoteBoard::RemoteBoard(Executor& executor, std::string address, std::vector<std::string> addresses,
                         std::string teller, Duration timeout, wire::Transport& transport)
    : executor_(executor),
      address_(std::move(address)),
      addresses_(std::move(addresses)),
      tried_(executor.now()),
      teller_(std::move(teller)),
      timeout_(timeout),
      socket_(transport.open(executor, wire::FrameSocket::Kind::dealer,
                             [this](const std::string&, std::optional<std::string_view> frame) {
                               if (frame) receive(*frame);
                             })) {
  replicas_ = std::make_unique<Replicas>(*this, executor_);
  tick_timer_ = executor_.call_at(executor_.now(), [this] { tick(); });
}

RemoteBoard::~RemoteBoard() {
  replicas_.reset();
  executor_.cancel(tick_timer_);
  if (transmit_timer_ != 0) executor_.cancel(transmit_timer_);
  if (joined_) send(list("bye"_sym, session_));
}

Task<Result<void>> RemoteBoard::declare(std::vector<Relation> relations) {
  std::vector<Datum> body = {"declare"_sym};
  for (const Relation& relation : relations) body.push_back(relation_to_datum(relation));
  Datum request = Datum::list(std::move(body));
  const Result<Datum> reply = co_await call(std::move(request), true);
  if (!reply) co_return fail(reply);
  for (Relation& relation : relations) declared_[relation.name] = std::move(relation);
  co_return Result<void>();
}

Task<Result<Revision>> RemoteBoard::transact(Transaction transaction) {
  std::string request;
  const Weight weight = wire::write_transaction(request, transaction);
  if (!fits_frame(weight, request)) co_return too_large();
  const Result<Datum> reply = co_await call_text(std::move(request), false);
  co_return count_from(reply);
}

Task<Result<void>> RemoteBoard::replicate(Relation relation) {
  const std::vector<Relation> relations = {relation};
  const Result<void> declared = co_await declare(relations);
  if (!declared) co_return fail(declared);
  if (replicas_->find(relation.name) != nullptr) co_return Result<void>();
  Replica& replica = replicas_->add(relation);
  Datum request = replica.request();
  const Result<Datum> reply = co_await call(std::move(request), true);
  const Time deadline = executor_.now() + timeout_;
  if (reply) co_await replica.known().wait(deadline);
  if (reply && replica.whole()) co_return Result<void>();
  Failure failure{"unreachable", "the board does not say what the relation holds", to_datum(relation.name), {}};
  if (replica.ended()) failure = *replica.ended();
  if (!reply) failure = reply.error();
  replicas_->remove(relation.name);
  co_return fail(std::move(failure));
}

Task<Result<Answers>> RemoteBoard::ask(Query query) {
  if (joined_) {
    std::optional<Result<Answers>> held = replicas_->ask(query);
    if (held) co_return std::move(*held);
  }
  const Result<void> checked = check_query(query);
  if (!checked) co_return fail(checked);
  Datum request = list("ask"_sym, query_to_datum(query));
  const Result<Datum> reply = co_await call(std::move(request), true);
  if (!reply) co_return fail(reply);
  const std::optional<std::uint64_t> revision = wire::count_at(*reply, 0);
  if (!revision) co_return nonsense(*reply);
  Result<std::vector<Answer>> answers = wire::answers_from_datum(query, reply->items().subspan(1));
  if (!answers) co_return nonsense(*reply);
  Answers all;
  all.revision = *revision;
  all.answers = std::move(*answers);
  co_return all;
}

Task<Result<RemoteBoard::Recalled>> RemoteBoard::recall(Query query) {
  const Result<void> checked = check_query(query);
  if (!checked) co_return fail(checked);
  Datum request = list("recall"_sym, query_to_datum(query));
  const Result<Datum> reply = co_await call(std::move(request), true);
  if (!reply) co_return fail(reply);
  const std::optional<std::uint64_t> age = wire::count_at(*reply, 0);
  const std::optional<std::uint64_t> revision = wire::count_at(*reply, 2);
  if (!age || !revision) co_return nonsense(*reply);
  Result<std::vector<Answer>> answers = wire::answers_from_datum(query, reply->items().subspan(3));
  if (!answers) co_return nonsense(*reply);
  Recalled recalled;
  recalled.answers.revision = *revision;
  recalled.answers.answers = std::move(*answers);
  recalled.age = Duration(*age);
  recalled.settled = (*reply)[1].is_symbol("yes");
  co_return recalled;
}

Task<Result<std::unique_ptr<Watch>>> RemoteBoard::watch(Query query) {
  const Result<void> checked = check_query(query);
  if (!checked) co_return fail(checked);
  auto watch = std::make_unique<RemoteWatch>(*this, executor_, std::move(query));
  Datum request = watch->request();
  const Result<Datum> reply = co_await call(std::move(request), true);
  if (!reply) co_return fail(reply);
  co_return watch;
}

Task<Result<std::optional<Fact>>> RemoteBoard::take(Datum pattern, LeaseId holder) {
  Datum request = list("take"_sym, pattern, holder);
  const Result<Datum> reply = co_await call(std::move(request), false);
  if (!reply) co_return fail(reply);
  if (reply->size() == 0) co_return std::optional<Fact>();
  Result<Fact> fact = wire::fact_from_datum((*reply)[0]);
  if (!fact) co_return nonsense(*reply);
  co_return std::optional<Fact>(std::move(*fact));
}

Task<Result<LeaseId>> RemoteBoard::lease(Duration length) {
  Datum request = list("lease"_sym, length.count());
  const Result<Datum> reply = co_await call(std::move(request), true);
  co_return count_from(reply);
}

Task<Result<void>> RemoteBoard::renew(LeaseId lease) {
  Datum request = list("renew"_sym, lease);
  const Result<Datum> reply = co_await call(std::move(request), true);
  co_return nothing_from(reply);
}

Task<Result<void>> RemoteBoard::release(LeaseId lease) {
  Datum request = list("release"_sym, lease);
  const Result<Datum> reply = co_await call(std::move(request), true);
  co_return nothing_from(reply);
}

Task<Result<Datum>> RemoteBoard::call(Datum body, bool repeatable) {
  std::string text = write(body);
  if (!fits_frame(weigh(body), text)) co_return too_large();
  Result<Datum> reply = co_await call_text(std::move(text), repeatable);
  co_return reply;
}

Task<Result<Datum>> RemoteBoard::call_text(std::string body, bool repeatable) {
  struct Registration {
    RemoteBoard& board;
    wire::RequestId request;
    ~Registration() { board.forget(request); }
  };
  if (pending_.size() >= max_pending) co_return fail("too-large", "too many requests to the board are under way");
  const bool refused = in_doubt_ && !waits_for_quorum_ && !recalls(body);
  if (refused) co_return fail(unavailable(false));
  std::optional<Result<Datum>> reply;
  WaitList answered(executor_);
  const Registration registration{*this, next_request_++};
  Pending& pending = pending_[registration.request];
  pending.body = std::move(body);
  pending.repeatable = repeatable;
  pending.deadline = executor_.now() + timeout_;
  pending.done = [&](Result<Datum> result) {
    reply = std::move(result);
    answered.wake_all();
  };
  transmit_soon();
  while (!reply) {
    co_await answered.wait();
  }
  co_return std::move(*reply);
}

wire::RequestId RemoteBoard::begin(std::string body, bool repeatable, Done done) {
  const wire::RequestId request = next_request_++;
  Pending& pending = pending_.emplace(request, Pending{std::move(body), repeatable, std::move(done)}).first->second;
  // Messages that a session depends on are sent before those that wait for it.
  if (joined_) transmit(request, pending);
  return request;
}

void RemoteBoard::transmit_soon() {
  if (transmit_timer_ != 0) return;
  transmit_timer_ = executor_.call_at(executor_.now(), [this] {
    transmit_timer_ = 0;
    transmit_waiting();
  });
}

void RemoteBoard::transmit_waiting() {
  if (!joined_) return;
  const Time now = executor_.now();
  std::string frame;
  std::vector<Pending*> in_frame;
  const auto send_frame = [&] {
    const bool sent = !in_frame.empty() && socket_->send({}, frame);
    for (Pending* pending : in_frame) pending->sent = sent ? std::optional(now) : std::nullopt;
    in_frame.clear();
    frame.clear();
  };
  for (auto next = pending_.lower_bound(first_waiting_); next != pending_.end(); ++next) {
    auto& [request, pending] = *next;
    if (request >= pending_.begin()->first + most_ahead) break;
    first_waiting_ = request + 1;
    if (pending.sent) continue;
    const bool fits = frame.size() + pending.body.size() <= wire::bytes_together;
    if (!fits || in_frame.size() == wire::most_messages) send_frame();
    write_request(frame, request, pending, now);
    in_frame.push_back(&pending);
  }
  send_frame();
}

void RemoteBoard::transmit(wire::RequestId request, Pending& pending) {
  const Time now = executor_.now();
  std::string frame;
  write_request(frame, request, pending, now);
  if (socket_->send({}, frame)) pending.sent = now;
}

void RemoteBoard::write_request(std::string& frame, wire::RequestId request, const Pending& pending, Time now) {
  write_number_to(frame += "(request ", session_);
  write_number_to(frame += ' ', request);
  frame += ' ';
  frame += pending.body;
  if (const std::optional<Time> said = time_to_say(pending, now)) {
    write_number_to(frame += ' ', said->time_since_epoch().count());
  }
  frame += ')';
}

// A hundred times a second at most, of a change that is sent for the first time.
std::optional<Time> RemoteBoard::time_to_say(const Pending& pending, Time now) {
  if (pending.sent || pending.repeatable || now - timed_ < between_timed) return std::nullopt;
  timed_ = now;
  return board_clock_.there(now);
}

bool RemoteBoard::send(const Datum& message) { return socket_->send({}, write(message)); }

}  // namespace pizarra::client
