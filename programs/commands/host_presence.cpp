#include "programs/commands/host_presence.hpp"

#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration told_every = 1s;
constexpr Duration lease_length = 4s;

// Nothing before the board has said what its clock shows.
Task<Result<void>> tell_once(client::RemoteBoard& board, std::string host, LeaseId* lease) {
  const std::vector<Relation> relations = {host_relation()};
  const Result<void> declared = co_await board.declare(relations);
  if (!declared) co_return fail(declared);
  const Result<void> renewed = co_await board.renew(*lease);
  if (!renewed) {
    const Result<LeaseId> fresh = co_await board.lease(lease_length);
    if (!fresh) co_return fail(fresh);
    *lease = *fresh;
  }
  const std::optional<Time> there = board.board_time();
  if (!there) co_return Result<void>();
  const std::int64_t offset_ms = (RealExecutor::wall_clock() - *there) / 1ms;
  Transaction telling;
  telling.tell(list("host"_sym, to_datum(host), to_datum(version()), offset_ms), {}, *lease);
  const Result<Revision> told = co_await board.transact(std::move(telling));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

}  // namespace

Relation host_relation() {
  const auto form = read_one("(relation host ((name string) (version string) (offset-ms integer)) (key name))");
  return relation_from_datum(form.value()).value();
}

// Where the board is away, it is told when it is back.
Task<void> tell_host(client::RemoteBoard& board, Executor& executor, std::string host) {
  LeaseId lease = 0;
  while (true) {
    (void)co_await tell_once(board, host, &lease);
    co_await sleep(executor, told_every);
  }
}

}  // namespace pizarra::programs
