#pragma once

// How much each client of a served board asks of it, and what is too much. A client may ask as fast as it can while
// nobody else asks; while others do, it is served `most` requests in each `window` and refused the rest of it, so that
// its flood is no more than a share of what they wait for.
//
//   ClientRequests requests;
//   Result<void> served = requests.ask("alice", now);        // too-many
//   for (const auto& [client, asked] : requests.clients(now)) ...
//
// Clients of one name are one. Those that asked nothing for a minute are forgotten when there are many.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "blackboard/time/clock.hpp"
#include "blackboard/time/rate.hpp"
#include "lisp/result.hpp"

namespace pizarra::memory {

class ClientRequests {
 public:
  struct Limit {
    std::uint64_t most = 8192;
    Duration window = 100ms;
  };
  struct Asked {
    std::uint64_t requests = 0;
    std::uint64_t refused = 0;  // of them
    Rate rate;
    Time window_begun{};
    std::uint64_t in_window = 0;
    Time newest{};
  };
  static constexpr std::size_t most_clients = 2048;

  void set_limit(const Limit& limit) { limit_ = limit; }
  Result<void> ask(const std::string& client, Time now);
  const std::map<std::string, Asked>& clients(Time now);
  std::size_t size() const { return clients_.size(); }

 private:
  using Entry = std::pair<const std::string, Asked>;
  Entry& entry_of(const std::string& client, Time now);
  bool in_company(Entry& asking, Time now);

  Limit limit_;
  std::map<std::string, Asked> clients_;
  Entry* newest_ = nullptr;          // who asked last
  std::optional<Time> other_asked_;  // when somebody other than that one did
};

}  // namespace pizarra::memory
