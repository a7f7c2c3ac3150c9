#include "blackboard/wire/tokens.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "blackboard/wire/keys.hpp"
#include "lisp/plain_name.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::wire {

namespace {

constexpr std::size_t secret_bytes = 32;

// Its owner's alone from the first byte on, and whole or not at all.
bool write_own_file(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  std::remove(part.c_str());
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0) return false;
  const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const bool closed = ::close(file) == 0;
  return written && closed && std::rename(part.c_str(), path.c_str()) == 0;
}

}  // namespace

std::string random_secret() {
  std::array<unsigned char, secret_bytes> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("no random numbers to be had");
  }
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out;
  for (const unsigned char byte : bytes) out.append({digits[byte >> 4U], digits[byte & 15U]});
  return out;
}

bool is_same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differing |= static_cast<unsigned char>(a[i] ^ b[i]);
  return differing == 0;
}

Result<std::string> make_token(const std::string& folder, const std::string& name) {
  if (!is_plain_name(name)) return fail("bad-name", "a key's name has letters, digits and dashes, a letter first");
  const std::string base = folder + "/" + name;
  std::error_code error;
  if (name == board_key_name || !std::filesystem::exists(base + ".secret", error)) {
    return fail("no-key", "there is no secret of this name here: make the token where the secret of its key is",
                Datum::symbol(name));
  }
  const std::string secret = random_secret();
  const Datum form = list("token"_sym, Datum::symbol(name), secret);
  if (!write_own_file(base + ".token", write(form) + "\n")) {
    return fail("cannot-write", std::string("the token cannot be written: ") + std::strerror(errno));
  }
  return name + "." + secret;
}

std::optional<std::string> key_of_token(const std::string& folder, std::string_view token) {
  const std::size_t dot = token.find('.');
  if (dot == std::string_view::npos || !is_plain_name(token.substr(0, dot))) return std::nullopt;
  const std::string name(token.substr(0, dot));
  const std::string path = folder + "/" + name + ".token";
  struct stat status {};
  constexpr mode_t others = S_IRWXG | S_IRWXO;
  if (stat(path.c_str(), &status) != 0 || (status.st_mode & others) != 0) return std::nullopt;
  ReadLimits allowed;
  allowed.bytes = 1024;
  const Result<Source> source = read_source_file(path, allowed);
  if (!source || source->data().size() != 1) return std::nullopt;
  const Datum& form = source->data().front();
  const bool right = form.is_form("token") && form.size() == 3 && form[2].is_string() &&
                     form[2].text().size() == 2 * secret_bytes && is_same_secret(form[2].text(), token.substr(dot + 1));
  if (!right) return std::nullopt;
  return name;
}

}  // namespace pizarra::wire
