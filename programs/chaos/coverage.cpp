#include "programs/chaos/coverage.hpp"

#include <fmt/format.h>
#include <sstream>

#include "programs/chaos/fault.hpp"

namespace pizarra::chaos {

namespace {

constexpr const char* events[] = {
    "agent",          "asks-eyes-again", "cuts-motion-short", "difference",     "follows-object", "goal",
    "held-up",        "lays-down",       "makes-room",        "missing",        "operation",      "operation-fails",
    "plan",           "plan-kept",       "plans-anew",        "pushes",         "rescue-fails",   "result",
    "resumes-goal",   "servo",           "sets-aside",        "surveys-camera", "sweeps-border",  "waits-for-hand",
    "waits-for-robot"};
constexpr const char* board_points[] = {"board-lived-again",
                                        "reply-lost",
                                        "frames-lost",
                                        "agent-lived-again",
                                        "lease-lapsed",
                                        "goal-reached",
                                        "goal-refused",
                                        "several-goals",
                                        "refused-out-of-reach",
                                        "many-cubes",
                                        "tags",
                                        "bodies",
                                        "head"};
// Facts of the drawn cell's domain that did not hold, and operations that somebody else did.
constexpr const char* differences[] = {"on",     "on-table", "clear",    "bare",  "holding", "arm-empty", "leans",
                                       "raised", "PICK-UP",  "PUT-DOWN", "STACK", "UNSTACK", "LIFT",      "FREE"};
// Symbols that operations, rescues and hold-ups fail with.
constexpr const char* failures[] = {
    "absent",  "bad-reply",   "camera-doubtful", "camera-moved",   "disconnected",   "fault",          "gave-up",
    "halted",  "joint-limit", "lost-sight",      "missed",         "missing-object", "no-convergence", "no-effect",
    "no-plan", "no-room",     "not-commander",   "not-in-control", "not-present",    "singular",       "slipped",
    "stopped", "stuck",       "timeout",         "too-fast",       "unavailable",    "unreachable",    "unseen"};
constexpr const char* stops[] = {"STOPPED_AT_RESTART", "MOVED_BY_ITSELF"};
constexpr const char* operations[] = {"PICK-UP", "PUT-DOWN", "STACK", "UNSTACK"};
constexpr int servo_states = 5;

std::vector<std::string> all_points() {
  std::vector<std::string> points;
  for (const char* event : events) points.push_back(fmt::format("event {}", event));
  for (const char* point : board_points) points.push_back(fmt::format("cell {}", point));
  for (const char* stop : stops) points.push_back(fmt::format("arm {}", stop));
  for (const char* difference : differences) points.push_back(fmt::format("difference {}", difference));
  for (const char* failure : failures) points.push_back(fmt::format("failure {}", failure));
  for (const FaultClass& kind : fault_classes()) {
    for (const char* operation : operations) {
      for (int state = 0; state < servo_states; ++state) points.push_back(pair_point(kind.name, operation, state));
    }
  }
  return points;
}

}  // namespace

std::string pair_point(const std::string& fault_class, const std::string& operation, int servo_state) {
  return fmt::format("fault {} {} {}", fault_class, operation, servo_state);
}

const std::vector<std::string>& named_points() {
  static const std::vector<std::string> points = all_points();
  return points;
}

void Coverage::add(const Coverage& other) {
  for (const auto& [point, count] : other.counts_) counts_[point] += count;
}

std::vector<std::string> Coverage::unreached() const {
  std::vector<std::string> points;
  for (const std::string& point : named_points()) {
    if (!counts_.contains(point)) points.push_back(point);
  }
  return points;
}

std::vector<std::string> Coverage::lost_since(const Coverage& reference) const {
  constexpr std::uint64_t often = 5;
  std::vector<std::string> lost;
  for (const auto& [point, count] : reference.counts_) {
    if (count >= often && !counts_.contains(point)) lost.push_back(point);
  }
  return lost;
}

std::string Coverage::text() const {
  std::string text;
  for (const auto& [point, count] : counts_) text += fmt::format("{} {}\n", point, count);
  return text;
}

Coverage Coverage::from_text(const std::string& text) {
  Coverage coverage;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.rfind(' ');
    if (space == std::string::npos) continue;
    coverage.hit(line.substr(0, space), std::strtoull(line.c_str() + space + 1, nullptr, 10));
  }
  return coverage;
}

}  // namespace pizarra::chaos
