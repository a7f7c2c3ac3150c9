#pragma once

// The store under a cluster log: keys in order, and transactions that happen as a whole or not at all. Etcd is one
// (etcd_client.hpp); the tests have a model of one.
//
//   Result<Reply> reply = store.transact({.compares = {{epoch, "7"}}, .puts = {{head, "42"}}}, 200ms);
//   if (!reply) ...                      // unavailable: whether it happened is not known
//   if (!reply->succeeded) ...           // reply->found: what the compared keys are
//
// Calls wait for the answer, from any thread, one at a time for an object.

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

  virtual ~KeyValues() = default;
  // Failure unavailable.
  virtual Result<Reply> transact(const Transaction& transaction, Duration patience) = 0;
  // In their order, `most` at most; as of now, whoever leads. Failure unavailable.
  virtual Result<std::vector<KeyValue>> range(const Range& range, std::size_t most, Duration patience) = 0;
};

inline constexpr Duration patience = 1s;

// The value of one key, or nothing.
inline Result<std::optional<std::string>> get(KeyValues& store, const std::string& key, Duration wait = patience) {
  Result<std::vector<KeyValue>> found = store.range({key, key + '\0'}, 1, wait);
  if (!found) return fail(found);
  if (found->empty()) return std::optional<std::string>();
  return std::optional(std::move(found->front().value));
}

}  // namespace pizarra::cluster
