#include "blackboard/server/lease_quota.hpp"

#include "blackboard/store/store.hpp"

namespace pizarra::server {

Result<void> LeaseQuota::check(const std::string& teller) {
  const auto found = leases_.find(teller);
  if (found == leases_.end() || found->second.size() < most) return {};
  forget_lapsed(found->second);
  if (found->second.size() < most) return {};
  return fail("too-large",
              "the clients called " + teller + " have " + std::to_string(most) + " leases, the most there are",
              to_datum(teller));
}

void LeaseQuota::forget_lapsed(std::set<LeaseId>& leases) const {
  std::erase_if(leases, [this](LeaseId lease) { return !board_.store().stands(lease); });
}

void LeaseQuota::sweep() {
  for (auto& [teller, leases] : leases_) forget_lapsed(leases);
  std::erase_if(leases_, [](const auto& entry) { return entry.second.empty(); });
}

}  // namespace pizarra::server
