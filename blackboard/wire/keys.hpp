#pragma once

// Keys: who may come to a board over the network, and what each may do there. A key is a pair of files,
//
//   (key robot "PUBLIC" (tell arm arm-* reply) (take request) (read *))     robot.key: goes to the board's folder
//   (secret-key robot "PUBLIC" "SECRET")                                    robot.secret: its owner's alone, mode 0600
//
// with the CURVE keys as 40 characters of Z85, and a plain name (lisp/plain_name.hpp). A permission lists relations: a
// name, a beginning with a star, or a star for all. What is not listed is not permitted.
//
//   tell       tell and retract facts, except those that another told under its lease
//   take       take facts
//
//   read       ask for and watch facts
//   override   replace and retract also facts that another told under its lease
//
//   Result<KeyPair> pair = make_keys("keys", "robot", permissions);   // writes both files
//   Result<ClientKeys> keys = read_client_keys("keys/robot.secret");  // with the board's public key, board.key beside
//   it

#include <string>
#include <string_view>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::wire {

// The name under which a board has its own keys; no client has it.
inline constexpr std::string_view board_key_name = "board";

// Of a CURVE key, characters of Z85.
inline constexpr std::size_t key_length = 40;

struct Permissions {
  std::vector<std::string> tell;
  std::vector<std::string> take;
  std::vector<std::string> read;
  std::vector<std::string> override_leases;
  bool operator==(const Permissions&) const = default;
};

// Whether one of `listed` means this relation.
bool permits(const std::vector<std::string>& listed, std::string_view relation);

struct PublicKey {
  std::string name;
  std::string key;
  Permissions may;
  bool operator==(const PublicKey&) const = default;
};

struct KeyPair {
  std::string name;
  std::string public_key;
  std::string secret_key;
};

// The keys that a client of an encrypted board needs.
struct ClientKeys {
  KeyPair own;
  std::string board_key;
};

// Whether a client with the key `name` may say that it is `teller`: NAME, or NAME/ANYTHING.
bool may_call_itself(std::string_view name, std::string_view teller);

// $XDG_CONFIG_HOME/pizarra/keys or ~/.config/pizarra/keys.
std::string default_key_folder();

// Makes the folder where it is missing. Failures bad-name, already-there, cannot-write.
Result<KeyPair> make_keys(const std::string& folder, const std::string& name, const Permissions& may);

// Failures unreadable-file, the reader's, bad-key, and for a secret that others may read, exposed-key.
Result<PublicKey> read_public_key(const std::string& path);
Result<KeyPair> read_secret_key(const std::string& path);
Result<ClientKeys> read_client_keys(const std::string& path);

// The `.key` files of a folder in the order of their names, the board's own among them. Failures unreadable-file,
// too-many.
Result<std::vector<std::string>> public_key_files(const std::string& folder);

}  // namespace pizarra::wire
