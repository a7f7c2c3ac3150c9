#pragma once

// The traffic of a journal as `demo --journal FILE` writes it, from its text.
//
//   Result<Traffic> traffic = traffic_of_journal(text);
//   ExchangeCounter exchanges(traffic);                     // for others that see requests and replies
//
// A journal says who told what, who was asked and answered, and when. Who watches it does not say.

#include <string_view>

#include "blackboard/fact.hpp"
#include "lisp/result.hpp"
#include "programs/method/system.hpp"

namespace pizarra::method {

// Sees requests and replies, in any order of facts, and makes exchanges of them.
class ExchangeCounter {
 public:
  explicit ExchangeCounter(Traffic& traffic) : traffic_(traffic) {}
  void see(const Fact& fact);
  // What is still open then.
  void end(Time now);

 private:
  struct Open {
    ExchangeKey key;
    Time when;
  };
  Traffic& traffic_;
  std::map<Datum, Open> open_;
};

// A stream of images that an agent announces.
void see_stream(Traffic& traffic, const Fact& fact);
// Agents and contracts: adds what this fact says of one; false for any other fact.
bool see_agent(Traffic& traffic, const Datum& fact);
// The name under which a key's client is an agent: NAME of KEY/NAME.
std::string agent_of_teller(const std::string& teller);

// Failure bad-journal.
Result<Traffic> traffic_of_journal(std::string_view text);

}  // namespace pizarra::method
