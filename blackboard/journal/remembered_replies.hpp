#pragma once

// The replies that clients received, as a journal's groups hold them: sent again, a request is not done again, in no
// later life of the board either.
//
//   ReplyLines lines;
//   lines.add(text, {session, "vision", 7, result});         // goes on with the line that the session's last began
//   std::optional<std::vector<RememberedReply>> replies = replies_from(text);      // nothing where it is damaged
//
// A line is of one session: (SESSION TELLER KEY REQUEST RESULT REQUEST RESULT ...). Former files have a line a reply,
// (SESSION TELLER REQUEST RESULT), which may have its KEY after it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/datum.hpp"

namespace pizarra::journal {

// Longer than any client waits for them.
constexpr Duration replies_kept = 20s;

struct RememberedReply {
  std::uint64_t session = 0;
  std::string teller;
  std::uint64_t request = 0;
  Datum result;
  std::string key = {};  // the public key whose session it is, if any
};

class ReplyLines {
 public:
  // To the end of the text that all before went to.
  void add(std::string& text, const RememberedReply& reply);

 private:
  std::optional<std::uint64_t> session_;  // whose line is the last
  std::size_t line_begins_ = 0;
};

// In the order in which they were given.
std::optional<std::vector<RememberedReply>> replies_from(std::string_view text);

}  // namespace pizarra::journal
