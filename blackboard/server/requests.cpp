#include "blackboard/server/requests.hpp"

#include <algorithm>
#include <ranges>

#include "blackboard/limits.hpp"
#include "blackboard/server/replies.hpp"
#include "blackboard/store/indexing.hpp"
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

}  // namespace

Requests::Requests(Executor& executor, memory::MemoryBoard& board, Sessions& sessions, Refusals& refusals,
                   Workload& workload, Outbox& outbox, const Journals& journals)
    : executor_(executor),
      board_(board),
      sessions_(sessions),
      refusals_(refusals),
      workload_(workload),
      outbox_(outbox),
      durability_(journals.journal, journals.answers_from_journal),
      held_(journals.journal,
            [this](wire::SessionId id, const std::string& reply) {
              const Session* session = sessions_.find(id);
              if (session != nullptr) outbox_.send(session->peer, reply);
            }),
      permitted_(board, durability_) {
  journal::JournalWriter* const past = journals.past != nullptr ? journals.past : journals.journal;
  if (past != nullptr) past_.emplace(executor, *past, [this] { return board_.store().revision(); });
}

void Requests::restore(const std::vector<journal::RememberedReply>& remembered) {
  // The sessions with the newest are restored first, because there may be too many.
  for (const journal::RememberedReply& reply : remembered | std::views::reverse) {
    Session* const session = sessions_.restore(reply.session);
    if (session == nullptr) continue;
    session->teller = reply.teller;
    if (!reply.key.empty()) session->key = wire::PublicKey{.name = {}, .key = reply.key, .may = {}};
    session->heard = executor_.now();
    session->done.add(reply.request, {reply_text(reply.request, reply.result)});
  }
}

bool Requests::is_to_be_done(wire::SessionId id, Session& session, wire::RequestId number, const Datum& body) {
  if (session.postponed.has_request(number)) return false;
  const Result<void> served = board_.statistics().requests().ask(session.client(), session.heard);
  if (was_answered(id, session, number, body)) return false;
  if (!served) refuse_undone(session, number, body, served.error());
  return served.has_value();
}

// And is answered again.
bool Requests::was_answered(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body) {
  for (const KeptReplies* answered : {&session.done, &session.refused}) {
    const HeldReplies::Reply* again = answered->find(number);
    if (again == nullptr) continue;
    // One that is held comes when it may.
    outbox_.flush_all();
    held_.answer_again(id, number, *again);
    return true;
  }
  const bool long_ago = number <= std::max(session.done.forgotten(), session.refused.forgotten());
  if (!must_be_done_once(body) || !long_ago) return false;
  refuse(session, number, {"bad-frame", "this request, or one far after it, was answered long ago", {}, {}});
  return true;
}

void Requests::refuse(const Session& session, wire::RequestId number, const Failure& failure) {
  refusals_.note(session.client(), failure);
  outbox_.send(session.peer, reply_text(number, result_to_datum(fail(failure))));
}

void Requests::refuse_undone(Session& session, wire::RequestId number, const Datum& body, const Failure& failure) {
  if (is_refusal(failure)) refusals_.note(session.client(), failure);
  const std::string refusal = reply_text(number, result_to_datum(fail(failure)));
  if (must_be_done_once(body)) session.refused.add(number, {refusal});
  outbox_.send(session.peer, refusal);
}

// Of the first fact that the transaction told.
void Requests::note_journey(const Datum& body, Time sent) {
  if (!body.is_form("transact") || body.size() < 3) return;
  for (const Datum& step : body[2].items()) {
    if (!step.is_form("tell") || step.size() < 2) continue;
    return board_.statistics().came(step[1].head(), sent, executor_.now());
  }
}

bool Requests::serve(wire::SessionId id, Session& session, const Postponed::Message& waiting) {
  const Datum& message = waiting.datum;
  const Datum& body = message[3];
  const wire::RequestId number = *wire::count_at(message, 2);
  if (asks_past(body)) {
    ask_past(id, session, number, body);
    return true;
  }
  const Result<Durability::Before> before = durability_.begin(board_.store(), body);
  if (!before) {
    refuse_undone(session, number, body, before.error());
    return true;
  }
  const Revision revision = board_.store().revision();
  const std::optional<Result<Datum>> result = perform_in_turn(id, session, waiting);
  if (!result) return false;
  answer(id, session, {number, body, *before}, *result);
  const bool timed = message.size() == 5;
  if (timed && board_.store().revision() > revision) note_journey(body, Time(Duration(message[4].integer())));
  return true;
}

void Requests::answer(wire::SessionId id, Session& session, const Done& done, const Result<Datum>& result) {
  if (!result && is_refusal(result.error())) refusals_.note(session.client(), result.error());
  const Datum said = result_to_datum(result);
  std::string text = reply_text(done.number, said);
  const auto [changed, awaited] = durability_.end(board_.store(), done.body, done.before);
  const bool stands = result && changed;
  if (must_be_done_once(done.body)) {
    session.done.add(done.number, {text, awaited, stands});
    if (changed) {
      const std::string key = session.key ? session.key->key : "";
      durability_.remember({id, session.teller, done.number, said, key});
    }
  }
  const bool goes_with_others =
      outbox_.is_receiving() && done.body.is_form("transact") && awaited == 0 && !session.holds;
  if (goes_with_others) return outbox_.owe(session.peer, text);
  // Changes go before the reply to the request that made them, and after the one to the request for them.
  if (!done.body.is_form("watch")) outbox_.flush_all();
  if (awaited > 0) {
    held_.hold(id, done.number, {std::move(text), awaited, stands});
  } else {
    outbox_.reply(session, text);
  }
}

// Out of its turn it may look at few facts alone. Nothing where it must wait.
std::optional<Result<Datum>> Requests::perform_in_turn(wire::SessionId id, Session& session,
                                                       const Postponed::Message& waiting) {
  const bool has_turn = waiting.has_waited() || workload_.is_free();
  const std::size_t before = has_turn ? 0 : limits::examined - Workload::out_of_turn;
  const bool may_wait = has_turn && waiting.may_wait();
  const store::Indexing indexing(may_wait ? store::Indexing::May::make_in_parts : store::Indexing::May::not_make,
                                 &board_.store().index_maker());
  std::size_t examined = before;
  const Datum& body = waiting.datum[3];
  Result<Datum> result =
      body.is_form("watch") ? watch(id, session, body, examined) : permitted_.perform(session.asking(), body, examined);
  const std::size_t looked_at = examined - before + indexing.examined();
  workload_.took_for_request(id, looked_at);
  if (indexing.awaited() != 0) {
    session.awaited = indexing.awaited();
    return std::nullopt;
  }
  if (has_turn || result || result.error().symbol != "too-costly") return result;
  workload_.wait(session.client(), id);
  return std::nullopt;
}

bool Requests::asks_past(const Datum& body) const {
  if (!past_ || !body.is_form("ask") || body.size() != 2 || !body[1].is_form("query")) return false;
  return std::ranges::any_of(body[1].items(), [](const Datum& option) { return option.is_form("at"); });
}

void Requests::ask_past(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body) {
  const auto reply = [this, id, number](const Result<Answers>& answers) {
    past_asked_.erase({id, number});
    const Session* const asking = sessions_.find(id);
    if (asking == nullptr) return;
    if (!answers) {
      std::size_t examined = 0;
      const Failure failure = permitted_.told(asking->asking(), answers.error(), examined);
      workload_.took(id, examined);
      return refuse(*asking, number, failure);
    }
    Answers readable = *answers;
    PermittedBoard::leave_out_unreadable(asking->asking(), readable);
    outbox_.send(asking->peer, reply_text(number, result_to_datum(wire::answers_to_datum(readable))));
  };
  // One that is asked again while it is worked on is answered once.
  if (!past_asked_.emplace(id, number).second) return;
  Result<Query> query = permitted_.query_of(session.asking(), body);
  if (!query) return reply(fail(query));
  past_->ask(session.client(), std::move(*query), reply);
}

Result<Datum> Requests::watch(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined) {
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
      session.asking(), body[2], [this, id] { outbox_.schedule(id); }, session.watches.backlog(), examined);
  if (!queue) return fail(queue);
  session.watches.add(*number, body[2], kept, std::move(*queue));
  session.holds = session.holds || held;
  outbox_.schedule(id);
  return Datum();
}

}  // namespace pizarra::server
