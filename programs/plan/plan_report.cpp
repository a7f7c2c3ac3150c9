#include "programs/plan/plan_report.hpp"

#include <fmt/format.h>

#include "lisp/json.hpp"
#include "lisp/writer.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {

namespace {

std::size_t action_count(const planner::PlanSteps& steps) {
  std::size_t count = 0;
  for (const std::vector<Datum>& step : steps) count += step.size();
  return count;
}

std::string joined(const std::vector<Datum>& step, std::string_view between, std::string (*text)(const Datum&)) {
  std::string out;
  for (const Datum& operation : step) out += (out.empty() ? "" : std::string(between)) + text(operation);
  return out;
}

std::string text_of(const Datum& operation) { return write(operation); }
std::string json_text_of(const Datum& operation) { return json_string(write(operation)); }

// One action a line, in an order in which they can be done: those of one step do not interfere.
std::string pddl_text(const PlanReport& report) {
  std::string out;
  for (const std::vector<Datum>& step : report.steps) {
    for (const Datum& operation : step) out += write(operation) + '\n';
  }
  return out;
}

std::string readable_text(const PlanReport& report) {
  std::string out;
  const std::size_t width = std::to_string(report.steps.size()).size();
  for (std::size_t i = 0; i < report.steps.size(); ++i) {
    out += fmt::format("{:>{}}  {}\n", i + 1, width, joined(report.steps[i], " ", text_of));
  }
  if (report.steps.empty()) return fmt::format("nothing to do: the goal holds already ({:.3f} s)\n", report.seconds);
  const std::string cost =
      report.counts_cost ? fmt::format(", cost {} (made short, not cheap)", report.cost) : std::string();
  return out + fmt::format("{}{}, {}{}; {}, {:.3f} s{}\n", counted(report.steps.size(), "step"),
                           report.fewest_steps ? " (as few as can be)" : "",
                           counted(action_count(report.steps), "action"), cost, report.engine, report.seconds,
                           report.out_of_memory ? "; with more memory it might be shorter" : "");
}

std::string json_text(const PlanReport& report) {
  std::string steps;
  for (const std::vector<Datum>& step : report.steps) {
    steps += fmt::format("{}[{}]", steps.empty() ? "" : ",", joined(step, ",", json_text_of));
  }
  const std::string cost = report.counts_cost ? fmt::format(",\"cost\":{}", report.cost) : std::string();
  const std::string ended = report.out_of_memory ? ",\"out_of_memory\":true" : "";
  return fmt::format(
      "{{\"plan\":[{}],\"steps\":{},\"fewest_steps\":{},\"actions\":{}{},\"engine\":{},\"seconds\":{:.6f}{}}}\n", steps,
      report.steps.size(), report.fewest_steps, action_count(report.steps), cost, json_string(report.engine),
      report.seconds, ended);
}

}  // namespace

std::string plan_text(const PlanReport& report, PlanFormat format) {
  if (format == PlanFormat::pddl) return pddl_text(report);
  if (format == PlanFormat::json) return json_text(report);
  return readable_text(report);
}

}  // namespace pizarra::programs
