#pragma once

// The store under a cluster log: keys in order, and transactions that happen as a whole or not at all. Etcd is one
// (etcd_client.hpp); the tests have a model of one.
//
//   Result<Reply> reply = store.transact({.compares = {{epoch, "7"}}, .puts = {{head, "42"}}}, 200ms);
//   if (!reply) ...                      // unavailable: whether it happened is not known
//   if (!reply->succeeded) ...           // reply->found: what the compared keys are
//
// Calls wait for the answer, from any thread, one at a time for an object.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra::cluster {

struct KeyValue {
  std::string key;
  std::string value;
  bool operator==(const KeyValue&) const = default;
};

class KeyValues {
 public:
  struct Compare {
    std::string key;
    std::optional<std::string> value;  // nothing: there must be no such key
  };
  struct Range {
    std::string from;
    std::string to;  // not itself in it
  };
  struct Transaction {
    std::vector<Compare> compares;
    std::vector<KeyValue> puts = {};
    std::vector<Range> deletes = {};
  };
  struct Reply {
    bool succeeded = false;
    std::vector<KeyValue> found = {};  // of the compared keys, where it did not
  };
  // In bytes. `taken` counts former values until they are forgotten, and holes until they are closed.
  struct Space {
    std::uint64_t most = 0;
    std::uint64_t taken = 0;
    bool refuses = false;     // it was full, and puts nothing until refusing is ended
    std::string member = {};  // whose space it is, where members have a space each
  };

  virtual ~KeyValues() = default;
  // Failure unavailable.
  virtual Result<Reply> transact(const Transaction& transaction, Duration patience) = 0;
  // In their order, `most` at most; as of now, whoever leads. Failure unavailable.
  virtual Result<std::vector<KeyValue>> range(const Range& range, std::size_t most, Duration patience) = 0;

  // For all who use the store. Where it refuses, the space is that of the fullest member. Failure unavailable.
  virtual Result<Space> space(Duration patience) = 0;
  virtual Result<void> forget_former(Duration patience) = 0;
  // Keeps everybody waiting meanwhile.
  virtual Result<void> close_holes(Duration patience) = 0;
  virtual Result<void> end_refusing(Duration patience) = 0;
};

inline constexpr Duration patience = 1s;

// The subject of a failure for lack of space. What was asked for may have happened even so.
constexpr const char* no_space = "no-space";
inline bool lacks_space(const Failure& failure) { return failure.subject.is_symbol(no_space); }
// Its certificate is of another address, or of an authority that is not known here.
constexpr const char* bad_certificate = "bad-certificate";
inline bool is_distrusted(const Failure& failure) { return failure.subject.is_symbol(bad_certificate); }

// The value of one key, or nothing.
inline Result<std::optional<std::string>> get(KeyValues& store, const std::string& key, Duration wait = patience) {
  Result<std::vector<KeyValue>> found = store.range({key, key + '\0'}, 1, wait);
  if (!found) return fail(found);
  if (found->empty()) return std::optional<std::string>();
  return std::optional(std::move(found->front().value));
}

}  // namespace pizarra::cluster
