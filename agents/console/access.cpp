#include "agents/console/access.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>
#include <sys/random.h>

namespace pizarra::console {

namespace {

constexpr std::size_t secret_bytes = 32;

std::string random_secret() {
  std::array<unsigned char, secret_bytes> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("no random numbers to be had");
  }
  std::string out;
  for (const unsigned char byte : bytes) out += fmt::format("{:02x}", byte);
  return out;
}

// In a time that does not tell how much of it is right.
bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differing |= static_cast<unsigned char>(a[i] ^ b[i]);
  return differing == 0;
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

// `a=1; b=2`
std::string_view cookie_in(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find(';'), header.size());
    const std::string_view pair = trimmed(header.substr(0, end));
    header.remove_prefix(std::min(end + 1, header.size()));
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('=')) return pair.substr(name.size() + 1);
  }
  return {};
}

}  // namespace

Access::Access(int port) : port_(port), token_(random_secret()), reading_token_(random_secret()) {}

bool Access::is_own_host(std::string_view host) const {
  return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

bool Access::is_own_origin(std::string_view origin, std::string_view host) const {
  return is_own_host(host) && origin == fmt::format("http://{}", host);
}

bool Access::may_read(std::string_view token) const { return same_secret(token, reading_token_); }

std::string Access::cookie_name() const { return fmt::format("pizarra-console-{}", port_); }

std::optional<std::string> Access::exchange(std::string_view token, Time now) {
  if (!same_secret(token, token_)) return std::nullopt;
  token_ = random_secret();
  forget_ended(now);
  if (sessions_.size() >= max_sessions) {
    sessions_.erase(std::ranges::min_element(sessions_, {}, [](const auto& session) { return session.second; }));
  }
  return sessions_.emplace(random_secret(), now + session_length).first->first;
}

std::optional<Time> Access::admitted(std::string_view cookies, Time now) {
  forget_ended(now);
  const std::string_view shown = cookie_in(cookies, cookie_name());
  for (const auto& [secret, until] : sessions_) {
    if (same_secret(shown, secret)) return until;
  }
  return std::nullopt;
}

void Access::forget_ended(Time now) {
  std::erase_if(sessions_, [now](const auto& session) { return session.second <= now; });
}

}  // namespace pizarra::console
