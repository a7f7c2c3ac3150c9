// The requests that a BoardServer's clients make of the board, and their replies: once, however often it is asked.

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/server/reply_text.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

namespace {

// Whatever a request fails with is a refusal, but that its own precondition does not hold, which is an answer, and a
// full disk, which is not its doing.
bool is_refusal(const Failure& failure) {
  return failure.symbol != "precondition-failed" && failure.symbol != "journal-full";
}

std::unexpected<Failure> too_many_watches() {
  return fail("too-large", "a client has at most " + std::to_string(ServedWatches::most) + " watches");
}

// Whether doing it twice would differ from doing it once.
bool must_be_done_once(const Datum& body) {
  return body.is_form("transact") || body.is_form("take") || body.is_form("lease") || body.is_form("release");
}

bool asks_past(const Datum& query) {
  return query.is_form("query") && std::ranges::any_of(query.items(), [](const Datum& o) { return o.is_form("at"); });
}

}  // namespace

// Whether a request that came is to be done, now or in its turn; otherwise it is answered, or being answered.
bool BoardServer::is_to_be_done(wire::SessionId id, Session& session, const Datum& message) {
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  const bool timed = message.size() == 5 && message[4].is_integer();
  const Failure malformed{"bad-frame", "a request is (request SESSION ID BODY) or has its time after it", {}, {}};
  if (!number) {
    refuse(session.peer, malformed);
    return false;
  }
  if (message.size() != 4 && !timed) {
    refuse_request(session, *number, malformed);
    return false;
  }
  if (session.postponed.has_request(*number)) return false;
  const Result<void> served = board_.statistics().requests().ask(session.client(), session.heard);
  if (was_answered(id, session, *number, message[3])) return false;
  if (!served) refuse_undone(session, *number, message[3], served.error());
  return served.has_value();
}

// And is answered again.
bool BoardServer::was_answered(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body) {
  for (const Answered* answered : {&session.done, &session.refused}) {
    const Durability::Reply* again = answered->find(number);
    if (again == nullptr) continue;
    // One that is held comes when it may.
    flush_all();
    durability_.answer_again(id, number, *again);
    return true;
  }
  const bool long_ago = number <= std::max(session.done.forgotten(), session.refused.forgotten());
  if (!must_be_done_once(body) || !long_ago) return false;
  refuse_request(session, number, {"bad-frame", "this request, or one far after it, was answered long ago", {}, {}});
  return true;
}

void BoardServer::refuse_request(const Session& session, wire::RequestId number, const Failure& failure) {
  refusals_.note(session.client(), failure);
  socket_->send(session.peer, reply_text(number, result_to_datum(fail(failure))));
}

// One that is on its way a second time is refused as well, though it could be done by then.
void BoardServer::refuse_undone(Session& session, wire::RequestId number, const Datum& body, const Failure& failure) {
  if (is_refusal(failure)) refusals_.note(session.client(), failure);
  const std::string refusal = reply_text(number, result_to_datum(fail(failure)));
  if (must_be_done_once(body)) session.refused.add(number, {refusal});
  socket_->send(session.peer, refusal);
}

// To the request that it begins as, where it is one of the sender's session.
void BoardServer::refuse_unreadable(const std::string& peer, std::string_view frame, const Failure& failure) {
  const std::optional<wire::SessionId> session = sessions_.of_peer(peer);
  if (!session) return refuse(peer, failure);
  const std::optional<wire::RequestId> number = wire::request_begun(frame, *session);
  if (!number) return refuse(peer, failure);
  refuse_request(*sessions_.find(*session), *number, failure);
}

// Of the first fact that the transaction told.
void BoardServer::note_journey(const Datum& body, Time sent) {
  if (!body.is_form("transact") || body.size() < 3) return;
  for (const Datum& step : body[2].items()) {
    if (!step.is_form("tell") || step.size() < 2) continue;
    return board_.statistics().came(step[1].head(), sent, executor_.now());
  }
}

// False where it must wait for an index, or its turn.
bool BoardServer::answer(wire::SessionId id, Session& session, wire::RequestId number,
                         const Postponed::Message& waiting) {
  const Datum& body = waiting.datum[3];
  const bool of_past = past_ && body.is_form("ask") && body.size() == 2 && asks_past(body[1]);
  if (of_past) {
    ask_past(id, session, number, body);
    return true;
  }
  const bool durable = durability_.concerns_durable(board_.store(), body);
  const Result<void> room = durability_.check_room(body, durable);
  if (!room) {
    refuse_undone(session, number, body, room.error());
    return true;
  }
  const journal::JournalWriter::Position before = durability_.position();
  const std::optional<Result<Datum>> performed = perform_in_turn(id, session, waiting);
  if (!performed) return false;
  const Result<Datum>& result = *performed;
  if (!result && is_refusal(result.error())) refusals_.note(session.client(), result.error());
  const Datum said = result_to_datum(result);
  std::string text = reply_text(number, said);
  const bool held = durability_.must_hold(durable);
  const bool stands = result && durable && durability_.position() > before;
  if (must_be_done_once(body)) {
    session.done.add(number, {text, held ? durability_.position() : 0, stands});
    if (durable && durability_.position() > before) {
      const std::string key = session.key ? session.key->key : "";
      durability_.remember({id, session.teller, number, said, key});
    }
  }
  const bool goes_with_others = receiving_ && body.is_form("transact") && !held && !session.holds;
  if (goes_with_others) {
    owe(session.peer, text);
    return true;
  }
  // Changes go before the reply to the request that made them, and after the one to the request for them.
  if (!body.is_form("watch")) flush_all();
  if (held) {
    durability_.hold(id, number, {std::move(text), durability_.position(), stands});
  } else {
    socket_->send(session.peer, session.holds ? with_progress(session, text) : text);
  }
  return true;
}

// To a transaction of the frame that is being received. So few wait for each other that none waits long.
void BoardServer::owe(const std::string& peer, const std::string& reply) {
  constexpr int most_together = 4;
  owed_to_ = peer;
  owed_ += reply;
  if (++owed_replies_ == most_together) deliver();
}

void BoardServer::deliver() {
  flush_all();
  if (owed_replies_ == 0) return;
  socket_->send(owed_to_, owed_);
  owed_.clear();
  owed_replies_ = 0;
}

// A remembered or held back reply does not carry the permission to send more: it may be given when changes are under
// way anew.
std::string BoardServer::with_progress(const Session& session, std::string reply) const {
  reply.back() = ' ';
  write_number_to(reply, board_.store().revision());
  reply += session.watches.are_behind() ? " no)" : " yes)";
  return reply;
}

Result<Datum> BoardServer::perform(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined) {
  if (body.is_form("watch")) return watch(id, session, body, examined);
  return permitted_.perform(session.asking(), body, examined);
}

void BoardServer::ask_past(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body) {
  const auto reply = [this, id, number](const Result<Answers>& answers) {
    past_asked_.erase({id, number});
    const Session* const asking = sessions_.find(id);
    if (asking == nullptr) return;
    if (!answers) {
      std::size_t examined = 0;
      const Failure failure = permitted_.told(asking->asking(), answers.error(), examined);
      turns_.took(id, examined, executor_.now());
      return refuse_request(*asking, number, failure);
    }
    socket_->send(asking->peer, reply_text(number, result_to_datum(wire::answers_to_datum(*answers))));
  };
  // One that is asked again while it is worked on is answered once.
  if (!past_asked_.emplace(id, number).second) return;
  Result<Query> query = permitted_.query_of(session.asking(), body);
  if (!query) return reply(fail(query));
  past_->ask(session.client(), std::move(*query), reply);
}

Result<Datum> BoardServer::watch(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined) {
  const std::optional<std::uint64_t> number = wire::count_at(body, 1);
  const bool held = body.size() == 4 && body[3].is_symbol("held");
  const bool kept = held || (body.size() == 4 && body[3].is_symbol("kept"));
  if (!number || (body.size() != 3 && !kept)) {
    return fail("bad-frame", "watching is (watch WATCH QUERY), or has kept or held after it");
  }
  if (const Datum* standing = session.watches.asked(*number)) {
    if (*standing == body[2]) return Datum();
    return fail("bad-frame", "the watch is of another query");
  }
  if (session.watches.size() >= ServedWatches::most) return too_many_watches();
  Result<std::unique_ptr<watch::WatchQueue>> queue = permitted_.watch(
      session.asking(), body[2], [this, id] { schedule_flush(id); }, session.watches.backlog(), examined);
  if (!queue) return fail(queue);
  session.watches.add(*number, body[2], kept, std::move(*queue));
  session.holds = session.holds || held;
  schedule_flush(id);
  return Datum();
}

}  // namespace pizarra::server
