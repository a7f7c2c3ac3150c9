#pragma once

// Access to the console. On loopback a random token, printed where the console was started, is exchanged once for a
// cookie; another token takes its place, for another browser. At any other address it is the token of a key, and the
// session is that key's, until it ends or the token is taken away. A request that a foreign page makes a browser send
// is refused by its Host and Origin, whatever cookie comes with it.
//
//   Access access({.port = port});
//   const std::optional<std::string> cookie = access.exchange(token, now);       // nothing: a wrong token
//   const auto session = access.admitted(cookie_header, now);                    // nothing: no session of ours

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/time/clock.hpp"

namespace pizarra::console {

class Access {
 public:
  static constexpr Duration session_length = std::chrono::hours(12);
  // The one that ends first goes for a newcomer: of a key that has its share, one of its own.
  static constexpr std::size_t max_sessions = 16;
  static constexpr std::size_t max_sessions_of_a_key = 8;

  // Where browsers come, and as what.
  struct Door {
    int port = 0;
    bool secure = false;
    std::vector<std::string> hosts{"127.0.0.1", "localhost"};
    std::string tokens = {};  // the folder of keys' tokens; none: the token of this start
  };
  struct Admitted {
    Time until;
    std::string key;           // whose the session is; empty: the console's own
    std::uint64_t number = 0;  // the session's, of all that there were
  };

  explicit Access(Door door);

  // One of our hosts under our port, and nothing else: a name that somebody had resolve to us is none of ours.
  bool is_own_host(std::string_view host) const;
  // The page that `host` served.
  bool is_own_origin(std::string_view origin, std::string_view host) const;

  const std::string& token() const { return token_; }
  // The cookie's value.
  std::optional<std::string> exchange(std::string_view token, Time now);
  // The session to which a Cookie header belongs.
  std::optional<Admitted> admitted(std::string_view cookies, Time now);
  // Whether that session goes on: its time is not over, nobody logged out, and the token that began it is still there.
  bool stands(std::uint64_t session, Time now);
  // It ends: answers which it was, if there is one.
  std::optional<std::uint64_t> forget(std::string_view cookies);
  // A viewer that only reads shows another token, again and again, for as long as the console lasts.
  const std::string& reading_token() const { return reading_token_; }
  bool may_read(std::string_view token) const;
  // A browser sends a cookie to every port of its host.
  std::string cookie_name() const;

 private:
  struct Session {
    Admitted admitted;
    std::string token;  // of a key
  };
  std::optional<std::string> key_of(std::string_view token) const;
  bool has_its_token(const Session& session) const;
  void make_room(const std::string& key);
  void forget_ended(Time now);

  const Door door_;
  std::string token_;
  const std::string reading_token_;
  std::map<std::string, Session, std::less<>> sessions_;
  std::uint64_t newest_ = 0;
};

}  // namespace pizarra::console
