#include "programs/command_line/moment.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace pizarra::programs {

namespace {

constexpr double most_seconds = 4e9;

std::optional<double> unit_named(std::string_view name) {
  if (name == "s") return 1;
  if (name == "min") return 60;
  if (name == "h") return 3600;
  if (name == "d") return 24 * 3600;
  return std::nullopt;
}

// A revision.
std::optional<Moment> counted(std::string_view text) {
  Moment moment;
  const char* const last = text.data() + text.size();
  const auto read = std::from_chars(text.data(), last, moment.revision);
  const bool fits = moment.revision <= std::numeric_limits<std::int64_t>::max();
  if (read.ec != std::errc() || read.ptr != last || !fits) return std::nullopt;
  return moment;
}

std::optional<Time> seconds_of_clock(std::string_view text) {
  if (!text.starts_with("@")) return std::nullopt;
  double seconds = 0;
  const char* const last = text.data() + text.size();
  const auto read = std::from_chars(text.data() + 1, last, seconds);
  const bool fits = seconds >= 0 && seconds < most_seconds;
  if (read.ec != std::errc() || read.ptr != last || !fits) return std::nullopt;
  return Time(Duration(std::llround(seconds * 1e6)));
}

// So long before the end, but not before time 0.
std::optional<Time> time_before(std::string_view text, Time end) {
  std::uint64_t count = 0;
  const char* const last = text.data() + text.size();
  const auto read = std::from_chars(text.data(), last, count);
  const std::optional<double> unit = unit_named(std::string_view(read.ptr, last));
  if (read.ec != std::errc() || !unit || static_cast<double>(count) * *unit >= most_seconds) return std::nullopt;
  const Duration before = std::chrono::seconds(count * static_cast<std::uint64_t>(*unit));
  return std::max(end - before, Time{});
}

// A local date and time.
std::optional<Time> local_time(const std::string& text) {
  std::tm said{};
  const char* const rest = strptime(text.c_str(), "%Y-%m-%dT%H:%M:%S", &said);
  if (rest == nullptr || *rest != '\0') return std::nullopt;
  said.tm_isdst = -1;
  std::tm meant = said;
  const std::time_t seconds = std::mktime(&meant);
  const auto parts = [](const std::tm& t) {
    return std::array{t.tm_year, t.tm_mon, t.tm_mday, t.tm_hour, t.tm_min, t.tm_sec};
  };
  // The parser takes a day or hour that does not exist for a later one.
  if (seconds < 0 || parts(said) != parts(meant)) return std::nullopt;
  return Time(std::chrono::seconds(seconds));
}

}  // namespace

std::string time_text(Time when) {
  constexpr Duration a_year = std::chrono::hours(24 * 365);
  const Duration since = when.time_since_epoch();
  if (since < a_year) return fmt::format("@{:.6f}", static_cast<double>(since.count()) / 1e6);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}",
                     fmt::localtime(std::chrono::duration_cast<std::chrono::seconds>(since).count()));
}

CLI::Validator moment_check() {
  return {[](const std::string& text) { return std::string(text.empty() ? "names no moment" : ""); }, "MOMENT"};
}

Result<Moment> moment_from_text(const std::string& text, Time end) {
  if (const std::optional<Moment> revision = counted(text)) return *revision;
  if (const std::optional<Time> before = time_before(text, end)) return Moment{.time = *before};
  std::optional<Time> time = seconds_of_clock(text);
  Duration lasting{};
  if (!time) {
    time = local_time(text);
    // To the end of that second.
    lasting = std::chrono::seconds(1) - Duration(1);
  }
  if (!time) {
    return fail(
        "bad-moment",
        "a moment is a revision, as 120, a time before the end, as 90s, 5min, 2h or 1d, a local time that there "
        "was, as 2026-11-21T12:30:00, or seconds of the journal's clock, as @12.5",
        is_string_text(text) ? to_datum(text) : Datum());
  }
  if (*time > end) return fail("not-yet", "this is later than the end, which is at " + time_text(end), to_datum(text));
  return Moment{.time = *time + lasting};
}

}  // namespace pizarra::programs
