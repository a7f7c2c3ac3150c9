#pragma once

// The service of systemd that runs `up` for a host of a cell: a file of the user's.
//
//   const HostService service = host_service(up, cell.name, secret, folder);
//   const Result<void> possible = check_place(service);      // nothing else is there
//   const Result<void> written = write(service);

#include <string>

#include "lisp/result.hpp"
#include "programs/host/up_choices.hpp"

namespace pizarra::host {

struct HostService {
  std::string file;
  std::string text;
};

std::string full_path(const std::string& file);

// `secret`: the file of the host's key. Without a folder, where systemd looks for a user's services.
HostService host_service(const UpChoices& up, const std::string& cell_name, const std::string& secret,
                         const std::string& folder);
// Failure exists, where the file is there with another text.
Result<void> check_place(const HostService& service);
// Failure cannot-write.
Result<void> write(const HostService& service);

}  // namespace pizarra::host
