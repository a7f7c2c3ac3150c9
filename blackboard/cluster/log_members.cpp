#include "blackboard/cluster/log_members.hpp"

#include <algorithm>

#include "blackboard/cluster/etcd_json.hpp"

namespace pizarra::cluster {

Result<std::optional<Beginning>> begin_member(LogMembers& others, const std::string& peer_url) {
  const Result<std::vector<LogMember>> members = others.members();
  if (!members) return std::optional<Beginning>();
  const auto own = std::ranges::find(*members, peer_url, &LogMember::peer_url);
  if (own != members->end()) {
    if (own->was_added) return Beginning::joining;
    if (!own->has_run) return Beginning::anew;
    const Result<void> removed = others.remove(*own);
    if (!removed) return fail(removed);
  }
  const Result<void> added = others.add(peer_url);
  if (!added) return fail(added);
  return Beginning::joining;
}

Result<std::unique_ptr<EtcdMembers>> EtcdMembers::open(const LogAddress& others, const LogAddress& between) {
  Result<std::unique_ptr<EtcdClient>> asked = EtcdClient::open(others);
  if (!asked) return fail(asked);
  Result<std::unique_ptr<EtcdClient>> known = EtcdClient::open(between);
  if (!known) return fail(known);
  return std::unique_ptr<EtcdMembers>(new EtcdMembers(std::move(*asked), std::move(*known), others.members.size()));
}

// One after another, until one answers.
Result<std::vector<LogMember>> EtcdMembers::members() {
  Result<std::string> answer = fail("unavailable", "the log has one member, and no other can be asked");
  for (std::size_t asked = 0; asked < count_ && !answer; ++asked) answer = between_->read(asked, "/members", patience);
  if (!answer) return fail(answer);
  return etcd_json::members_from(*answer);
}

Result<void> EtcdMembers::remove(const LogMember& member) {
  return others_->order("/v3/cluster/member/remove", etcd_json::removal(member.id), 5 * patience);
}

Result<void> EtcdMembers::add(const std::string& peer_url) {
  return others_->order("/v3/cluster/member/add", etcd_json::addition(peer_url), 5 * patience);
}

}  // namespace pizarra::cluster
