#pragma once

// A member of a log needs a folder, certificates and two free ports on this host. They are checked before etcd is
// started, since etcd reports what is missing by a stack trace.
//
//   const Result<void> folder = make_member_folder("/var/lib/pizarra-etcd");
//   const Result<void> certificates = check_member_certificates("certificates");
//   const Result<void> ports = check_member_port("10.0.0.1:2379");        // and the one above it

#include <string>

#include "lisp/result.hpp"

namespace pizarra::host {

// The user's alone, where it is made. Failure cannot-write.
Result<void> make_member_folder(const std::string& folder);
// Without a folder there is nothing to check. Failure bad-address.
Result<void> check_member_certificates(const std::string& folder);
// Of an address in figures. Failures cannot-listen, and bad-address where this machine does not have it.
Result<void> check_member_port(const std::string& place);

}  // namespace pizarra::host
