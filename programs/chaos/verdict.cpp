#include "programs/chaos/verdict.hpp"

#include "programs/chaos/refusal_reason.hpp"
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

Verdict::Refusal Verdict::on_refusal(const std::vector<Datum>& goal, const Failure& told) const {
  using Kind = Refusal::Kind;
  const story::WorldState& world = observers_.world();
  const story::WorldState had = Workspace(config_).within(world);
  if (plan_exists(goal, had)) return {Kind::wrong, "there is a plan"};
  const std::optional<std::string> denied = denied_reason(told, world, had);
  if (denied) return {Kind::wrong, *denied};
  return {plan_exists(goal, world) ? Kind::out_of_reach : Kind::right, {}};
}

// A state that no planner can judge counts as one with a plan.
bool Verdict::plan_exists(const std::vector<Datum>& goal, const story::WorldState& world) const {
  const Result<bool> exists = judge_.plan_exists(goal, world);
  return !exists || *exists;
}

}  // namespace pizarra::chaos
