#include "programs/host/this_host.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <unistd.h>

#include "lisp/outside_text.hpp"

namespace pizarra::host {

Result<forms::CellHost> choose_host(const forms::CellDescription& cell, const std::string& asked) {
  char machine[256] = {};
  gethostname(machine, sizeof machine - 1);
  const std::vector<std::string> wanted =
      asked.empty() ? std::vector<std::string>{machine, "localhost"} : std::vector<std::string>{asked};
  for (const std::string& name : wanted) {
    const auto found = std::ranges::find(cell.hosts, name, &forms::CellHost::name);
    if (found != cell.hosts.end()) return *found;
  }
  if (asked.empty() && cell.hosts.size() == 1) return cell.hosts.front();
  std::string known;
  for (const forms::CellHost& host : cell.hosts) known += (known.empty() ? "" : ", ") + host.name;
  if (asked.empty()) return fail("unknown-host", fmt::format("name this host with --host: the cell has {}", known));
  return fail("unknown-host", fmt::format("the cell has no host {}: it has {}", text_of_bytes(asked), known));
}

}  // namespace pizarra::host
