#include "programs/chaos/verdict.hpp"

#include "programs/chaos/workspace.hpp"

namespace pizarra::chaos {

namespace {

constexpr Duration hand_was_there = 4s;

}  // namespace

Verdict::Verdict(Executor& time, const story::Judge& judge, simulation::WorldConfig config, const Observers& observers,
                 const FaultPlayer& player)
    : time_(time), judge_(judge), config_(std::move(config)), observers_(observers), player_(player) {}

Task<bool> Verdict::stands(std::vector<Datum> goal) const {
  const bool showed = observers_.showed_lately(goal);
  const bool disturbed = player_.hand_is_busy() || time_.now() - player_.hand_moved() < hand_was_there;
  co_await sleep(time_, story::settling_time);
  const bool stands = showed && (disturbed || observers_.showed_lately(goal));
  co_return stands;
}

// As the camera stands now.
Verdict::Refusal Verdict::on_refusal(const std::vector<Datum>& goal) const {
  simulation::WorldConfig config = config_;
  config.camera.pose = player_.camera();
  if (plan_exists(goal, Workspace(config).within(observers_.world()))) return Refusal::wrong;
  return plan_exists(goal, observers_.world()) ? Refusal::out_of_reach : Refusal::right;
}

// A state that no planner can judge counts as one with a plan.
bool Verdict::plan_exists(const std::vector<Datum>& goal, const story::WorldState& world) const {
  const Result<bool> exists = judge_.plan_exists(goal, world);
  return !exists || *exists;
}

}  // namespace pizarra::chaos
