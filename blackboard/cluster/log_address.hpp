#pragma once

// Where a cell's log is kept: `etcd://A,B,C/CELL`, each member HOST:PORT or HOST (port 2379), an address of IPv6 in
// brackets. Members that other machines reach are spoken to with TLS and a client's certificate, from a folder with
// ca.crt, client.crt, client.key.
//
//   Result<LogAddress> address = LogAddress::from("etcd://10.0.0.1,10.0.0.2,10.0.0.3/blocks", "keys/etcd", false);

#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::cluster {

struct LogAddress {
  std::string text;
  std::vector<std::string> members;  // HOST:PORT
  std::string cell;
  std::string certificates;  // the folder; empty: unencrypted

  static bool is_one(const std::string& text) { return text.starts_with("etcd://"); }
  // Failures bad-address, not-loopback.
  static Result<LogAddress> from(const std::string& text, const std::string& certificates, bool insecure);
};

struct HostPort {
  std::string host;  // without brackets
  int port = 0;
};
// Of one of LogAddress::members, which all have a port.
HostPort host_and_port(const std::string& member);

}  // namespace pizarra::cluster
