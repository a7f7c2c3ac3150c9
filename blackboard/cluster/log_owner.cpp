#include "blackboard/cluster/log_owner.hpp"

#include <fmt/format.h>

#include "blackboard/cluster/log_upkeep.hpp"

namespace pizarra::cluster {

namespace {

std::string text_of(const LogOwner& owner) { return owner.key.empty() ? owner.cell : owner.cell + " " + owner.key; }

// Of nobody, or of this cell from when its boards had no key.
bool may_be_claimed(const std::optional<std::string>& standing, const LogOwner& owner) {
  return !standing || (*standing == owner.cell && !owner.key.empty());
}

std::unexpected<Failure> of_another(const std::string& standing, const LogOwner& owner) {
  const std::string cell = standing.substr(0, standing.find(' '));
  const std::string why =
      cell == owner.cell
          ? fmt::format("this log has the facts of a cell {} whose boards have another key than this one", cell)
          : fmt::format("this log has the facts of the cell {}, and this is a board of the cell {}", cell, owner.cell);
  return fail("other-cell", why + ": give each cell a name of its own behind the last slash of --log");
}

}  // namespace

Result<void> claim_log(KeyValues& key_values, const LogKeys& keys, const LogOwner& owner) {
  // A store that is full takes no transaction that may put something.
  Result<std::optional<std::string>> standing = get(key_values, keys.cell());
  if (!standing) return fail(standing);
  if (may_be_claimed(*standing, owner)) {
    const Result<KeyValues::Reply> claimed = key_values.transact(
        {.compares = {{keys.cell(), *standing}}, .puts = {{keys.cell(), text_of(owner)}}}, patience);
    if (!claimed) {
      const Result<void> space = lacks_space(claimed.error()) ? make_space(key_values) : Result<void>();
      return fail(space ? claimed.error() : space.error());
    }
    if (claimed->succeeded) return {};
    standing = get(key_values, keys.cell());
    if (!standing) return fail(standing);
  }
  const std::string found = standing->value_or("");
  return found == text_of(owner) ? Result<void>() : of_another(found, owner);
}

}  // namespace pizarra::cluster
