#include "blackboard/server/key_folder.hpp"

#include <filesystem>
#include <sys/stat.h>

#include "lisp/plain_name.hpp"

namespace pizarra::server {

Result<KeyFolder> KeyFolder::open(const std::string& folder) {
  const std::string secret = folder + "/" + std::string(wire::board_key_name) + ".secret";
  Result<wire::KeyPair> own = wire::read_secret_key(secret);
  if (!own) {
    Failure failure = own.error();
    if (failure.symbol == "unreadable-file") {
      failure.sentence =
          "the board has no key of its own there: `pizarra keys new board --dir " + folder + "` makes it";
    }
    return fail(std::move(failure));
  }
  const Result<std::vector<std::string>> files = wire::public_key_files(folder);
  if (!files) return fail(files);
  KeyFolder keys(folder, std::move(*own));
  keys.refresh();
  return keys;
}

// Of nothing, where it cannot be looked at.
KeyFolder::Stamp KeyFolder::stamp_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return {};
  constexpr std::int64_t ns_per_s = 1'000'000'000;
  return {status.st_ino, status.st_mtim.tv_sec * ns_per_s + status.st_mtim.tv_nsec, status.st_size};
}

bool KeyFolder::follow() { return stamp_of(folder_) != folder_stamp_ && refresh(); }

bool KeyFolder::refresh() {
  folder_stamp_ = stamp_of(folder_);
  const Result<std::vector<std::string>> files = wire::public_key_files(folder_);
  std::map<std::string, Stamp> stamps;
  for (const std::string& path : files ? *files : std::vector<std::string>()) {
    const Stamp stamp = stamp_of(path);
    if (stamp != Stamp()) stamps[path] = stamp;
  }
  if (stamps == stamps_) return false;
  stamps_ = std::move(stamps);
  keys_.clear();
  faults_.clear();
  if (!files) faults_.push_back(files.error());
  for (const auto& [path, stamp] : stamps_) read(path);
  return true;
}

void KeyFolder::read(const std::string& path) {
  const std::string stem = std::filesystem::path(path).stem();
  if (stem == wire::board_key_name) return;
  if (!is_plain_name(stem)) return faults_.push_back({"bad-name", "a file of keys is called NAME.key", {}, {}});
  Result<wire::PublicKey> key = wire::read_public_key(path);
  if (!key) return faults_.push_back(key.error());
  const auto fault = [&](std::string sentence) {
    faults_.push_back({"bad-key", stem + ".key " + std::move(sentence), Datum::symbol(key->name), {}});
  };
  if (stem != key->name) return fault("holds a key of another name");
  if (key->key == own_.public_key) return fault("holds the board's own key");
  const auto [standing, fresh] = keys_.emplace(key->key, *key);
  if (!fresh) fault("holds the key of " + standing->second.name);
}

const wire::PublicKey* KeyFolder::find(std::string_view public_key) const {
  const auto found = keys_.find(public_key);
  return found == keys_.end() ? nullptr : &found->second;
}

}  // namespace pizarra::server
