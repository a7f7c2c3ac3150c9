#pragma once

// Declares a relation on a board that runs, as an agent of another program would.
//
//   declare_at("ipc:///tmp/board", "(relation seen ((name string)) (key name))", "keys/desk.secret");

#include <string>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"

namespace pizarra::programs {

// Whether the board took it.
inline bool declare_at(const std::string& address, const std::string& relation, const std::string& key = "") {
  RealExecutor executor;
  std::optional<wire::ClientKeys> keys;
  if (!key.empty()) keys = wire::read_client_keys(key).value();
  const auto board =
      client::RemoteBoard::connect(executor, address, "test", client::RemoteBoard::default_timeout, keys).value();
  bool taken = false;
  const auto declare = [](Board& on, std::vector<Relation> relations, bool& out) -> Task<void> {
    const Result<void> declared = co_await on.declare(std::move(relations));
    out = declared.has_value();
  };
  const Job job = executor.spawn(declare(*board, {relation_from_datum(read_one(relation).value()).value()}, taken));
  executor.run_until([&job] { return job.done(); });
  return taken;
}

}  // namespace pizarra::programs
