#include "blackboard/wire/keys.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <zmq.h>

#include "blackboard/limits.hpp"
#include "lisp/plain_name.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::wire {

namespace {

constexpr std::size_t raw_length = 32;
constexpr std::size_t most_key_files = 1024;

constexpr const char* permitted_names =
    "a relation is a name of at most 128 characters, a beginning with a star, or a star for all";

// A relation's, or the beginning of some.
bool is_permitted_name(std::string_view name) {
  return name.size() <= limits::name_bytes && is_symbol_name(name) && name.front() != '?' &&
         name.find('*') >= name.size() - 1;
}

bool is_key(const Datum& datum) {
  if (!datum.is_string() || datum.text().size() != key_length) return false;
  std::array<std::uint8_t, raw_length> raw{};
  return zmq_z85_decode(raw.data(), std::string(datum.text()).c_str()) != nullptr;
}

std::unexpected<Failure> bad_key(const Source& source, std::vector<std::size_t> path, std::string sentence) {
  return fail(source.failure_at(path, "bad-key", std::move(sentence)));
}

Result<Source> read_form(const std::string& path, const char* head) {
  ReadLimits allowed;
  allowed.bytes = 1 << 16;
  Result<Source> source = read_source_file(path, allowed);
  if (!source) return source;
  if (source->data().size() != 1 || !source->data().front().is_form(head)) {
    return bad_key(*source, {0}, std::string("this file holds one form, (") + head + " NAME ...)");
  }
  const Datum& form = source->data().front();
  if (form.size() < 3 || !form[1].is_symbol() || !is_plain_name(form[1].text())) {
    return bad_key(*source, {0, 1}, "a key's name has letters, digits and dashes, a letter first");
  }
  if (!is_key(form[2])) return bad_key(*source, {0, 2}, "a key is a string of 40 characters of Z85");
  return source;
}

std::vector<std::string>* permission_called(Permissions& may, std::string_view name) {
  if (name == "tell") return &may.tell;
  if (name == "take") return &may.take;
  if (name == "read") return &may.read;
  if (name == "override") return &may.override_leases;
  return nullptr;
}

Result<Permissions> read_permissions(const Source& source) {
  Permissions may;
  const Datum& form = source.data().front();
  for (std::size_t i = 3; i < form.size(); ++i) {
    std::vector<std::string>* listed = permission_called(may, form[i].head());
    if (listed == nullptr)
      return bad_key(source, {0, i}, "a permission is (tell RELATION ...), take, read or override");
    if (!listed->empty()) return bad_key(source, {0, i}, "this permission is given already");
    for (std::size_t n = 1; n < form[i].size(); ++n) {
      const Datum& relation = form[i][n];
      if (!relation.is_symbol() || !is_permitted_name(relation.text())) {
        return bad_key(source, {0, i, n}, permitted_names);
      }
      listed->emplace_back(relation.text());
    }
  }
  return may;
}

std::unexpected<Failure> cannot_write(const std::string& path) {
  return fail("cannot-write", std::string("a key cannot be written: ") + std::strerror(errno), to_datum(path));
}

Result<void> write_new_file(const std::string& path, const std::string& text, mode_t mode) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (file < 0 && errno == EEXIST) return fail("already-there", "there is a key of this name already", to_datum(path));
  if (file < 0) return cannot_write(path);
  const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const bool kept = fsync(file) == 0;
  close(file);
  if (!written || !kept) return cannot_write(path);
  return {};
}

Datum permission_form(const char* name, const std::vector<std::string>& listed) {
  std::vector<Datum> form = {Datum::symbol(name)};
  for (const std::string& relation : listed) form.push_back(Datum::symbol(relation));
  return Datum::list(std::move(form));
}

std::string public_key_text(const KeyPair& pair, const Permissions& may) {
  std::string text = "(key " + pair.name + " " + write(to_datum(pair.public_key));
  const auto add = [&](const char* name, const std::vector<std::string>& listed) {
    if (!listed.empty()) text += "\n  " + write(permission_form(name, listed));
  };
  add("tell", may.tell);
  add("take", may.take);
  add("read", may.read);
  add("override", may.override_leases);
  return text + ")\n";
}

}  // namespace

bool permits(const std::vector<std::string>& listed, std::string_view relation) {
  return std::ranges::any_of(listed, [&](std::string_view pattern) {
    if (!pattern.ends_with('*')) return pattern == relation;
    return relation.starts_with(pattern.substr(0, pattern.size() - 1));
  });
}

bool may_call_itself(std::string_view name, std::string_view teller) {
  return teller.starts_with(name) && (teller.size() == name.size() || teller[name.size()] == '/');
}

std::string default_key_folder() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0') {
    return std::string(config) + "/pizarra/keys";
  }
  const char* home = std::getenv("HOME");
  return std::string(home == nullptr ? "." : home) + "/.config/pizarra/keys";
}

Result<KeyPair> make_keys(const std::string& folder, const std::string& name, const Permissions& may) {
  if (!is_plain_name(name)) {
    return fail("bad-name", "a key's name has letters, digits and dashes, a letter first, and " +
                                std::to_string(longest_plain_name) + " at most");
  }
  for (const auto* listed : {&may.tell, &may.take, &may.read, &may.override_leases}) {
    for (const std::string& relation : *listed) {
      if (is_permitted_name(relation)) continue;
      return fail("bad-name", permitted_names, is_string_text(relation) ? to_datum(relation) : Datum());
    }
  }
  std::error_code refused;
  if (std::filesystem::create_directories(folder, refused)) chmod(folder.c_str(), S_IRWXU);
  const std::string base = folder + "/" + name;
  if (std::filesystem::exists(base + ".key", refused)) {
    return fail("already-there", "there is a key of this name already", to_datum(base + ".key"));
  }
  std::array<char, key_length + 1> public_key{};
  std::array<char, key_length + 1> secret_key{};
  if (zmq_curve_keypair(public_key.data(), secret_key.data()) != 0) {
    return fail("cannot-write", "this ZeroMQ was built without CURVE");
  }
  KeyPair pair{name, public_key.data(), secret_key.data()};
  const std::string secret = write(list("secret-key"_sym, Datum::symbol(name), pair.public_key, pair.secret_key));
  const Result<void> kept = write_new_file(base + ".secret", secret + "\n", S_IRUSR | S_IWUSR);
  if (!kept) return fail(kept);
  const Result<void> shown = write_new_file(base + ".key", public_key_text(pair, may), 0644);
  if (!shown) {
    std::filesystem::remove(base + ".secret", refused);
    return fail(shown);
  }
  return pair;
}

Result<PublicKey> read_public_key(const std::string& path) {
  const Result<Source> source = read_form(path, "key");
  if (!source) return fail(source);
  Result<Permissions> may = read_permissions(*source);
  if (!may) return fail(may);
  const Datum& form = source->data().front();
  return PublicKey{std::string(form[1].text()), std::string(form[2].text()), std::move(*may)};
}

Result<KeyPair> read_secret_key(const std::string& path) {
  struct stat status {};
  constexpr mode_t others = S_IRWXG | S_IRWXO;
  if (stat(path.c_str(), &status) == 0 && (status.st_mode & others) != 0) {
    return fail("exposed-key", "others may read this secret: chmod 600 it, and if they may have, make a new key",
                is_string_text(path) ? to_datum(path) : Datum());
  }
  const Result<Source> source = read_form(path, "secret-key");
  if (!source) return fail(source);
  const Datum& form = source->data().front();
  if (form.size() != 4 || !is_key(form[3])) {
    return bad_key(*source, {0, 3}, "a secret key is (secret-key NAME \"PUBLIC\" \"SECRET\")");
  }
  return KeyPair{std::string(form[1].text()), std::string(form[2].text()), std::string(form[3].text())};
}

Result<ClientKeys> read_client_keys(const std::string& path) {
  Result<KeyPair> own = read_secret_key(path);
  if (!own) return fail(own);
  const std::string beside = std::filesystem::path(path).parent_path() / (std::string(board_key_name) + ".key");
  const Result<PublicKey> board = read_public_key(beside);
  if (!board) {
    Failure failure = board.error();
    failure.sentence = "the board's public key must stand beside " + path + ": " + failure.sentence;
    return fail(std::move(failure));
  }
  return ClientKeys{std::move(*own), board->key};
}

Result<std::vector<std::string>> public_key_files(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code refused;
  for (auto entry = std::filesystem::directory_iterator(folder, refused);
       !refused && entry != std::filesystem::directory_iterator(); entry.increment(refused)) {
    if (entry->path().extension() == ".key") files.push_back(entry->path());
    if (files.size() > most_key_files) {
      return fail("too-many", "a folder of keys holds at most " + std::to_string(most_key_files), to_datum(folder));
    }
  }
  if (refused) return fail("unreadable-file", "the folder of keys " + folder + " cannot be read: " + refused.message());
  std::ranges::sort(files);
  return files;
}

}  // namespace pizarra::wire
