#include "agents/console/page_arms.hpp"

#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/runtime/declared.hpp"
#include "drivers/arm/kinematics.hpp"

namespace pizarra::console {

namespace {

std::string point_text(const Eigen::Vector3d& point) {
  return fmt::format("[{:.2f},{:.2f},{:.2f}]", point.x(), point.y(), point.z());
}

std::string direction_text(const Eigen::Vector3d& direction) {
  return fmt::format("[{:.5f},{:.5f},{:.5f}]", direction.x(), direction.y(), direction.z());
}

std::string arm_text(const std::string& name, const arm::ArmModel& model, const arm::Joints& joints) {
  std::string points;
  for (const Eigen::Vector3d& point : arm::skeleton(model, joints)) {
    points += (points.empty() ? "" : ",") + point_text(point);
  }
  const arm::ToolPose tool = arm::forward(model, joints);
  return fmt::format("{{\"arm\":{},\"points\":[{}],\"grip\":{},\"approach\":{},\"closing\":{}}}", json_string(name),
                     points, point_text(tool.translation()), direction_text(tool.linear().col(2)),
                     direction_text(tool.linear().col(1)));
}

// Of that arm, if the fact is of an arm that is known here.
std::optional<arm::Joints> joints_in(const Datum& readings, const arm::ArmModel& model) {
  if (readings.size() != model.axes.size()) return std::nullopt;
  arm::Joints joints(readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!readings[i].is_number()) return std::nullopt;
    joints[i] = readings[i].number();
  }
  return joints;
}

}  // namespace

PageArms::PageArms(PageBoard& board, PageVoice& voice, const CellView& cell)
    : voice_(voice), cell_(cell), following_(board.executor().spawn(follow(board.facts()))) {}

Task<void> PageArms::follow(Board& board) {
  const Datum pattern = list("arm-joints"_sym, "?robot"_sym, "?joints"_sym);
  const Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(board, query_for(pattern));
  if (!watch) co_return;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    co_await voice_.room();
    say(change->added, {});
  }
}

void PageArms::say(const std::vector<Answer>& answers, const std::string& past) {
  for (const Answer& answer : answers) {
    const Datum& fact = answer.facts.front().datum;
    if (!fact.is_form("arm-joints")) continue;
    const auto known = cell_.arms.find(std::string(fact[1].text()));
    if (known == cell_.arms.end()) continue;
    const std::optional<arm::Joints> joints = joints_in(fact[2], known->second);
    if (joints) voice_.say_fact(of_the_past(arm_text(known->first, known->second, *joints), past));
  }
}

}  // namespace pizarra::console
