#pragma once

// A session with the board at an address, under the key in a file; "" for none.
//
//   const auto board = client::keyed_board(executor, address, key_file, "look");
//   if (!board) return complain(board.error());
//
// Failures as of read_client_keys and RemoteBoard::connect. The board need not be there yet.

#include <optional>
#include <string>

#include "blackboard/client/remote_board.hpp"

namespace pizarra::client {

// No keys where no file is named. Failures as of read_client_keys.
inline Result<std::optional<wire::ClientKeys>> keys_from(const std::string& file) {
  if (file.empty()) return std::nullopt;
  Result<wire::ClientKeys> keys = wire::read_client_keys(file);
  if (!keys) return fail(keys);
  return std::move(*keys);
}

inline Result<std::unique_ptr<RemoteBoard>> keyed_board(Executor& executor, const std::string& address,
                                                        const std::string& key_file, const std::string& client,
                                                        Duration timeout = RemoteBoard::default_timeout) {
  const Result<std::optional<wire::ClientKeys>> keys = keys_from(key_file);
  if (!keys) return fail(keys);
  return RemoteBoard::connect(executor, address, client, timeout, *keys);
}

}  // namespace pizarra::client
