#include "blackboard/board_server.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/store.hpp"
#include "blackboard/wire_address.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

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

}  // namespace

Result<std::unique_ptr<BoardServer>> BoardServer::open(Executor& executor, MemoryBoard& board,
                                                       const BoardServerOptions& options) {
  std::unique_ptr<BoardServer> server(new BoardServer(executor, board, options));
  for (const std::string& address : options.addresses) {
    const Result<void> allowed = check_listening_address(address, options.insecure);
    if (!allowed) return fail(allowed);
    const Result<std::string> bound = server->socket_.bind(address);
    if (!bound) return fail(bound);
    server->addresses_.push_back(*bound);
  }
  return server;
}

// Sessions are numbered from the time, so that a session of an earlier server's life is not taken for one of this.
BoardServer::BoardServer(Executor& executor, MemoryBoard& board, const BoardServerOptions& options)
    : executor_(executor),
      board_(board),
      session_length_(options.session_length),
      next_session_(
          static_cast<wire::SessionId>(std::max<Duration::rep>(1, executor.now().time_since_epoch().count()))),
      life_(next_session_),
      durability_(options.journal,
                  [this](wire::SessionId id, const std::string& reply) {
                    const auto session = sessions_.find(id);
                    if (session != sessions_.end()) socket_.send(session->second.peer, reply);
                  }),
      socket_(executor, WireSocket::Kind::router,
              [this](const std::string& peer, std::optional<std::string_view> frame) { receive(peer, frame); }) {
  restore(options.remembered);
  forget_the_gone();
}

void BoardServer::restore(const std::vector<RememberedReply>& remembered) {
  for (const RememberedReply& reply : remembered) {
    Session& session = sessions_[reply.session];
    session.teller = reply.teller;
    session.heard = executor_.now();
    remember(session, reply.request, {write(list("reply"_sym, reply.request, reply.result)), 0});
    next_session_ = std::max(next_session_, reply.session + 1);
  }
}

BoardServer::~BoardServer() {
  if (flush_timer_ != 0) executor_.cancel(flush_timer_);
  executor_.cancel(sweep_timer_);
}

void BoardServer::receive(const std::string& peer, std::optional<std::string_view> frame) {
  const auto refuse = [&](const Failure& failure) { send(peer, list("refused"_sym, failure_to_datum(failure))); };
  if (!frame) return refuse({"bad-frame", "a message is one frame", {}, {}});
  const Result<Datum> message = wire::read_frame(*frame);
  if (!message) return refuse({"bad-frame", message.error().sentence, {}, {}});
  if (message->is_form("hello")) return greet(peer, *message);
  const std::optional<std::uint64_t> id = wire::count_at(*message, 1);
  if (!id) return refuse({"bad-frame", "a message is (KIND SESSION ...)", {}, {}});
  const auto session = sessions_.find(*id);
  // One that was restored has no peer before it greets: its client must learn that this is another life.
  if (session == sessions_.end() || session->second.peer.empty()) return send(peer, list("unknown-session"_sym, *id));
  session->second.heard = executor_.now();
  if (std::exchange(session->second.blocked, false)) schedule_flush(*id);
  if (session->second.peer != peer) {
    // The client connected anew, and what was under way to its former connection may be lost.
    session->second.peer = peer;
    for (auto& [number, watch] : session->second.watches) {
      watch.acknowledged = watch.sent;
      watch.queue->resynchronise();
    }
  }
  handle(*id, session->second, *message);
}

void BoardServer::greet(const std::string& peer, const Datum& hello) {
  const bool formed = hello.size() == 3 && hello[1].is_string() && wire::count_at(hello, 2);
  const auto refuse = [&](std::string symbol, std::string sentence) {
    const Failure failure{std::move(symbol), std::move(sentence), {}, {}};
    send(peer, list("refused"_sym, failure_to_datum(failure)));
  };
  if (!formed || hello[1].text().empty() || hello[1].text().size() > max_teller) {
    return refuse("bad-frame", "a hello is (hello TELLER SESSION)");
  }
  wire::SessionId id = *wire::count_from(hello[2]);
  const auto known = sessions_.find(id);
  if (known == sessions_.end() || known->second.teller != hello[1].text()) {
    if (sessions_.size() >= max_sessions) return refuse("too-large", "the board has too many clients");
    id = next_session_++;
    sessions_[id].teller = hello[1].text();
    sessions_[id].peer = peer;
  }
  Session& session = sessions_[id];
  session.heard = executor_.now();
  if (session.peer.empty()) session.peer = peer;
  send(peer, list("welcome"_sym, id, life_));
}

void BoardServer::handle(wire::SessionId id, Session& session, const Datum& message) {
  if (message.is_form("request")) return request(id, session, message);
  if (message.is_form("bye")) {
    sessions_.erase(id);
    return;
  }
  if (message.is_form("ping")) return send(session.peer, list("pong"_sym));
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  if (!number) return;
  const auto watch = session.watches.find(*number);
  if (watch == session.watches.end()) return;
  if (message.is_form("unwatch")) session.watches.erase(watch);
  if (!message.is_form("ack")) return;
  const std::uint64_t sequence = wire::count_at(message, 3).value_or(0);
  if (sequence > watch->second.sent) return;
  watch->second.acknowledged = std::max(watch->second.acknowledged, sequence);
  schedule_flush(id);
}

void BoardServer::request(wire::SessionId id, Session& session, const Datum& message) {
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  if (!number || message.size() != 4) return;
  if (const auto done = session.replies.find(*number); done != session.replies.end()) {
    // One that is held comes when it may.
    if (durability_.kept(done->second.after)) socket_.send(session.peer, done->second.text);
    return;
  }
  if (must_be_done_once(message[3]) && *number <= session.replies_forgotten) return;
  answer(id, session, *number, message[3]);
}

void BoardServer::answer(wire::SessionId id, Session& session, wire::RequestId number, const Datum& body) {
  const bool durable = durability_.concerns_durable(board_.store(), body);
  const Result<void> room = durability_.check_room(body, durable);
  if (!room) return send(session.peer, reply_to_datum(number, fail(room)));
  const JournalWriter::Position before = durability_.position();
  const Datum reply = reply_to_datum(number, perform(id, session, body));
  const std::string text = write(reply);
  if (must_be_done_once(body)) {
    remember(session, number, {text, durable ? durability_.position() : 0});
    if (durable && durability_.position() > before) durability_.remember({id, session.teller, number, reply[2]});
  }
  if (durable) return durability_.hold(id, number, text);
  socket_.send(session.peer, text);
}

void BoardServer::remember(Session& session, wire::RequestId number, Session::Reply reply) {
  session.replies.emplace(number, std::move(reply));
  if (session.replies.size() <= max_replies) return;
  session.replies_forgotten = session.replies.begin()->first;
  session.replies.erase(session.replies.begin());
}

Result<Datum> BoardServer::perform(wire::SessionId id, Session& session, const Datum& body) {
  if (body.is_form("transact")) return transact(session, body);
  if (body.is_form("ask")) return ask(body);
  if (body.is_form("take")) return take(session, body);
  if (body.is_form("declare")) return declare(session, body);
  if (body.is_form("watch")) return watch(id, session, body);
  return lease(body);
}

Result<Datum> BoardServer::declare(const Session& session, const Datum& body) {
  std::vector<Relation> relations;
  for (const Datum& form : body.items().subspan(1)) {
    Result<Relation> relation = relation_from_datum(form);
    if (!relation) return fail(relation);
    relations.push_back(std::move(*relation));
  }
  return nothing_or(board_.declare(session.teller, relations));
}

Result<Datum> BoardServer::transact(const Session& session, const Datum& body) {
  const Result<Transaction> transaction = wire::transaction_from_datum(body);
  if (!transaction) return fail(transaction);
  const Result<Revision> revision = board_.transact(session.teller, *transaction);
  if (!revision) return fail(revision);
  return to_datum(*revision);
}

Result<Datum> BoardServer::ask(const Datum& body) {
  if (body.size() != 2) return bad_frame("a question is (ask QUERY)");
  const Result<Query> query = query_from_datum(body[1]);
  if (!query) return fail(query);
  const Result<Answers> answers = board_.ask(*query);
  if (!answers) return fail(answers);
  std::vector<Datum> value = {to_datum(answers->revision)};
  value.reserve(answers->answers.size() + 1);
  for (const Answer& answer : answers->answers) value.push_back(wire::answer_to_datum(answer));
  return Datum::list(std::move(value));
}

Result<Datum> BoardServer::take(const Session& session, const Datum& body) {
  const std::optional<std::uint64_t> holder = wire::count_at(body, 2);
  if (!holder || body.size() != 3) return bad_frame("taking is (take PATTERN LEASE)");
  const Result<std::optional<Fact>> taken = board_.take(session.teller, body[1], *holder);
  if (!taken) return fail(taken);
  if (!*taken) return Datum();
  return list(wire::fact_to_datum(**taken));
}

Result<Datum> BoardServer::watch(wire::SessionId id, Session& session, const Datum& body) {
  const std::optional<std::uint64_t> number = wire::count_at(body, 1);
  if (!number || body.size() != 3) return bad_frame("watching is (watch WATCH QUERY)");
  const auto standing = session.watches.find(*number);
  if (standing != session.watches.end()) {
    if (standing->second.query == body[2]) return Datum();
    return bad_frame("the watch is of another query");
  }
  if (session.watches.size() >= max_watches) return fail("too-large", "a client has at most 256 watches");
  const Result<Query> query = query_from_datum(body[2]);
  if (!query) return fail(query);
  Result<std::unique_ptr<WatchQueue>> queue = board_.watch(*query, [this, id] { schedule_flush(id); });
  if (!queue) return fail(queue);
  session.watches[*number] = {body[2], std::move(*queue)};
  schedule_flush(id);
  return Datum();
}

Result<Datum> BoardServer::lease(const Datum& body) {
  const bool whole = body.size() == 2 && body[1].is_integer();
  if (!whole) return bad_frame("not a request");
  if (body.is_form("lease")) {
    const Result<LeaseId> lease = board_.lease(Duration(body[1].integer()));
    if (!lease) return fail(lease);
    return to_datum(*lease);
  }
  const std::optional<std::uint64_t> lease = wire::count_from(body[1]);
  if (lease && body.is_form("renew")) return nothing_or(board_.renew(*lease));
  if (lease && body.is_form("release")) return nothing_or(board_.release(*lease));
  return bad_frame("not a request");
}

// A reply that a peer does not take is lost to it; its client asks again.
void BoardServer::send(const std::string& peer, const Datum& message) { socket_.send(peer, write(message)); }

void BoardServer::schedule_flush(wire::SessionId id) {
  to_flush_.insert(id);
  if (flush_timer_ != 0) return;
  flush_timer_ = executor_.call_at(executor_.now(), [this] {
    flush_timer_ = 0;
    for (const wire::SessionId waiting : std::exchange(to_flush_, {})) {
      const auto session = sessions_.find(waiting);
      if (session != sessions_.end()) flush(session->second);
    }
  });
}

void BoardServer::flush(Session& session) {
  for (auto& [id, watch] : session.watches) {
    if (session.blocked) return;
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

void BoardServer::forget_the_gone() {
  const Time now = executor_.now();
  std::erase_if(sessions_, [&](const auto& session) { return session.second.heard + session_length_ <= now; });
  sweep_timer_ = executor_.call_at(now + session_length_ / 8, [this] { forget_the_gone(); });
}

}  // namespace pizarra
