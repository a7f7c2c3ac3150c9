#pragma once

// The member of the etcd cluster that runs on this host. It is asked first: a request to it needs no link, and no other
// host whose loss would have to be waited for.
//
//   own_member({"10.0.0.1:2379", "10.0.0.2:2379"});       // 1 on the host with the address 10.0.0.2

#include <cstddef>
#include <string>
#include <vector>

namespace pizarra::cluster {

// Its place among the members, each HOST:PORT; 0 where none of them is on this host.
std::size_t own_member(const std::vector<std::string>& members);

}  // namespace pizarra::cluster
