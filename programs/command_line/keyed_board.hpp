#pragma once

// A session with the board at an address, under the key in a file; "" for none.
//
//   const auto board = keyed_board(executor, to->address, to->key, "look");
//   if (!board) return complain(board.error(), exit_usage);
//
// Failures as of read_client_keys and RemoteBoard::connect. The board need not be there yet.

#include "blackboard/client/remote_board.hpp"
#include "programs/command_line/key_option.hpp"

namespace pizarra::programs {

inline Result<std::unique_ptr<client::RemoteBoard>> keyed_board(
    Executor& executor, const std::string& address, const std::string& key_file, const std::string& client,
    Duration timeout = client::RemoteBoard::default_timeout) {
  const Result<std::optional<wire::ClientKeys>> keys = keys_from(key_file);
  if (!keys) return fail(keys);
  return client::RemoteBoard::connect(executor, address, client, timeout, *keys);
}

}  // namespace pizarra::programs
