#include "blackboard/cluster/log_format.hpp"

#include <fmt/format.h>

namespace pizarra::cluster {

namespace {

constexpr const char* first_format = "1";

}  // namespace

KeyValue format_of_this_build(const LogKeys& keys) { return {keys.format(), std::to_string(log_format)}; }

Result<void> check_format(KeyValues& key_values, const LogKeys& keys) {
  const Result<std::optional<std::string>> standing = get(key_values, keys.format());
  if (!standing) return fail(standing);
  const std::string found = standing->value_or(first_format);
  if (found == std::to_string(log_format) || found == std::to_string(log_format - 1)) return {};
  return fail("other-format",
              fmt::format("the log in the cluster is of format {}, and this build reads formats {} and {}: bring this "
                          "host to the version that wrote the log",
                          found, log_format - 1, log_format),
              to_datum(found));
}

}  // namespace pizarra::cluster
