#include "blackboard/server/board_server.hpp"

#include "blackboard/server/in_doubt.hpp"
#include "blackboard/store/index_maker.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/watch/commit_looks.hpp"
#include "blackboard/wire/wire_address.hpp"

namespace pizarra::server {

namespace {

// What a message takes whatever it asks for.
constexpr std::size_t looks_a_message = 64;

// Messages that a client must be able to send at any time to keep what it has.
bool overtakes(const Datum& message) {
  const bool renews = message.is_form("request") && message.size() > 3 && message[3].is_form("renew");
  return renews || message.is_form("ack");
}

}  // namespace

Result<std::unique_ptr<BoardServer>> BoardServer::open(Executor& executor, memory::MemoryBoard& board,
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

BoardServer::BoardServer(Executor& executor, memory::MemoryBoard& board, const BoardServerOptions& options,
                         std::optional<KeyFolder> keys)
    : executor_(executor),
      board_(board),
      session_length_(options.session_length),
      refusals_(board),
      sessions_(options.random_number),
      workload_(executor),
      socket_(options.transport->open(executor, wire::FrameSocket::Kind::router,
                                      [this](const std::string& peer, std::optional<std::string_view> frame) {
                                        outbox_.begin_frame();
                                        receive(peer, frame);
                                        outbox_.end_frame();
                                      })),
      outbox_(executor, board, sessions_, workload_, *socket_),
      requests_(executor, board, sessions_, refusals_, workload_, outbox_,
                {options.journal, options.past, options.answers_from_journal}),
      admission_(board, sessions_, refusals_, outbox_, *socket_, std::move(keys), options.random_number()),
      hearing_(board, [this] { return socket_->heard_until(); }) {
  board_.statistics().requests().set_limit(options.requests);
  workload_.on_turn = [this] { serve_turn(); };
  board_.store().index_maker().on_wanted = [this] { workload_.schedule(); };
  requests_.restore(options.remembered);
  sweep();
  // What a server before this one left.
  if (!board_.store().index_maker().is_idle()) workload_.schedule();
}

Result<void> BoardServer::listen(const std::vector<std::string>& addresses, bool insecure) {
  const KeyFolder* const keys = admission_.keys();
  for (const std::string& address : addresses) {
    const Result<void> allowed = wire::check_listening_address(address, keys != nullptr || insecure);
    if (!allowed) return allowed;
    const bool with_keys = keys != nullptr && !wire::is_ipc(address);
    const Result<std::string> bound = socket_->bind(address, with_keys ? &keys->own() : nullptr);
    if (!bound) return fail(bound);
    addresses_.push_back(*bound);
  }
  return {};
}

BoardServer::~BoardServer() {
  board_.store().index_maker().on_wanted = nullptr;
  executor_.cancel(sweep_timer_);
}

void BoardServer::say_goodbye() {
  leaving_ = true;
  for (const auto& [id, session] : sessions_.all()) outbox_.send(session.peer, list("goodbye"_sym));
}

std::string BoardServer::answer_in_doubt(const std::string& sender_key, std::string_view frame, Duration age) {
  return leaving_ ? "" : server::answer_in_doubt(requests_.permitted(), admission_.keys(), sender_key, frame, age);
}

void BoardServer::receive(const std::string& peer, std::optional<std::string_view> frame) {
  if (leaving_) return;
  if (!frame) return admission_.refuse(peer, {"bad-frame", "a message is one frame", {}, {}});
  const Result<std::vector<Datum>> messages = wire::read_messages(*frame);
  if (!messages) return refuse_unreadable(peer, *frame, {"bad-frame", messages.error().sentence, {}, {}});
  workload_.begin_frame();
  for (const Datum& message : *messages) hear(peer, message);
}

// To the request that it begins as, where it is one of the sender's session.
void BoardServer::refuse_unreadable(const std::string& peer, std::string_view frame, const Failure& failure) {
  const std::optional<wire::SessionId> session = sessions_.of_peer(peer);
  if (!session) return admission_.refuse(peer, failure);
  const std::optional<wire::RequestId> number = wire::request_begun(frame, *session);
  if (!number) return admission_.refuse(peer, failure);
  requests_.refuse(*sessions_.find(*session), *number, failure);
}

void BoardServer::hear(const std::string& peer, const Datum& message) {
  // Whatever else is said finds the transactions before it answered.
  const bool transacts = message.is_form("request") && message.size() > 3 && message[3].is_form("transact");
  if (!transacts) outbox_.deliver();
  if (message.is_form("hello")) return admission_.greet(peer, message, executor_.now());
  const std::optional<std::uint64_t> id = wire::count_at(message, 1);
  if (!id) return admission_.refuse(peer, {"bad-frame", "a message is (KIND SESSION ...)", {}, {}});
  Session* const session = sessions_.find(*id);
  // One that was restored has no peer before it greets: its client must learn that this is another life.
  if (session == nullptr || session->peer != peer) {
    // A connection that has said no hello may be its client's next one, made when a line broke.
    const bool forged = session != nullptr && sessions_.of_peer(peer);
    refusals_.note(admission_.who_is(peer),
                   forged ? Failure{"not-permitted", "a message in the session of another", {}, {}}
                          : Failure{"unknown-session", "a message in no session of its own", {}, {}});
    return outbox_.send(peer, list("unknown-session"_sym, *id));
  }
  session->heard = executor_.now();
  workload_.heard(*id);
  if (session->watches.unblock()) outbox_.schedule(*id);
  handle(*id, *session, message);
}

void BoardServer::handle(wire::SessionId id, Session& session, const Datum& message) {
  if (message.is_form("ping")) {
    return outbox_.send(session.peer, list("pong"_sym, executor_.now().time_since_epoch().count()));
  }
  if (message.is_form("request") && !is_to_be_done(id, session, message)) return;
  if (must_wait(session, message)) return postpone(id, session, message);
  perform(id, session, {message});
}

bool BoardServer::is_to_be_done(wire::SessionId id, Session& session, const Datum& request) {
  const std::optional<std::uint64_t> number = wire::count_at(request, 2);
  const bool timed = request.size() == 5 && request[4].is_integer();
  if (number && (timed || request.size() == 4)) return requests_.is_to_be_done(id, session, *number, request[3]);
  const Failure malformed{"bad-frame", "a request is (request SESSION ID BODY) or has its time after it", {}, {}};
  if (number) {
    requests_.refuse(session, *number, malformed);
  } else {
    admission_.refuse(session.peer, malformed);
  }
  return false;
}

// Behind what waits; or when its frame had so much looked at that others are served before the rest of it.
bool BoardServer::must_wait(const Session& session, const Datum& message) const {
  return (workload_.frame_had_its_turn() || !session.postponed.empty()) && !overtakes(message);
}

void BoardServer::postpone(wire::SessionId id, Session& session, const Datum& message) {
  if (session.postponed.empty()) workload_.wait(session.client(), id);
  if (session.postponed.add({message})) return;
  const Failure full{"too-many", "too much waits behind a request that waits for an index, or its turn", {}, {}};
  if (message.is_form("request")) {
    return requests_.refuse_undone(session, *wire::count_at(message, 2), message[3], full);
  }
  admission_.refuse(session.peer, full);
}

// Now, or when an index is made that it needs, or its turn has come.
void BoardServer::perform(wire::SessionId id, Session& session, const Postponed::Message& waiting) {
  const Datum& message = waiting.datum;
  if (message.is_form("bye")) return admission_.end(id);
  if (!message.is_form("request")) return attend_to_watch(id, session, message);
  if (!requests_.serve(id, session, waiting)) session.postponed.wait(waiting);
}

void BoardServer::attend_to_watch(wire::SessionId id, Session& session, const Datum& message) {
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  const bool known = message.is_form("unwatch") || message.is_form("ack");
  if (!number || !known) return admission_.refuse(session.peer, {"bad-frame", "a client does not say this", {}, {}});
  // A watch may have ended while its client said something about it.
  if (session.watches.asked(*number) == nullptr) return;
  if (message.is_form("unwatch")) return session.watches.end(*number);
  const Result<bool> sent = session.watches.acknowledge(*number, wire::count_at(message, 3).value_or(0));
  if (!sent) {
    refusals_.note(session.client(), sent.error());
    session.watches.end(*number);
    return outbox_.send(session.peer, list("watch-failed"_sym, *number, failure_to_datum(sent.error())));
  }
  const bool timed = *sent && message.size() == 6 && message[4].is_symbol() && message[5].is_integer() &&
                     session.watches.is_about(*number, message[4].text());
  if (timed) board_.statistics().delivered(message[4].text(), Duration(message[5].integer()), executor_.now());
  outbox_.schedule(id);
}

// Each client in its turn.
void BoardServer::serve_turn() {
  workload_.begin();
  if (!board_.store().index_maker().is_idle()) make_indexes();
  for (std::size_t left = workload_.clients(); left > 0 && workload_.has_room(); --left) {
    const wire::SessionId id = workload_.next();
    go_on(id);
    outbox_.flush(id);
  }
  if (!workload_.empty() || !board_.store().index_maker().is_idle()) workload_.schedule();
}

// Requests that await any index look again for their own when one is made.
void BoardServer::make_indexes() {
  store::IndexMaker& maker = board_.store().index_maker();
  constexpr wire::SessionId nobody = 0;
  const std::uint64_t made = maker.made();
  workload_.took(nobody, maker.make_some());
  if (maker.made() == made) return;
  for (const auto& [id, session] : sessions_.all()) {
    if (session.awaited != 0 && !maker.is_awaited(session.awaited)) workload_.wait(session.client(), id);
  }
}

// With the messages that were postponed, as many as the turn has room for.
void BoardServer::go_on(wire::SessionId id) {
  while (true) {
    Session* const session = sessions_.find(id);
    if (session == nullptr || session->postponed.empty()) return;
    if (board_.store().index_maker().is_awaited(session->awaited)) return;
    if (!workload_.has_room()) return workload_.wait(session->client(), id);
    const Postponed::Message next = session->postponed.next();
    const std::size_t before = workload_.for_requests();
    workload_.spend(looks_a_message + weigh(next.datum).bytes / watch::CommitLooks::bytes_a_look);
    perform(id, *session, next);
    workload_.spend(workload_.for_requests() - before);
  }
}

void BoardServer::sweep() {
  const Time now = executor_.now();
  admission_.end_silent(socket_->heard_until() - session_length_);
  requests_.permitted().sweep();
  sweep_timer_ = executor_.call_at(now + session_length_ / 8, [this] { sweep(); });
}

}  // namespace pizarra::server
