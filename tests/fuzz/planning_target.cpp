// A domain and a problem, a line `====` between them, are refused with a place, or become a task which, written as
// PDDL, is read again.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "agents/planner/files/pddl_text.hpp"
#include "agents/planner/files/task_files.hpp"
#include "agents/planner/task/numbered_task.hpp"

using namespace pizarra;

namespace {

Result<planner::PlanningTask> read(std::string_view domain, std::string_view problem) {
  const Result<Source> first = forms::read_planning_source(domain, "domain");
  if (!first) return fail(first);
  const Result<Source> second = forms::read_planning_source(problem, "problem");
  if (!second) return fail(second);
  return planner::read_task(*first, *second);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  constexpr std::string_view between = "\n====\n";
  const std::size_t at = text.find(between);
  const std::string_view problem = at == text.npos ? std::string_view() : text.substr(at + between.size());
  const Result<planner::PlanningTask> task = read(text.substr(0, at), problem);
  if (!task) {
    if (task.error().place.empty() || task.error().symbol == "scheme-error") std::abort();
    return 0;
  }
  if (!planner::number_task(*task)) return 0;  // it names objects that there are not
  const planner::PddlText written = planner::pddl_text(*task);
  if (!read(written.domain, written.problem)) std::abort();
  return 0;
}
