#pragma once

// The keys that a board accepts: the `.key` files of one folder, followed as they come, change and go.
//
//   Result<KeyFolder> keys = KeyFolder::open("keys");       // board.secret must be there
//   if (keys->refresh()) ...                                // somebody changed a file: each is looked at
//   if (keys->follow()) ...                                 // the same, where files came or went since: for each hello
//   if (const PublicKey* key = keys->find(public_key)) key->may.tell;
//
// A file that cannot be read authorises nobody, nor does one whose name is not its key's; they are told by faults().
// Anybody who can write into the folder decides who may come: keep it to the board's user.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/wire/keys.hpp"

namespace pizarra::server {

class KeyFolder {
 public:
  // Failures as of read_secret_key and public_key_files.
  static Result<KeyFolder> open(const std::string& folder);

  const wire::KeyPair& own() const { return own_; }
  // Reads what changed since; whether anything did. follow() does not notice a change written into an existing file.
  bool refresh();
  bool follow();
  // The client whose public key this is, or nullptr; until the next refresh.
  const wire::PublicKey* find(std::string_view public_key) const;
  const std::vector<Failure>& faults() const { return faults_; }

 private:
  struct Stamp {
    std::uint64_t file = 0;
    std::int64_t changed_ns = 0;
    std::int64_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  KeyFolder(std::string folder, wire::KeyPair own) : folder_(std::move(folder)), own_(std::move(own)) {}
  static Stamp stamp_of(const std::string& path);
  void read(const std::string& path);

  std::string folder_;
  wire::KeyPair own_;
  Stamp folder_stamp_;
  std::map<std::string, Stamp> stamps_;
  std::map<std::string, wire::PublicKey, std::less<>> keys_;  // by public key
  std::vector<Failure> faults_;
};

}  // namespace pizarra::server
