#include "programs/host/host_presence.hpp"

#include "agents/launcher/host_names.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::host {

namespace {

constexpr Duration told_every = 1s;
constexpr Duration lease_length = 4s;

Datum yes_or_no(bool whether) { return whether ? "yes"_sym : "no"_sym; }

// The lease that is held, renewed, or else a new one.
Task<Result<LeaseId>> lasting(client::RemoteBoard& board, LeaseId held) {
  if (held != 0) {
    const Result<void> renewed = co_await board.renew(held);
    if (renewed) co_return held;
  }
  co_return co_await board.lease(lease_length);
}

// Nothing before the board has said what its clock shows.
Task<Result<void>> tell_once(client::RemoteBoard& board, std::string host, LeaseId* lease) {
  const std::vector<Relation> relations = {host_relation()};
  const Result<void> declared = co_await board.declare(relations);
  if (!declared) co_return fail(declared);
  const Result<LeaseId> lasts = co_await lasting(board, *lease);
  if (!lasts) co_return fail(lasts);
  *lease = *lasts;
  const std::optional<Time> there = board.board_time();
  if (!there) co_return Result<void>();
  const std::int64_t offset_ms = (RealExecutor::wall_clock() - *there) / 1ms;
  Transaction telling;
  telling.tell(list("host"_sym, to_datum(host), to_datum(programs::version()), offset_ms), {}, *lease);
  const Result<Revision> told = co_await board.transact(std::move(telling));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

Relation process_relation() {
  const auto form = read_one(
      "(relation process ((host string) (name string) (running symbol) (restarts integer) (newest string)) (key host "
      "name))");
  return relation_from_datum(form.value()).value();
}

// A key that may not tell it still tells of its host. What stands already is told for nothing.
Task<void> tell_processes(client::RemoteBoard& board, std::string host,
                          std::vector<launcher::Supervisor::Process> processes, LeaseId lease) {
  const std::vector<Relation> relations = {process_relation()};
  const Result<void> declared = co_await board.declare(relations);
  if (!declared) co_return;
  Transaction telling;
  for (const launcher::Supervisor::Process& process : processes) {
    telling.tell(list("process"_sym, to_datum(host), to_datum(process.name), yes_or_no(process.pid != 0),
                      process.restarts, to_datum(process.newest)),
                 {}, lease);
  }
  [[maybe_unused]] const Result<Revision> told = co_await board.transact(std::move(telling));
}

}  // namespace

Relation host_relation() {
  const auto form = read_one("(relation host ((name string) (version string) (offset-ms integer)) (key name))");
  return relation_from_datum(form.value()).value();
}

// Where the board is away, it is told when it is back.
Task<void> tell_host(client::RemoteBoard& board, Executor& executor, std::string host, Processes processes) {
  LeaseId lease = 0;
  while (true) {
    const Result<void> told = co_await tell_once(board, host, &lease);
    if (told) {
      const std::vector<launcher::Supervisor::Process> kept = processes();
      co_await tell_processes(board, host, kept, lease);
      co_await launcher::bind_processes(board, host, kept, lease);
    }
    co_await sleep(executor, told_every);
  }
}

}  // namespace pizarra::host
