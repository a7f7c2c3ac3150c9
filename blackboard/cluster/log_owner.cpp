#include "blackboard/cluster/log_owner.hpp"

#include <fmt/format.h>

#include "blackboard/cluster/log_upkeep.hpp"

namespace pizarra::cluster {

Result<void> claim_log(KeyValues& key_values, const LogKeys& keys, const std::string& cell) {
  // A store that is full takes no transaction that may put something.
  Result<std::optional<std::string>> owner = get(key_values, keys.cell());
  if (!owner) return fail(owner);
  if (!*owner) {
    const Result<KeyValues::Reply> claimed =
        key_values.transact({.compares = {{keys.cell(), std::nullopt}}, .puts = {{keys.cell(), cell}}}, patience);
    if (!claimed) {
      const Result<void> space = lacks_space(claimed.error()) ? make_space(key_values) : Result<void>();
      return fail(space ? claimed.error() : space.error());
    }
    if (claimed->succeeded) return {};
    owner = get(key_values, keys.cell());
    if (!owner) return fail(owner);
  }
  const std::string& found = owner->value_or("");
  if (found == cell) return {};
  return fail("other-cell",
              fmt::format("this log has the facts of the cell {}, and this is a board of the cell {}: give each cell a "
                          "name of its own behind the last slash of --log",
                          found, cell));
}

}  // namespace pizarra::cluster
