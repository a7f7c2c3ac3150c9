#include "agents/runtime/presence.hpp"

#include "agents/runtime/naming.hpp"
#include "agents/runtime/own_name.hpp"
#include "blackboard/away.hpp"

namespace pizarra::runtime {

namespace {

// A relation's other shape on the board most often comes from its journal.
Failure of_another_version(Failure failure) {
  failure.sentence += ", by another version of the agents: begin with a board, and a journal, of its own";
  return failure;
}

}  // namespace

Task<Result<void>> Presence::declare() {
  std::vector<Relation> relations = runtime_relations();
  relations.insert(relations.end(), contract_.posts.begin(), contract_.posts.end());
  relations.insert(relations.end(), contract_.reads.begin(), contract_.reads.end());
  while (true) {
    const Result<void> declared = co_await context_.board.declare(relations);
    if (declared) co_return declared;
    if (declared.error().symbol == "wrong-shape") co_return fail(of_another_version(declared.error()));
    if (!is_away(declared.error())) co_return declared;
    co_await sleep(context_.executor, retry_pause);
  }
}

Transaction Presence::facts(LeaseId lease) const {
  const Datum name = Datum::symbol(context_.name);
  Transaction presence;
  presence.tell(list("agent"_sym, name, Datum::symbol(contract_.kind), context_.host), {}, lease);
  presence.tell(list("contract"_sym, name, contract_.form), {}, lease);
  return presence;
}

// One try to stand on the board under the agent's name.
Task<Result<void>> Presence::announce() {
  const Result<LeaseId> lease = co_await context_.board.lease(lease_length);
  if (!lease) co_return fail(lease);
  Transaction presence = facts(*lease);
  const Transaction::Absent vacancy{list("agent"_sym, Datum::symbol(context_.name), "?"_sym, "?"_sym)};
  presence.require(vacancy);
  const Result<Revision> told = co_await context_.board.transact(std::move(presence));
  if (told) {
    lease_ = *lease;
    announced_.wake_all();
    co_return {};
  }
  const Result<void> released = co_await context_.board.release(*lease);
  if (!released && told.error().symbol == "precondition-failed") co_return fail(released);
  co_return fail(told);
}

Task<Result<void>> Presence::start() {
  const Result<void> declared = co_await declare();
  if (!declared) co_return declared;
  while (true) {
    const Result<void> announced = co_await announce();
    if (announced) break;
    const Failure& why = announced.error();
    // The name is held by a living agent, or by one whose lease has yet to lapse.
    if (why.symbol != "precondition-failed" && !is_away(why)) co_return announced;
    co_await sleep(context_.executor, retry_pause);
  }
  co_await bind_own_name();
  keeping_ = context_.executor.spawn(keep());
  co_return {};
}

// A key that was made for less need not let it; then nobody finds it by its kind, and who knows its name does.
Task<void> Presence::bind_own_name() {
  if (contract_.offers.empty() || !may_bind_) co_return;
  if (!names_declared_) {
    std::vector<Relation> relations = naming_relations();
    const Result<void> declared = co_await context_.board.declare(std::move(relations));
    may_bind_ = declared || declared.error().symbol != "not-permitted";
    if (!declared) co_return;
    names_declared_ = true;
  }
  Transaction binding = own_binding(context_.name, contract_, lease_);
  const Result<Revision> bound = co_await context_.board.transact(std::move(binding));
  may_bind_ = bound || bound.error().symbol != "not-permitted";
}

Task<void> Presence::keep() {
  while (true) {
    co_await sleep(context_.executor, renewal);
    const Result<void> renewed = co_await context_.board.renew(lease_);
    if (renewed) {
      // Told again, which changes nothing unless somebody retracted it: who lives is present. A renewal that fails is
      // tried again at the next one.
      Transaction presence = facts(lease_);
      [[maybe_unused]] const Result<Revision> stands = co_await context_.board.transact(std::move(presence));
      co_await bind_own_name();
      continue;
    }
    if (renewed.error().symbol != "unknown-lease") continue;
    // The board forgot us (it restarted, or we were away too long); whoever took the name meanwhile keeps it.
    Result<void> announced = co_await announce();
    while (!announced) {
      co_await sleep(context_.executor, retry_pause);
      announced = co_await announce();
    }
    co_await bind_own_name();
  }
}

Task<Result<void>> Presence::end() {
  keeping_ = Job();
  Result<void> released = co_await context_.board.release(lease_);
  co_return released;
}

Task<void> Presence::until_replaced(LeaseId lease) {
  while (lease_ == lease) co_await announced_.wait();
}

}  // namespace pizarra::runtime
