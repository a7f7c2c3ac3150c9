#include "agents/launcher/command_line/moment.hpp"

#include <charconv>
#include <cmath>
#include <ctime>
#include <optional>

namespace pizarra {

namespace {

std::optional<Duration> unit_named(std::string_view name) {
  if (name == "s") return std::chrono::seconds(1);
  if (name == "min") return std::chrono::minutes(1);
  if (name == "h") return std::chrono::hours(1);
  if (name == "d") return std::chrono::hours(24);
  return std::nullopt;
}

std::optional<Time> local_time(const std::string& text) {
  std::tm broken{};
  const char* const rest = strptime(text.c_str(), "%Y-%m-%dT%H:%M:%S", &broken);
  if (rest == nullptr || *rest != '\0') return std::nullopt;
  broken.tm_isdst = -1;
  const std::time_t seconds = std::mktime(&broken);
  if (seconds < 0) return std::nullopt;
  // To the end of that second.
  return Time(std::chrono::seconds(seconds + 1) - Duration(1));
}

}  // namespace

Result<Moment> moment_from_text(const std::string& text, Time end) {
  constexpr double most_seconds = 4e9;
  Moment moment;
  const char* const last = text.data() + text.size();
  if (text.starts_with("@")) {
    double seconds = 0;
    const auto read = std::from_chars(text.data() + 1, last, seconds);
    if (read.ec == std::errc() && read.ptr == last && seconds >= 0 && seconds < most_seconds) {
      moment.time = Time(Duration(std::llround(seconds * 1e6)));
      return moment;
    }
  }
  std::uint64_t count = 0;
  const auto read = std::from_chars(text.data(), last, count);
  if (read.ec == std::errc() && read.ptr == last) {
    moment.revision = count;
    return moment;
  }
  const std::optional<Duration> unit = unit_named(std::string_view(read.ptr, last));
  if (read.ec == std::errc() && unit && static_cast<double>(count) < most_seconds) {
    moment.time = end - *unit * count;
    return moment;
  }
  if (const std::optional<Time> time = local_time(text)) {
    moment.time = *time;
    return moment;
  }
  return fail("bad-moment",
              "a moment is a revision, as 120, a time before the end, as 90s, 5min, 2h or 1d, a local time, "
              "as 2026-11-21T12:30:00, or seconds of the journal's clock, as @12.5",
              to_datum(text));
}

}  // namespace pizarra
