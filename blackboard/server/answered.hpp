#pragma once

// A session's replies, kept for requests that come again: the newest 256, as far as they take 4 MB together.
//
//   Answered done;
//   done.add(number, {text});
//   done.find(number);            // null where it was not answered, or where that is forgotten:
//   done.forgotten();             // up to this number

#include <map>

#include "blackboard/server/durability.hpp"

namespace pizarra::server {

class Answered {
 public:
  static constexpr std::size_t most = 256;
  static constexpr std::size_t most_bytes = 4 << 20;

  void add(wire::RequestId number, Durability::Reply reply);
  const Durability::Reply* find(wire::RequestId number) const;
  wire::RequestId forgotten() const { return forgotten_; }

 private:
  std::map<wire::RequestId, Durability::Reply> replies_;
  std::size_t bytes_ = 0;
  wire::RequestId forgotten_ = 0;
};

}  // namespace pizarra::server
