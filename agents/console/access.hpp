#pragma once

// Access to the console. A random token, printed where the console was started, is exchanged once for a cookie; another
// token takes its place, for another browser. A request that a foreign page makes a browser send is refused by its Host
// and Origin, whatever cookie comes with it.
//
//   Access access(port);
//   const std::optional<std::string> cookie = access.exchange(token, now);       // nothing: a wrong token
//   const std::optional<Time> until = access.admitted(cookie_header, now);       // nothing: no session of ours

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "blackboard/time/clock.hpp"

namespace pizarra::console {

class Access {
 public:
  static constexpr Duration session_length = std::chrono::hours(12);
  // The one that ends first goes for a newcomer.
  static constexpr std::size_t max_sessions = 16;

  explicit Access(int port);

  // Loopback under this port, and nothing else: a name that somebody had resolve to loopback is none of ours.
  bool is_own_host(std::string_view host) const;
  // The page that `host` served.
  bool is_own_origin(std::string_view origin, std::string_view host) const;

  const std::string& token() const { return token_; }
  // The cookie's value.
  std::optional<std::string> exchange(std::string_view token, Time now);
  // Until when the session lasts to which a Cookie header belongs.
  std::optional<Time> admitted(std::string_view cookies, Time now);
  // A viewer that only reads shows another token, again and again, for as long as the console lasts.
  const std::string& reading_token() const { return reading_token_; }
  bool may_read(std::string_view token) const;
  // A browser sends a cookie to every port of its host.
  std::string cookie_name() const;

 private:
  void forget_ended(Time now);

  int port_;
  std::string token_;
  const std::string reading_token_;
  std::map<std::string, Time> sessions_;
};

}  // namespace pizarra::console
