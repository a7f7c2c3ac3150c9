#include "blackboard/server/board_server.hpp"

#include <algorithm>

#include "blackboard/wire/wire_address.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

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
      keys_(std::move(keys)),
      refusals_(board),
      sessions_(options.random_number),
      life_(options.random_number()),
      durability_(
          options.journal,
          [this](wire::SessionId id, const std::string& reply) {
            const Session* session = sessions_.find(id);
            if (session != nullptr) socket_->send(session->peer, reply);
          },
          options.answers_from_journal),
      permitted_(board, durability_),
      socket_(options.transport->open(executor, wire::FrameSocket::Kind::router,
                                      [this](const std::string& peer, std::optional<std::string_view> frame) {
                                        receiving_ = true;
                                        receive(peer, frame);
                                        deliver();
                                        receiving_ = false;
                                      })),
      hearing_(board, [this] { return socket_->heard_until(); }) {
  board_.statistics().requests().set_limit(options.requests);
  board_.store().index_maker().on_wanted = [this] { schedule_look(); };
  journal::JournalWriter* const past = options.past != nullptr ? options.past : options.journal;
  if (past != nullptr) past_.emplace(executor, *past, [this] { return board_.store().revision(); });
  restore(options.remembered);
  if (keys_) ask_for_keys();
  forget_the_gone();
  // What a server before this one left.
  if (!board_.store().index_maker().is_idle()) schedule_look();
}

void BoardServer::restore(const std::vector<journal::RememberedReply>& remembered) {
  for (const journal::RememberedReply& reply : remembered) {
    Session& session = sessions_.restore(reply.session);
    session.teller = reply.teller;
    if (!reply.key.empty()) session.key = wire::PublicKey{.name = {}, .key = reply.key, .may = {}};
    session.heard = executor_.now();
    session.done.add(reply.request, {write(list("reply"_sym, reply.request, reply.result))});
  }
}

Result<void> BoardServer::listen(const std::vector<std::string>& addresses, bool insecure) {
  for (const std::string& address : addresses) {
    const Result<void> allowed = wire::check_listening_address(address, keys_ || insecure);
    if (!allowed) return allowed;
    const bool with_keys = keys_ && !wire::is_ipc(address);
    const Result<std::string> bound = socket_->bind(address, with_keys ? &keys_->own() : nullptr);
    if (!bound) return fail(bound);
    addresses_.push_back(*bound);
  }
  return {};
}

BoardServer::~BoardServer() {
  board_.store().index_maker().on_wanted = nullptr;
  if (flush_timer_ != 0) executor_.cancel(flush_timer_);
  if (look_timer_ != 0) executor_.cancel(look_timer_);
  executor_.cancel(sweep_timer_);
}

void BoardServer::say_goodbye() {
  leaving_ = true;
  for (const auto& [id, session] : sessions_.all()) send(session.peer, list("goodbye"_sym));
}

void BoardServer::receive(const std::string& peer, std::optional<std::string_view> frame) {
  if (leaving_) return;
  if (!frame) return refuse(peer, {"bad-frame", "a message is one frame", {}, {}});
  const Result<std::vector<Datum>> messages = wire::read_messages(*frame);
  if (!messages) return refuse_unreadable(peer, *frame, {"bad-frame", messages.error().sentence, {}, {}});
  before_frame_ = for_requests_;
  for (const Datum& message : *messages) hear(peer, message);
}

void BoardServer::hear(const std::string& peer, const Datum& message) {
  // Whatever else is said finds the transactions before it answered.
  const bool transacts = message.is_form("request") && message.size() > 3 && message[3].is_form("transact");
  if (!transacts) deliver();
  if (message.is_form("hello")) return greet(peer, message);
  const std::optional<std::uint64_t> id = wire::count_at(message, 1);
  if (!id) return refuse(peer, {"bad-frame", "a message is (KIND SESSION ...)", {}, {}});
  Session* const session = sessions_.find(*id);
  // One that was restored has no peer before it greets: its client must learn that this is another life.
  if (session == nullptr || session->peer != peer) {
    // A connection that has said no hello may be its client's next one, made when a line broke.
    const bool forged = session != nullptr && sessions_.of_peer(peer);
    refusals_.note(who_is(peer), forged ? Failure{"not-permitted", "a message in the session of another", {}, {}}
                                        : Failure{"unknown-session", "a message in no session of its own", {}, {}});
    return send(peer, list("unknown-session"_sym, *id));
  }
  session->heard = executor_.now();
  turns_.heard(*id);
  if (session->watches.unblock()) schedule_flush(*id);
  handle(*id, *session, message);
}

void BoardServer::handle(wire::SessionId id, Session& session, const Datum& message) {
  if (message.is_form("ping")) return send(session.peer, list("pong"_sym, executor_.now().time_since_epoch().count()));
  if (message.is_form("request") && !is_to_be_done(id, session, message)) return;
  if (must_wait(session, message)) return postpone(id, session, message);
  hear(id, session, {message});
}

void BoardServer::hear(wire::SessionId id, Session& session, const Postponed::Message& waiting) {
  const Datum& message = waiting.datum;
  if (message.is_form("request")) return serve(id, session, *wire::count_at(message, 2), waiting);
  if (message.is_form("bye")) return end_session(id);
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  const bool known = message.is_form("unwatch") || message.is_form("ack");
  if (!number || !known) return refuse(session.peer, {"bad-frame", "a client does not say this", {}, {}});
  // A watch may have ended while its client said something about it.
  if (session.watches.asked(*number) == nullptr) return;
  if (message.is_form("unwatch")) return session.watches.end(*number);
  const Result<bool> sent = session.watches.acknowledge(*number, wire::count_at(message, 3).value_or(0));
  if (!sent) {
    refusals_.note(session.client(), sent.error());
    session.watches.end(*number);
    return send(session.peer, list("watch-failed"_sym, *number, failure_to_datum(sent.error())));
  }
  const bool timed = *sent && message.size() == 6 && message[4].is_symbol() && message[5].is_integer() &&
                     session.watches.is_about(*number, message[4].text());
  if (timed) board_.statistics().delivered(message[4].text(), Duration(message[5].integer()), executor_.now());
  schedule_flush(id);
}

// A reply that a peer does not take is lost to it; its client asks again.
void BoardServer::send(const std::string& peer, const Datum& message) { socket_->send(peer, write(message)); }

}  // namespace pizarra::server
