#pragma once

// A board whose journal is a log in a cluster: it stands by, leads when nobody does, and stands by again when another
// has taken the lead.
//
//   return serve_in_cluster({.log = *address, .name = "board-pc", .server = options});

#include <string>

#include "blackboard/cluster/log_address.hpp"
#include "blackboard/cluster/own_past.hpp"
#include "blackboard/server/board_server.hpp"

namespace pizarra::programs {

struct ClusterChoices {
  cluster::LogAddress log;
  std::string name;  // by which the epoch says who leads
  std::string cell;  // whose board it is; empty: of whichever cell the log is
  server::BoardServerOptions server;
  cluster::PastChoices past;  // of what is not durable
};

// The program's exit status.
int serve_in_cluster(const ClusterChoices& choices);

}  // namespace pizarra::programs
