#pragma once

// Which members an etcd cluster knows, and how one whose data is gone comes back: etcd takes it for another one, so it
// is removed and added.
//
//   auto others = EtcdMembers::open(log without the own member, the same with the addresses between members);
//   Result<std::optional<Beginning>> begins = begin_member(**others, "http://10.0.0.3:2380");   // its folder is empty
//
// A member that forgot what it had agreed to must not vote with the others as if it had not. So where none of them says
// what it knows, there is no answer: such a member waits.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/cluster/etcd_client.hpp"

namespace pizarra::cluster {

struct LogMember {
  std::uint64_t id = 0;
  std::string peer_url = {};  // at which the others speak to it
  bool was_added = false;     // to a cluster that ran, and did not run since
  bool has_run = false;
};

class LogMembers {
 public:
  virtual ~LogMembers() = default;
  // Failure unavailable, here and below.
  virtual Result<std::vector<LogMember>> members() = 0;
  virtual Result<void> remove(const LogMember& member) = 0;
  virtual Result<void> add(const std::string& peer_url) = 0;
};

// With whom a member starts that has no data: with all members of a new cluster, or into one that runs.
enum class Beginning { anew, joining };
// Nothing where no member answers. Failure unavailable where the others cannot agree without it.
Result<std::optional<Beginning>> begin_member(LogMembers& others, const std::string& peer_url);

// Members are known before they have a leader, at the addresses at which they speak to each other.
class EtcdMembers : public LogMembers {
 public:
  // Failure bad-address.
  static Result<std::unique_ptr<EtcdMembers>> open(const LogAddress& others, const LogAddress& between);
  Result<std::vector<LogMember>> members() override;
  Result<void> remove(const LogMember& member) override;
  Result<void> add(const std::string& peer_url) override;

 private:
  EtcdMembers(std::unique_ptr<EtcdClient> others, std::unique_ptr<EtcdClient> between, std::size_t count)
      : others_(std::move(others)), between_(std::move(between)), count_(count) {}
  const std::unique_ptr<EtcdClient> others_;
  const std::unique_ptr<EtcdClient> between_;
  const std::size_t count_;
};

}  // namespace pizarra::cluster
