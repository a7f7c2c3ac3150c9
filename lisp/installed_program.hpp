#pragma once

// Where another program is installed on this machine: in a folder of PATH, or where servers are, which the PATH of a
// service may lack.
//
//   if (const std::optional<std::string> etcd = installed_program("etcd")) start(*etcd);

#include <optional>
#include <string>
#include <string_view>

namespace pizarra {

std::optional<std::string> installed_program(std::string_view name);

}  // namespace pizarra
