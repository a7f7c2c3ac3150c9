#include "blackboard/server/permitted_board.hpp"

#include <algorithm>

#include "blackboard/boards_own.hpp"
#include "blackboard/memory/own_permissions.hpp"
#include "blackboard/store/query_tables.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/watch/commit_looks.hpp"
#include "blackboard/watch/watch_queue.hpp"
#include "blackboard/wire/answer_form.hpp"

namespace pizarra::server {

namespace {

std::unexpected<Failure> bad_frame(const char* sentence) { return fail("bad-frame", sentence); }

memory::ListedPermissions listed_in(const wire::Permissions& may) {
  memory::ListedPermissions listed;
  const auto add = [&](const char* verb, const std::vector<std::string>& relations) {
    for (const std::string& relation : relations) listed.emplace_back(verb, relation);
  };
  add("tell", may.tell);
  add("take", may.take);
  add("read", may.read);
  add("override", may.override_leases);
  return listed;
}

Result<Datum> nothing_or(const Result<void>& result) {
  if (!result) return fail(result);
  return Datum();
}

}  // namespace

Result<Datum> PermittedBoard::perform(const Client& client, const Datum& body, std::size_t& examined) {
  Result<Datum> result = act(client, body, examined);
  if (!result) result.error() = told(client, std::move(result.error()), examined);
  return result;
}

Failure PermittedBoard::told(const Client& client, Failure failure, std::size_t& examined) const {
  const auto may_know = [&](std::string_view relation) { return KeyRights::may_know(client.key, relation); };
  return store::with_nearest(std::move(failure), board_.store().tables(), may_know, examined);
}

Result<Datum> PermittedBoard::act(const Client& client, const Datum& body, std::size_t& examined) {
  if (body.is_form("transact")) return transact(client, body, examined);
  if (body.is_form("ask")) return ask(client, body, examined);
  if (body.is_form("recall")) return recall(client, body, Duration::zero(), examined);
  if (body.is_form("take")) return take(client, body, examined);
  if (body.is_form("declare")) return declare(client, body);
  return lease(client, body, examined);
}

Result<std::unique_ptr<watch::WatchQueue>> PermittedBoard::watch(const Client& client, const Datum& query,
                                                                 std::function<void()> ready,
                                                                 std::shared_ptr<watch::Backlog> backlog,
                                                                 std::size_t& examined) {
  const Result<Query> watched = query_from_datum(query);
  if (!watched) return fail(watched);
  const Result<void> permitted = rights_.ask(client.key, *watched);
  if (!permitted) return fail(permitted);
  Result<std::unique_ptr<watch::WatchQueue>> queue =
      board_.watch(client.teller, *watched, std::move(ready), std::move(backlog), examined);
  if (!queue) queue.error() = told(client, std::move(queue.error()), examined);
  return queue;
}

Result<Datum> PermittedBoard::declare(const Client& client, const Datum& body) {
  std::vector<Relation> relations;
  for (const Datum& form : body.items().subspan(1)) {
    Result<Relation> relation = relation_from_datum(form);
    if (!relation) return fail(relation);
    relations.push_back(std::move(*relation));
  }
  const Result<void> permitted = rights_.declare(client.key, relations);
  if (!permitted) return fail(permitted);
  return nothing_or(board_.declare(client.teller, relations));
}

Result<Datum> PermittedBoard::transact(const Client& client, const Datum& body, std::size_t& examined) {
  const Result<Transaction> transaction = wire::transaction_from_datum(body);
  if (!transaction) return fail(transaction);
  const Result<void> permitted = rights_.transact(client.key, *transaction, examined);
  if (!permitted) return fail(permitted);
  const Result<void> room = durability_.check_room(board_.store(), body, *transaction);
  if (!room) return fail(room);
  const Result<Revision> revision = board_.transact(client.teller, *transaction, examined);
  if (!revision) return fail(revision);
  return to_datum(*revision);
}

Result<Query> PermittedBoard::query_of(const Client& client, const Datum& body) const {
  if (body.size() != 2) return bad_frame("a question is (ask QUERY) or (recall QUERY)");
  Result<Query> query = query_from_datum(body[1]);
  if (!query) return query;
  const Result<void> permitted = rights_.ask(client.key, *query);
  if (!permitted) return fail(permitted);
  return query;
}

Result<Datum> PermittedBoard::ask(const Client& client, const Datum& body, std::size_t& examined) {
  const Result<Query> query = query_of(client, body);
  if (!query) return fail(query);
  const Result<Answers> answers = answers_for(client, *query, examined);
  // To say them takes as long as to look at some more facts that are none.
  if (!answers) return fail(answers);
  examined += watch::CommitLooks::looks_an_answer * answers->answers.size();
  return wire::answers_to_datum(*answers);
}

Result<Answers> PermittedBoard::answers_for(const Client& client, const Query& query, std::size_t& examined) {
  const bool of_its_key = client.key != nullptr && store::asks_for(query, own_permission);
  if (!of_its_key) {
    Result<Answers> answers = board_.ask(query, examined, client.teller);
    if (answers) leave_out_unreadable(client, *answers);
    return answers;
  }
  const store::AskedAt asked{board_.store().revision(), board_.executor().now()};
  return memory::own_permissions(listed_in(client.key->may), query, asked, examined);
}

void PermittedBoard::leave_out_unreadable(const Client& client, Answers& answers) {
  if (client.key == nullptr) return;
  std::erase_if(answers.answers, [&](const Answer& answer) {
    return std::ranges::any_of(answer.facts, [&](const Fact& fact) {
      return fact.datum.is_form(provenance) && !wire::permits(client.key->may.read, fact.datum[3].head());
    });
  });
}

// One that leads answers as it does any question, when the log has what came before.
Result<Datum> PermittedBoard::recall(const Client& client, const Datum& body, Duration age, std::size_t& examined) {
  const Result<Datum> answers = ask(client, body, examined);
  if (!answers) return answers;
  const bool settled = age == Duration::zero() || durability_.has_all();
  std::vector<Datum> value = {Datum::integer(age.count()), settled ? "yes"_sym : "no"_sym};
  value.insert(value.end(), answers->items().begin(), answers->items().end());
  return Datum::list(std::move(value));
}

Result<Datum> PermittedBoard::take(const Client& client, const Datum& body, std::size_t& examined) {
  const std::optional<std::uint64_t> holder = wire::count_at(body, 2);
  if (!holder || body.size() != 3) return bad_frame("taking is (take PATTERN LEASE)");
  const Result<void> permitted = rights_.take(client.key, body[1], *holder);
  if (!permitted) return fail(permitted);
  const Result<std::optional<Fact>> taken = board_.take(client.teller, body[1], *holder, examined);
  if (!taken) return fail(taken);
  if (!*taken) return Datum();
  return list(wire::fact_to_datum(**taken));
}

Result<Datum> PermittedBoard::lease(const Client& client, const Datum& body, std::size_t& examined) {
  const bool whole = body.size() == 2 && body[1].is_integer();
  if (!whole) return bad_frame("not a request");
  if (body.is_form("lease")) {
    const Result<void> within = rights_.lease(client.key, client.name);
    if (!within) return fail(within);
    const Result<LeaseId> lease = board_.lease(Duration(body[1].integer()));
    if (!lease) return fail(lease);
    rights_.granted(client.key, client.name, *lease);
    return to_datum(*lease);
  }
  const std::optional<std::uint64_t> lease = wire::count_from(body[1]);
  const Result<void> permitted = rights_.use_lease(client.key, lease.value_or(0));
  if (!permitted) return fail(permitted);
  if (lease && body.is_form("renew")) return nothing_or(board_.renew(*lease));
  if (lease && body.is_form("release")) return nothing_or(board_.release(*lease, examined));
  return bad_frame("not a request");
}

}  // namespace pizarra::server
