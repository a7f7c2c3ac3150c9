#include "blackboard/board_server.hpp"

#include "blackboard/limits.hpp"
#include "blackboard/store.hpp"
#include "blackboard/wire_address.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

// What a client should not have said, as opposed to what cannot be done just now.
bool is_offence(const Failure& failure) {
  return failure.symbol == "bad-frame" || failure.symbol == "too-large" || failure.symbol == "not-permitted";
}

std::unexpected<Failure> bad_frame(const char* sentence) { return fail("bad-frame", sentence); }

// Whether doing it twice would differ from doing it once.
bool must_be_done_once(const Datum& body) {
  return body.is_form("transact") || body.is_form("take") || body.is_form("lease") || body.is_form("release");
}

Datum reply_to_datum(wire::RequestId id, const Result<Datum>& result) {
  if (result) return list("reply"_sym, id, list("ok"_sym, *result));
  Failure failure = result.error();
  constexpr std::size_t heaviest_subject = limits::bytes / 2;
  if (weigh(failure.subject).bytes > heaviest_subject) failure.subject = {};
  return list("reply"_sym, id, failure_to_datum(failure));
}

Result<Datum> nothing_or(const Result<void>& result) {
  if (!result) return fail(result);
  return Datum();
}

Result<Datum> answers_to_datum(const Result<Answers>& answers) {
  if (!answers) return fail(answers);
  std::vector<Datum> value = {to_datum(answers->revision)};
  value.reserve(answers->answers.size() + 1);
  for (const Answer& answer : answers->answers) value.push_back(wire::answer_to_datum(answer));
  return Datum::list(std::move(value));
}

bool asks_past(const Datum& query) {
  return query.is_form("query") && std::ranges::any_of(query.items(), [](const Datum& o) { return o.is_form("at"); });
}

}  // namespace

Result<std::unique_ptr<BoardServer>> BoardServer::open(Executor& executor, MemoryBoard& board,
                                                       const BoardServerOptions& options) {
  std::optional<KeyFolder> keys;
  if (!options.keys.empty()) {
    Result<KeyFolder> opened = KeyFolder::open(options.keys);
    if (!opened) return fail(opened);
    keys = std::move(*opened);
  }
  const Result<void> declared = Refusals::declare(board);
  if (!declared) return fail(declared);
  std::unique_ptr<BoardServer> server(new BoardServer(executor, board, options, std::move(keys)));
  const Result<void> listening = server->listen(options.addresses, options.insecure);
  if (!listening) return fail(listening);
  return server;
}

BoardServer::BoardServer(Executor& executor, MemoryBoard& board, const BoardServerOptions& options,
                         std::optional<KeyFolder> keys)
    : executor_(executor),
      board_(board),
      session_length_(options.session_length),
      keys_(std::move(keys)),
      gate_(board),
      leases_(board),
      refusals_(board),
      life_(random_number()),
      durability_(options.journal,
                  [this](wire::SessionId id, const std::string& reply) {
                    const auto session = sessions_.find(id);
                    if (session != sessions_.end()) socket_.send(session->second.peer, reply);
                  }),
      socket_(executor, WireSocket::Kind::router,
              [this](const std::string& peer, std::optional<std::string_view> frame) {
                receiving_ = true;
                receive(peer, frame);
                flush_all();
                receiving_ = false;
              }) {
  if (options.journal != nullptr) past_.emplace(executor, *options.journal);
  restore(options.remembered);
  if (keys_) ask_for_keys();
  forget_the_gone();
}

void BoardServer::restore(const std::vector<RememberedReply>& remembered) {
  for (const RememberedReply& reply : remembered) {
    Session& session = sessions_[reply.session];
    session.teller = reply.teller;
    if (!reply.key.empty()) session.key = PublicKey{.name = {}, .key = reply.key, .may = {}};
    session.heard = executor_.now();
    remember(session, reply.request, {write(list("reply"_sym, reply.request, reply.result)), 0});
  }
}

Result<void> BoardServer::listen(const std::vector<std::string>& addresses, bool insecure) {
  for (const std::string& address : addresses) {
    const Result<void> allowed = check_listening_address(address, keys_ || insecure);
    if (!allowed) return allowed;
    const bool with_keys = keys_ && !is_ipc(address);
    const Result<std::string> bound = socket_.bind(address, with_keys ? &keys_->own() : nullptr);
    if (!bound) return fail(bound);
    addresses_.push_back(*bound);
  }
  return {};
}

BoardServer::~BoardServer() {
  if (flush_timer_ != 0) executor_.cancel(flush_timer_);
  executor_.cancel(sweep_timer_);
}

void BoardServer::say_goodbye() {
  leaving_ = true;
  for (const auto& [id, session] : sessions_) send(session.peer, list("goodbye"_sym));
}

void BoardServer::receive(const std::string& peer, std::optional<std::string_view> frame) {
  if (leaving_) return;
  if (!frame) return refuse(peer, {"bad-frame", "a message is one frame", {}, {}});
  const Result<Datum> message = wire::read_frame(*frame);
  if (!message) return refuse(peer, {"bad-frame", message.error().sentence, {}, {}});
  if (message->is_form("hello")) return greet(peer, *message);
  const std::optional<std::uint64_t> id = wire::count_at(*message, 1);
  if (!id) return refuse(peer, {"bad-frame", "a message is (KIND SESSION ...)", {}, {}});
  const auto session = sessions_.find(*id);
  // One that was restored has no peer before it greets: its client must learn that this is another life.
  if (session == sessions_.end() || session->second.peer != peer) {
    const bool forged = session != sessions_.end() && session_of_peer_.contains(peer);
    if (forged) refusals_.note(who_is(peer), {"not-permitted", "a message in the session of another", {}, {}});
    return send(peer, list("unknown-session"_sym, *id));
  }
  session->second.heard = executor_.now();
  if (std::exchange(session->second.blocked, false)) schedule_flush(*id);
  handle(*id, session->second, *message);
}

void BoardServer::handle(wire::SessionId id, Session& session, const Datum& message) {
  if (message.is_form("request")) return request(id, session, message);
  if (message.is_form("bye")) return end_session(id);
  if (message.is_form("ping")) return send(session.peer, list("pong"_sym, executor_.now().time_since_epoch().count()));
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  const bool known = message.is_form("unwatch") || message.is_form("ack");
  if (!number || !known) return refuse(session.peer, {"bad-frame", "a client does not say this", {}, {}});
  // A watch may have ended while its client said something about it.
  const auto watch = session.watches.find(*number);
  if (watch == session.watches.end()) return;
  if (message.is_form("unwatch")) {
    session.watches.erase(watch);
    return;
  }
  const std::uint64_t sequence = wire::count_at(message, 3).value_or(0);
  if (sequence > watch->second.sent) {
    return refuse(session.peer, {"bad-frame", "what was never sent is acknowledged", {}, {}});
  }
  watch->second.acknowledged = std::max(watch->second.acknowledged, sequence);
  const bool timed = message.size() == 6 && message[4].is_symbol() && message[5].is_integer();
  if (timed) board_.statistics().delivered(message[4].text(), Duration(message[5].integer()), executor_.now());
  schedule_flush(id);
}

void BoardServer::request(wire::SessionId id, Session& session, const Datum& message) {
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  const bool timed = message.size() == 5 && message[4].is_integer();
  if (!number || (message.size() != 4 && !timed)) {
    return refuse(session.peer,
                  {"bad-frame", "a request is (request SESSION ID BODY) or has its time after it", {}, {}});
  }
  if (const auto done = session.replies.find(*number); done != session.replies.end()) {
    // One that is held comes when it may.
    if (durability_.kept(done->second.after)) socket_.send(session.peer, done->second.text);
    return;
  }
  if (must_be_done_once(message[3]) && *number <= session.replies_forgotten) {
    return refuse(session.peer, {"bad-frame", "this request, or one far after it, was answered long ago", {}, {}});
  }
  const Revision before = board_.store().revision();
  answer(id, session, *number, message[3]);
  if (timed && board_.store().revision() > before) note_journey(message[3], Time(Duration(message[4].integer())));
}

// Of the first fact that the transaction told.
void BoardServer::note_journey(const Datum& body, Time sent) {
  if (!body.is_form("transact") || body.size() < 3) return;
  for (const Datum& step : body[2].items()) {
    if (!step.is_form("tell") || step.size() < 2) continue;
    const Time now = executor_.now();
    return board_.statistics().came(step[1].head(), now - sent, now);
  }
}

void BoardServer::answer(wire::SessionId id, Session& session, wire::RequestId number, const Datum& body) {
  if (past_ && body.is_form("ask") && body.size() == 2 && asks_past(body[1]))
    return ask_past(id, session, number, body);
  const bool durable = durability_.concerns_durable(board_.store(), body);
  const Result<void> room = durability_.check_room(body, durable);
  if (!room) return send(session.peer, reply_to_datum(number, fail(room)));
  const JournalWriter::Position before = durability_.position();
  const Result<Datum> result = perform(id, session, body);
  if (!result && is_offence(result.error())) refusals_.note(session.teller, result.error());
  const Datum reply = reply_to_datum(number, result);
  const std::string text = write(reply);
  if (must_be_done_once(body)) {
    remember(session, number, {text, durable ? durability_.position() : 0});
    if (durable && durability_.position() > before) {
      const std::string key = session.key ? session.key->key : "";
      durability_.remember({id, session.teller, number, reply[2], key});
    }
  }
  // Changes go before the reply to the request that made them, and after the one to the request for them.
  if (!body.is_form("watch")) flush_all();
  if (durable) return durability_.hold(id, number, text);
  socket_.send(session.peer, session.holds ? with_progress(session, text) : text);
}

// What is remembered, or held back, does not say it: it may be given when changes are under way anew.
std::string BoardServer::with_progress(const Session& session, std::string reply) const {
  const bool behind = std::ranges::any_of(session.watches, [](const auto& w) { return w.second.queue->ready(); });
  reply.back() = ' ';
  reply += std::to_string(board_.store().revision());
  reply += behind ? " no)" : " yes)";
  return reply;
}

void BoardServer::remember(Session& session, wire::RequestId number, Session::Reply reply) {
  session.replies.emplace(number, std::move(reply));
  if (session.replies.size() <= max_replies) return;
  session.replies_forgotten = session.replies.begin()->first;
  session.replies.erase(session.replies.begin());
}

Result<Datum> BoardServer::perform(wire::SessionId id, Session& session, const Datum& body) {
  if (body.is_form("transact")) return transact(session, body);
  if (body.is_form("ask")) return ask(session, body);
  if (body.is_form("take")) return take(session, body);
  if (body.is_form("declare")) return declare(session, body);
  if (body.is_form("watch")) return watch(id, session, body);
  return lease(session, body);
}

Result<Datum> BoardServer::declare(const Session& session, const Datum& body) {
  std::vector<Relation> relations;
  for (const Datum& form : body.items().subspan(1)) {
    Result<Relation> relation = relation_from_datum(form);
    if (!relation) return fail(relation);
    relations.push_back(std::move(*relation));
  }
  const Result<void> permitted = gate_.declare(key_of(session), relations);
  if (!permitted) return fail(permitted);
  return nothing_or(board_.declare(session.teller, relations));
}

Result<Datum> BoardServer::transact(const Session& session, const Datum& body) {
  const Result<Transaction> transaction = wire::transaction_from_datum(body);
  if (!transaction) return fail(transaction);
  const Result<void> permitted = gate_.transact(key_of(session), *transaction);
  if (!permitted) return fail(permitted);
  const Result<Revision> revision = board_.transact(session.teller, *transaction);
  if (!revision) return fail(revision);
  return to_datum(*revision);
}

Result<Query> BoardServer::permitted_query(const Session& session, const Datum& body) {
  if (body.size() != 2) return bad_frame("a question is (ask QUERY)");
  Result<Query> query = query_from_datum(body[1]);
  if (!query) return query;
  const Result<void> permitted = gate_.ask(key_of(session), *query);
  if (!permitted) return fail(permitted);
  return query;
}

Result<Datum> BoardServer::ask(const Session& session, const Datum& body) {
  const Result<Query> query = permitted_query(session, body);
  if (!query) return fail(query);
  return answers_to_datum(board_.ask(*query));
}

void BoardServer::ask_past(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body) {
  const auto reply = [this, id, number](const Result<Answers>& answers) {
    past_asked_.erase({id, number});
    const auto asking = sessions_.find(id);
    if (asking == sessions_.end()) return;
    send(asking->second.peer, reply_to_datum(number, answers_to_datum(answers)));
  };
  // One that is asked again while it is worked on is answered once.
  if (!past_asked_.emplace(id, number).second) return;
  Result<Query> query = permitted_query(session, body);
  if (!query) return reply(fail(query));
  past_->ask(std::move(*query), reply);
}

Result<Datum> BoardServer::take(const Session& session, const Datum& body) {
  const std::optional<std::uint64_t> holder = wire::count_at(body, 2);
  if (!holder || body.size() != 3) return bad_frame("taking is (take PATTERN LEASE)");
  const Result<void> permitted = gate_.take(key_of(session), body[1], *holder);
  if (!permitted) return fail(permitted);
  const Result<std::optional<Fact>> taken = board_.take(session.teller, body[1], *holder);
  if (!taken) return fail(taken);
  if (!*taken) return Datum();
  return list(wire::fact_to_datum(**taken));
}

Result<Datum> BoardServer::watch(wire::SessionId id, Session& session, const Datum& body) {
  const std::optional<std::uint64_t> number = wire::count_at(body, 1);
  const bool held = body.size() == 4 && body[3].is_symbol("held");
  if (!number || (body.size() != 3 && !held)) return bad_frame("watching is (watch WATCH QUERY) or with held after it");
  const auto standing = session.watches.find(*number);
  if (standing != session.watches.end()) {
    if (standing->second.query == body[2]) return Datum();
    return bad_frame("the watch is of another query");
  }
  if (session.watches.size() >= max_watches) return fail("too-large", "a client has at most 256 watches");
  const Result<Query> query = query_from_datum(body[2]);
  if (!query) return fail(query);
  const Result<void> permitted = gate_.ask(key_of(session), *query);
  if (!permitted) return fail(permitted);
  Result<std::unique_ptr<WatchQueue>> queue = board_.watch(session.teller, *query, [this, id] { schedule_flush(id); });
  if (!queue) return fail(queue);
  session.watches[*number] = {body[2], std::move(*queue)};
  session.holds = session.holds || held;
  schedule_flush(id);
  return Datum();
}

Result<Datum> BoardServer::lease(const Session& session, const Datum& body) {
  const bool whole = body.size() == 2 && body[1].is_integer();
  if (!whole) return bad_frame("not a request");
  if (body.is_form("lease")) {
    const Result<void> within = leases_.check(session.teller);
    if (!within) return fail(within);
    const Result<LeaseId> lease = board_.lease(Duration(body[1].integer()));
    if (!lease) return fail(lease);
    gate_.granted(key_of(session), *lease);
    leases_.granted(session.teller, *lease);
    return to_datum(*lease);
  }
  const std::optional<std::uint64_t> lease = wire::count_from(body[1]);
  const Result<void> permitted = gate_.use_lease(key_of(session), lease.value_or(0));
  if (!permitted) return fail(permitted);
  if (lease && body.is_form("renew")) return nothing_or(board_.renew(*lease));
  if (lease && body.is_form("release")) return nothing_or(board_.release(*lease));
  return bad_frame("not a request");
}

// A reply that a peer does not take is lost to it; its client asks again.
void BoardServer::send(const std::string& peer, const Datum& message) { socket_.send(peer, write(message)); }

void BoardServer::schedule_flush(wire::SessionId id) {
  to_flush_.insert(id);
  if (receiving_ || flush_timer_ != 0) return;
  flush_timer_ = executor_.call_at(executor_.now(), [this] {
    flush_timer_ = 0;
    flush_all();
  });
}

void BoardServer::flush_all() {
  for (const wire::SessionId waiting : std::exchange(to_flush_, {})) {
    const auto session = sessions_.find(waiting);
    if (session != sessions_.end()) flush(session->second);
  }
}

void BoardServer::flush(Session& session) {
  for (auto& [id, watch] : session.watches) {
    if (session.blocked) break;
    flush_watch(session, id, watch);
  }
  std::erase_if(session.watches, [](const auto& watch) { return watch.second.queue == nullptr; });
}

void BoardServer::flush_watch(Session& session, wire::WatchId id, ServedWatch& watch) {
  const std::size_t width = width_of(watch.queue->query());
  std::string text;
  while (watch.queue->ready() && watch.sent - watch.acknowledged < max_under_way) {
    const Result<Delta> delta = watch.queue->pop_delta();
    if (!delta) {
      const Datum message = list("watch-failed"_sym, id, failure_to_datum(delta.error()));
      session.blocked = !socket_.send(session.peer, write(message));
      if (!session.blocked) watch.queue.reset();
      return;
    }
    text.clear();
    wire::write_change(text, id, ++watch.sent, width, *delta);
    if (!socket_.send(session.peer, text)) {
      session.blocked = true;
      watch.queue->resynchronise();
      return;
    }
  }
}

}  // namespace pizarra
