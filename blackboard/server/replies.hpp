#pragma once

// The replies to a session's requests: how one is written (wire.hpp), and those that are kept for requests that come
// again: the newest `most`, as far as they take `most_bytes` together.
//
//   const std::string text = reply_text(number, result_to_datum(result));
//   KeptReplies done;
//   done.add(number, {text});
//   done.find(number);            // null where it was not answered, or where that is forgotten:
//   done.forgotten();             // up to this number

#include <map>
#include <string>

#include "blackboard/server/held_replies.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

// A failure's long sentence or subject is shortened.
Datum result_to_datum(const Result<Datum>& result);
std::string reply_text(wire::RequestId id, const Datum& result);

class KeptReplies {
 public:
  static constexpr std::size_t most = 256;
  static constexpr std::size_t most_bytes = 4 << 20;

  void add(wire::RequestId number, HeldReplies::Reply reply);
  const HeldReplies::Reply* find(wire::RequestId number) const;
  wire::RequestId forgotten() const { return forgotten_; }

 private:
  std::map<wire::RequestId, HeldReplies::Reply> replies_;
  std::size_t bytes_ = 0;
  wire::RequestId forgotten_ = 0;
};

}  // namespace pizarra::server
