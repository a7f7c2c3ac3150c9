#include "agents/console/access.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/wire/tokens.hpp"
#include "lisp/plain_text.hpp"

namespace pizarra::console {

namespace {

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

Access::Access(Door door)
    : door_(std::move(door)), token_(wire::random_secret()), reading_token_(wire::random_secret()) {}

// A browser leaves out the port that its scheme has.
bool Access::is_own_host(std::string_view host) const {
  constexpr int https_port = 443;
  return std::ranges::any_of(door_.hosts, [&](const std::string& own) {
    return host == fmt::format("{}:{}", own, door_.port) || (door_.secure && door_.port == https_port && host == own);
  });
}

bool Access::is_own_origin(std::string_view origin, std::string_view host) const {
  return is_own_host(host) && origin == fmt::format("{}://{}", door_.secure ? "https" : "http", host);
}

bool Access::may_read(std::string_view token) const { return wire::is_same_secret(token, reading_token_); }

std::string Access::cookie_name() const { return fmt::format("pizarra-console-{}", door_.port); }

// The key whose token it is, no key's name where it is that of the start; nothing: it is wrong.
std::optional<std::string> Access::key_of(std::string_view token) const {
  if (!door_.tokens.empty()) return wire::key_of_token(door_.tokens, token);
  return wire::is_same_secret(token, token_) ? std::optional<std::string>("") : std::nullopt;
}

std::optional<std::string> Access::exchange(std::string_view token, Time now) {
  const std::optional<std::string> key = key_of(token);
  if (!key) return std::nullopt;
  token_ = wire::random_secret();
  forget_ended(now);
  make_room(*key);
  const Session session{{now + session_length, *key, ++newest_}, std::string(door_.tokens.empty() ? "" : token)};
  return sessions_.emplace(wire::random_secret(), session).first->first;
}

void Access::make_room(const std::string& key) {
  const bool of_a_key = !key.empty();
  const auto own = [&](const auto& entry) { return entry.second.admitted.key == key; };
  const bool has_its_share =
      of_a_key && std::ranges::count_if(sessions_, own) >= static_cast<std::ptrdiff_t>(max_sessions_of_a_key);
  if (!has_its_share && sessions_.size() < max_sessions) return;
  auto first = sessions_.end();
  for (auto each = sessions_.begin(); each != sessions_.end(); ++each) {
    if (has_its_share && !own(*each)) continue;
    if (first == sessions_.end() || each->second.admitted.until < first->second.admitted.until) first = each;
  }
  sessions_.erase(first);
}

bool Access::has_its_token(const Session& session) const {
  return session.token.empty() || wire::key_of_token(door_.tokens, session.token).has_value();
}

bool Access::stands(std::uint64_t session, Time now) {
  forget_ended(now);
  return std::ranges::any_of(sessions_, [&](const auto& entry) {
    return entry.second.admitted.number == session && has_its_token(entry.second);
  });
}

std::optional<Access::Admitted> Access::admitted(std::string_view cookies, Time now) {
  forget_ended(now);
  const std::string_view shown = cookie_in(cookies, cookie_name());
  for (const auto& [secret, session] : sessions_) {
    if (!wire::is_same_secret(shown, secret)) continue;
    return has_its_token(session) ? std::optional(session.admitted) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> Access::forget(std::string_view cookies) {
  const auto session = sessions_.find(cookie_in(cookies, cookie_name()));
  if (session == sessions_.end()) return std::nullopt;
  const std::uint64_t number = session->second.admitted.number;
  sessions_.erase(session);
  return number;
}

void Access::forget_ended(Time now) {
  std::erase_if(sessions_, [now](const auto& session) { return session.second.admitted.until <= now; });
}

}  // namespace pizarra::console
