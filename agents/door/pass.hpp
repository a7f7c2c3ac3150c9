#pragma once

// The passes of devices at the door, and their permissions there: a device has a key as any other client has
// (keys.hpp). Its token is the key's secret. Its permissions are those of its NAME.key, which the door keeps to on
// every board, also on one that asks for no keys.
//
//   Result<Pass> pass = pass_of("keys", "barrier-1", token);
//   const Result<void> permitted = pass->may_tell(fact);          // failure not-permitted

#include <optional>
#include <string>
#include <string_view>

#include "blackboard/query.hpp"
#include "blackboard/wire/keys.hpp"

namespace pizarra::door {

struct Pass {
  std::string name;
  wire::Permissions may;
  std::optional<wire::ClientKeys> keys;  // to come to a board with; none where the folder has no key of a board

  Result<void> may_declare(const Datum& relation) const;
  Result<void> may_tell(const Datum& fact) const;  // and retract
  Result<void> may_read(const Query& query) const;
};

// Failures: not-permitted, which does not say whether name or token is wrong; those of the files of a key that is there
// (exposed-key, bad-key, unreadable-file).
Result<Pass> pass_of(const std::string& folder, const std::string& name, std::string_view token);

}  // namespace pizarra::door
