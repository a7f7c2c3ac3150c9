// What a BoardServer's clients ask of the board, and what each is answered: once, however often it is asked.

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "lisp/shortened.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

// Whatever a request fails with is a refusal, but that its own precondition does not hold, which is an answer, and a
// full disk, which is not its doing.
bool is_refusal(const Failure& failure) {
  return failure.symbol != "precondition-failed" && failure.symbol != "journal-full";
}

std::unexpected<Failure> bad_frame(const char* sentence) { return fail("bad-frame", sentence); }

// Whether doing it twice would differ from doing it once.
bool must_be_done_once(const Datum& body) {
  return body.is_form("transact") || body.is_form("take") || body.is_form("lease") || body.is_form("release");
}

Datum result_to_datum(const Result<Datum>& result) {
  if (result) return list("ok"_sym, *result);
  Failure failure = result.error();
  constexpr std::size_t longest_sentence = 1 << 10;
  constexpr std::size_t heaviest_subject = 1 << 12;
  failure.sentence = shortened(failure.sentence, longest_sentence);
  const bool heavy = weigh(failure.subject).bytes > heaviest_subject;
  if (heavy) failure.subject = failure.subject.items().empty() ? Datum() : failure.subject[0];
  if (weigh(failure.subject).bytes > heaviest_subject) failure.subject = {};
  return failure_to_datum(failure);
}

std::string reply_text(wire::RequestId id, const Datum& result) {
  std::string text = "(reply ";
  write_number_to(text, id);
  write_to(text += ' ', result);
  text += ')';
  return text;
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

void BoardServer::request(wire::SessionId id, Session& session, const Postponed::Message& waiting) {
  const Datum& message = waiting.datum;
  const std::optional<std::uint64_t> number = wire::count_at(message, 2);
  const bool timed = message.size() == 5 && message[4].is_integer();
  const Failure malformed{"bad-frame", "a request is (request SESSION ID BODY) or has its time after it", {}, {}};
  if (!number) return refuse(session.peer, malformed);
  if (message.size() != 4 && !timed) return refuse_request(session, *number, malformed);
  if (waiting.waits > 0) return serve(id, session, *number, waiting);
  const Result<void> served = board_.statistics().requests().ask(client_of(session), session.heard);
  for (const Answered* answered : {&session.done, &session.refused}) {
    // One that is held comes when it may.
    const Durability::Reply* again = answered->find(*number);
    if (again != nullptr) return durability_.answer_again(id, *number, *again);
  }
  const bool long_ago = *number <= std::max(session.done.forgotten(), session.refused.forgotten());
  if (must_be_done_once(message[3]) && long_ago) {
    return refuse_request(session, *number,
                          {"bad-frame", "this request, or one far after it, was answered long ago", {}, {}});
  }
  if (!served) {
    refusals_.note(client_of(session), served.error());
    return refuse_undone(session, *number, message[3], served.error());
  }
  serve(id, session, *number, waiting);
}

void BoardServer::refuse_request(const Session& session, wire::RequestId number, const Failure& failure) {
  refusals_.note(client_of(session), failure);
  socket_.send(session.peer, reply_text(number, result_to_datum(fail(failure))));
}

// One that is on its way a second time is refused as well, though it could be done by then.
void BoardServer::refuse_undone(Session& session, wire::RequestId number, const Datum& body, const Failure& failure) {
  const std::string refusal = reply_text(number, result_to_datum(fail(failure)));
  if (must_be_done_once(body)) session.refused.add(number, {refusal});
  socket_.send(session.peer, refusal);
}

// To the request that it begins as, where it is one of the sender's session.
void BoardServer::refuse_unreadable(const std::string& peer, std::string_view frame, const Failure& failure) {
  const auto session = session_of_peer_.find(peer);
  if (session == session_of_peer_.end()) return refuse(peer, failure);
  const std::optional<wire::RequestId> number = wire::request_begun(frame, session->second);
  if (!number) return refuse(peer, failure);
  refuse_request(sessions_.at(session->second), *number, failure);
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

// False where it must wait for an index.
bool BoardServer::answer(wire::SessionId id, Session& session, wire::RequestId number, const Datum& body,
                         std::size_t waits) {
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
  const JournalWriter::Position before = durability_.position();
  const std::optional<Result<Datum>> performed = perform_within_quota(id, session, body, waits);
  if (!performed) return false;
  const Result<Datum>& result = *performed;
  if (!result && is_refusal(result.error())) refusals_.note(client_of(session), result.error());
  const Datum said = result_to_datum(result);
  std::string text = reply_text(number, said);
  const bool stands = result && durable && durability_.position() > before;
  if (must_be_done_once(body)) {
    session.done.add(number, {text, durable ? durability_.position() : 0, stands});
    if (durable && durability_.position() > before) {
      const std::string key = session.key ? session.key->key : "";
      durability_.remember({id, session.teller, number, said, key});
    }
  }
  // Changes go before the reply to the request that made them, and after the one to the request for them.
  if (!body.is_form("watch")) flush_all();
  if (durable) {
    durability_.hold(id, number, {std::move(text), durability_.position(), stands});
  } else {
    socket_.send(session.peer, session.holds ? with_progress(session, text) : text);
  }
  return true;
}

// What is remembered, or held back, does not say it: it may be given when changes are under way anew.
std::string BoardServer::with_progress(const Session& session, std::string reply) const {
  reply.back() = ' ';
  write_number_to(reply, board_.store().revision());
  reply += session.watches.are_behind() ? " no)" : " yes)";
  return reply;
}

Result<Datum> BoardServer::perform(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined) {
  if (body.is_form("transact")) return transact(session, body, examined);
  if (body.is_form("ask")) return ask(session, body, examined);
  if (body.is_form("take")) return take(session, body, examined);
  if (body.is_form("declare")) return declare(session, body);
  if (body.is_form("watch")) return watch(id, session, body, examined);
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

Result<Datum> BoardServer::transact(const Session& session, const Datum& body, std::size_t& examined) {
  const Result<Transaction> transaction = wire::transaction_from_datum(body);
  if (!transaction) return fail(transaction);
  const Result<void> permitted = gate_.transact(key_of(session), *transaction, examined);
  if (!permitted) return fail(permitted);
  const Result<void> room = durability_.check_room(board_.store(), body, *transaction);
  if (!room) return fail(room);
  const Result<Revision> revision = board_.transact(session.teller, *transaction, examined);
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

Result<Datum> BoardServer::ask(const Session& session, const Datum& body, std::size_t& examined) {
  const Result<Query> query = permitted_query(session, body);
  if (!query) return fail(query);
  const Result<Answers> answers = board_.ask(*query, examined);
  // To say them takes as long as to look at some more facts that are none.
  constexpr std::size_t looks_an_answer = 8;
  if (answers) examined += looks_an_answer * answers->answers.size();
  return answers_to_datum(answers);
}

void BoardServer::ask_past(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body) {
  const auto reply = [this, id, number](const Result<Answers>& answers) {
    past_asked_.erase({id, number});
    const auto asking = sessions_.find(id);
    if (asking == sessions_.end()) return;
    if (!answers) return refuse_request(asking->second, number, answers.error());
    socket_.send(asking->second.peer, reply_text(number, result_to_datum(answers_to_datum(answers))));
  };
  // One that is asked again while it is worked on is answered once.
  if (!past_asked_.emplace(id, number).second) return;
  Result<Query> query = permitted_query(session, body);
  if (!query) return reply(fail(query));
  past_->ask(client_of(session), std::move(*query), reply);
}

Result<Datum> BoardServer::take(const Session& session, const Datum& body, std::size_t& examined) {
  const std::optional<std::uint64_t> holder = wire::count_at(body, 2);
  if (!holder || body.size() != 3) return bad_frame("taking is (take PATTERN LEASE)");
  const Result<void> permitted = gate_.take(key_of(session), body[1], *holder);
  if (!permitted) return fail(permitted);
  const Result<std::optional<Fact>> taken = board_.take(session.teller, body[1], *holder, examined);
  if (!taken) return fail(taken);
  if (!*taken) return Datum();
  return list(wire::fact_to_datum(**taken));
}

Result<Datum> BoardServer::watch(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined) {
  const std::optional<std::uint64_t> number = wire::count_at(body, 1);
  const bool held = body.size() == 4 && body[3].is_symbol("held");
  const bool kept = held || (body.size() == 4 && body[3].is_symbol("kept"));
  if (!number || (body.size() != 3 && !kept)) {
    return bad_frame("watching is (watch WATCH QUERY), or has kept or held after it");
  }
  if (const Datum* standing = session.watches.asked(*number)) {
    if (*standing == body[2]) return Datum();
    return bad_frame("the watch is of another query");
  }
  if (session.watches.size() >= ServedWatches::most) return fail("too-large", "a client has at most 256 watches");
  const Result<Query> query = query_from_datum(body[2]);
  if (!query) return fail(query);
  const Result<void> permitted = gate_.ask(key_of(session), *query);
  if (!permitted) return fail(permitted);
  Result<std::unique_ptr<WatchQueue>> queue = board_.watch(
      session.teller, *query, [this, id] { schedule_flush(id); }, session.watches.backlog(), examined);
  if (!queue) return fail(queue);
  session.watches.add(*number, body[2], kept, std::move(*queue));
  session.holds = session.holds || held;
  schedule_flush(id);
  return Datum();
}

Result<Datum> BoardServer::lease(const Session& session, const Datum& body) {
  const bool whole = body.size() == 2 && body[1].is_integer();
  if (!whole) return bad_frame("not a request");
  if (body.is_form("lease")) {
    const Result<void> within = leases_.check(client_of(session));
    if (!within) return fail(within);
    const Result<LeaseId> lease = board_.lease(Duration(body[1].integer()));
    if (!lease) return fail(lease);
    gate_.granted(key_of(session), *lease);
    leases_.granted(client_of(session), *lease);
    return to_datum(*lease);
  }
  const std::optional<std::uint64_t> lease = wire::count_from(body[1]);
  const Result<void> permitted = gate_.use_lease(key_of(session), lease.value_or(0));
  if (!permitted) return fail(permitted);
  if (lease && body.is_form("renew")) return nothing_or(board_.renew(*lease));
  if (lease && body.is_form("release")) return nothing_or(board_.release(*lease));
  return bad_frame("not a request");
}

}  // namespace pizarra
