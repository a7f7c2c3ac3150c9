#include "blackboard/client/remote_board.hpp"

#include "blackboard/client/remote_watch.hpp"
#include "blackboard/client/replicas.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/teller.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "blackboard/wire/wire_address.hpp"
#include "lisp/writer.hpp"

namespace pizarra::client {

namespace {

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
  const Result<void> connected = board->session_.connect(shown);
  if (!connected) return fail(connected);
  return board;
}

RemoteBoard::RemoteBoard(Executor& executor, const std::string& address, std::vector<std::string> addresses,
                         std::string teller, Duration timeout, wire::Transport& transport)
    : executor_(executor),
      timeout_(timeout),
      session_(executor, address, std::move(addresses), std::move(teller), *this, transport),
      replicas_(std::make_unique<Replicas>(*this, executor)) {}

RemoteBoard::~RemoteBoard() = default;

void RemoteBoard::begin_again() {
  redeclare();
  replicas_->begin_again();
  std::vector<RemoteChanges*> streaming;
  for (const auto& [id, stream] : streams_) streaming.push_back(stream);
  for (RemoteChanges* stream : streaming) stream->begin_again();
}

void RemoteBoard::redeclare() {
  if (declared_.empty()) return;
  std::vector<Datum> body = {"declare"_sym};
  for (const auto& [name, relation] : declared_) body.push_back(relation_to_datum(relation));
  // A refusal shows when the relation is used.
  session_.begin(write(Datum::list(std::move(body))), [](const Result<Datum>&) {});
}

void RemoteBoard::reply_comes(std::optional<std::uint64_t> revision, bool is_all_sent) {
  if (revision) {
    replicas_->answered_at(*revision, is_all_sent);
  } else {
    replicas_->answered();
  }
}

void RemoteBoard::heard(wire::WatchId watch, const Datum& message) {
  const auto stream = streams_.find(watch);
  if (message.is_form("change")) {
    const std::optional<std::uint64_t> sequence = wire::count_at(message, 2);
    if (stream == streams_.end()) {
      session_.send(list("unwatch"_sym, session_.id(), watch));
    } else if (sequence) {
      stream->second->receive(*sequence, message);
    }
  }
  if (message.is_form("watch-failed") && message.size() == 3 && stream != streams_.end()) {
    stream->second->end(failure_from_datum(message[2]));
  }
}

void RemoteBoard::say_again() {
  for (const auto& [id, stream] : streams_) stream->acknowledge();
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
  if (session_.joined()) {
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
  return session_.call(std::move(body), repeatable, timeout_);
}

}  // namespace pizarra::client
