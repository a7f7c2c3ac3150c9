#pragma once

// Where members of a log that have no data find each other. One whose disk is new cannot tell by itself whether its
// cluster is new, too. Only where all say at the same time that they have nothing, nothing can be lost.
//
//   Result<std::unique_ptr<web::HttpServer>> says = say_no_data(executor, "10.0.0.1:2380", log);   // while it is
//   const Result<bool> empty = says_no_data(*between, 1, log);                                           // another one
//
// The addresses are those at which the members speak to each other: no etcd runs there before it begins. With
// certificates it is said by TLS with that of the server, as etcd would, and believed of nobody else.

#include <memory>
#include <string>

#include "blackboard/cluster/etcd_client.hpp"
#include "drivers/web/http_server.hpp"

namespace pizarra::host {

// `own`: HOST:PORT. Failures cannot-listen, and bad-address where a file of the certificates cannot be read.
Result<std::unique_ptr<web::HttpServer>> say_no_data(Executor& executor, const std::string& own,
                                                     const cluster::LogAddress& log);
// Waits for the answer. `between` has the addresses between the members. Failure unavailable.
Result<bool> says_no_data(cluster::EtcdClient& between, std::size_t member, const cluster::LogAddress& log);

}  // namespace pizarra::host
