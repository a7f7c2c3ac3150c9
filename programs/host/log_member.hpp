#pragma once

// An etcd member of a cell's log on this host, as a process: how it begins, and its command line. Started again with
// the same folder it is the same member. One without data begins a new log together with all others that have none, or
// is brought back among those that have.
//
//   const MemberHere member{*address, "10.0.0.1", "/var/lib/pizarra/blocks"};
//   Result<void> sound = check_member(member);
//   Result<void> prepared = prepare_member(member);
//   Result<cluster::Beginning> begins = co_await beginning_of(executor, member, deadline, say);   // where it has no
//   data std::vector<std::string> command = etcd_command(member, *begins);
//
// Members speak to one another at the port above the one at which they are asked. With certificates both ways are
// encrypted, by server.crt and server.key, to whom ca.crt vouches for.

#include <functional>
#include <string>
#include <vector>

#include "blackboard/cluster/log_members.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::host {

struct MemberHere {
  cluster::LogAddress log;
  std::string here;    // which of the log's members it is
  std::string folder;  // of its data
};

// Failures bad-address, and no-program where etcd is not installed.
Result<void> check_member(const MemberHere& member);
// Of one that was checked: its certificates are here, and its folder, which is made. Failures bad-address and
// cannot-write.
Result<void> prepare_member(const MemberHere& member);
// Whether this host can listen at its two ports. Failures cannot-listen and bad-address.
Result<void> check_ports(const MemberHere& member);
bool has_data(const MemberHere& member);
// Says whenever it waits for others than before. Failures bad-address, cannot-listen, and unavailable: for whom it
// waited.
using SayWaiting = std::function<void(const Failure&)>;
Task<Result<cluster::Beginning>> beginning_of(Executor& executor, MemberHere member, Time deadline, SayWaiting say);
// Of a member that was checked.
std::vector<std::string> etcd_command(const MemberHere& member, cluster::Beginning begins);

}  // namespace pizarra::host
