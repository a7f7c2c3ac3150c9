#include "programs/method/connect.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pizarra::method {

namespace {

std::string rate_text(const Connection& connection, double seconds) {
  if (seconds <= 0) return "not measured";
  return fmt::format("{:.1f}/s of {:.0f} bytes", static_cast<double>(connection.count) / seconds, connection.bytes);
}

std::string about_text(const Connection& connection) {
  constexpr std::size_t shown = 3;
  std::vector<std::string> names(connection.about.begin(), connection.about.end());
  const std::size_t more = names.size() > shown ? names.size() - shown : 0;
  if (more > 0) names.resize(shown);
  return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace

std::string recommend(const Nature& nature) {
  const bool heavy = nature.bytes >= heavy_bytes, heavy_back = nature.bytes_back >= heavy_bytes;
  if (heavy && !heavy_back && nature.addressees > 1) return "PUSH + SEND";
  if (!heavy && heavy_back) return "SEND + PUSH";
  if (nature.addressees > 1) return nature.waits ? "not available" : "PUSH";
  return nature.waits ? "QUERY" : "SEND";
}

void advise(Connection& connection, double seconds) {
  const bool streams = connection.pattern == "STREAM", takes = connection.pattern == "EVENT";
  const bool pushes = connection.pattern == "PUSH" || streams;
  const bool waits = connection.pattern == "QUERY";
  // The facts that a publisher tells are the server's side of the balance. The client asked once, which weighs little.
  const Nature nature{.addressees = connection.addressees,
                      .waits = waits,
                      .bytes = pushes ? 0 : connection.bytes,
                      .bytes_back = streams  ? std::max(connection.bytes, heavy_bytes)
                                    : pushes ? connection.bytes
                                             : connection.bytes_back};
  connection.recommended = recommend(nature);
  if (streams) return;
  // For many the tables have both.
  if (takes && connection.recommended == "PUSH") connection.recommended = "EVENT";
  const std::string seen = rate_text(connection, seconds);
  if (pushes && connection.recommended == "SEND + PUSH") {
    connection.remark = fmt::format(
        "{} tells {} heavy facts ({}; {}): light against heavy, so a SEND should start and stop this PUSH, or a stream "
        "beside the board take it",
        connection.from, connection.to, about_text(connection), seen);
  } else if (pushes && connection.recommended == "SEND") {
    connection.remark = fmt::format(
        "{} alone reads what {} tells of {} ({}): one to one and not blocking is SEND in Table 4.5; PUSH "
        "lets others watch later without {} knowing",
        connection.to, connection.from, about_text(connection), seen, connection.from);
  } else if (takes && connection.recommended == "SEND") {
    connection.remark = fmt::format(
        "{} alone takes what {} tells of {} ({}): one to one and not blocking is SEND in Table 4.5; EVENT waits for "
        "{} also while it is away, and another may share the work",
        connection.to, connection.from, about_text(connection), seen, connection.to);
  } else if (waits && connection.recommended == "SEND + PUSH") {
    connection.remark = fmt::format(
        "{} asks {} for {} and is answered with {:.0f} bytes on the mean: let a SEND start "
        "a PUSH that answers",
        connection.from, connection.to, about_text(connection), connection.bytes_back);
  } else if (waits && connection.p99_ms > long_wait_ms) {
    connection.recommended = "SEND + EVENT";
    connection.remark = fmt::format(
        "{} waits {:.1f} s for {} ({}; half of all {:.0f} ms): longer than 2 s is better not blocking, a SEND that "
        "an EVENT answers; here a request ends also when its server dies, so that nobody blocks for ever",
        connection.from, connection.p99_ms / 1000, connection.to, about_text(connection), connection.p50_ms);
  }
}

}  // namespace pizarra::method
