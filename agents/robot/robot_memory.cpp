#include "agents/robot/robot_memory.hpp"

#include <fmt/format.h>

#include "agents/robot/arm_facts.hpp"
#include "blackboard/away.hpp"

namespace pizarra::robot {

namespace {

constexpr std::size_t max_variables = 256;

// What a reply says, as a handler does.
Result<Datum> result_of(const Datum& reply) {
  if (reply.is_form("fail")) return fail(failure_from_datum(reply));
  return Datum::list({reply.items().begin() + 1, reply.items().end()});
}

}  // namespace

Task<Result<std::vector<Fact>>> RobotMemory::known(Datum pattern) {
  while (true) {
    const Result<std::vector<Fact>> found = co_await context_.board.facts(pattern);
    if (found || !is_away(found.error())) co_return found;
    co_await sleep(context_.executor, retry_pause);
  }
}

Task<Result<void>> RobotMemory::recall() {
  const Datum any = "?"_sym;
  const Datum variable = list("robot-variable"_sym, name_, any, any);
  const Result<std::vector<Fact>> learned = co_await known(variable);
  if (!learned) co_return fail(learned);
  for (const Fact& fact : *learned) {
    const std::optional<arm::Joints> joints = joints_from_datum(fact.datum[3]);
    const bool fits = joints && joints->size() == model_.axes.size();
    if (fits) variables_.insert_or_assign(std::string(fact.datum[2].text()), *joints);
  }
  const Datum speed_fact = list("robot-speed"_sym, name_, any);
  const Result<std::vector<Fact>> speeds = co_await known(speed_fact);
  if (!speeds) co_return fail(speeds);
  for (const Fact& fact : *speeds) speed_percent_ = amount_in(fact.datum[2], 1, 100, "percent").value_or(100);
  const Datum released = released_fact(any);
  const Result<std::vector<Fact>> releases = co_await known(released);
  if (!releases) co_return fail(releases);
  for (const Fact& fact : *releases) released_by_ = std::string(fact.datum[2].text());
  const Datum any_motion = motion_fact(any, any);
  const Result<std::vector<Fact>> motions = co_await known(any_motion);
  if (!motions) co_return fail(motions);
  for (const Fact& fact : *motions) {
    const Datum& outcome = fact.datum[3];
    const bool ended = outcome.is_form("ok") || outcome.is_form("fail");
    earlier_.emplace(fact.datum[2],
                     fail("stopped", "the robot agent was restarted during this motion, and stopped the arm"));
    if (ended) earlier_->answer = result_of(outcome);
  }
  co_return {};
}

const Result<Datum>* RobotMemory::answer_to(const Datum& request) const {
  return earlier_ && earlier_->request == request ? &earlier_->answer : nullptr;
}

Task<Result<void>> RobotMemory::keep_speed(double percent) {
  const Datum fact = list("robot-speed"_sym, name_, percent);
  const Result<Revision> told = if_it_stands(co_await context_.board.tell(fact));
  if (!told) co_return fail(told);
  speed_percent_ = percent;
  co_return {};
}

Result<void> RobotMemory::check_variable(const Datum& variable) const {
  if (variables_.contains(variable.text()) || variables_.size() < max_variables) return {};
  return fail("out-of-range", fmt::format("{} variables are learned already", max_variables), variable);
}

Task<Result<void>> RobotMemory::keep_variable(Datum variable, arm::Joints joints) {
  const Datum fact = list("robot-variable"_sym, name_, variable, joints_to_datum(joints));
  const Result<Revision> told = if_it_stands(co_await context_.board.tell(fact));
  if (!told) co_return fail(told);
  variables_.insert_or_assign(std::string(variable.text()), joints);
  co_return {};
}

void RobotMemory::add_begin(Transaction& transaction, const Datum& request) const {
  transaction.tell(motion_fact(request, Datum()));
}

void RobotMemory::add_end(Transaction& transaction, const Datum& request, const Result<void>& moved) const {
  transaction.tell(motion_fact(request, moved ? list("ok"_sym, "true"_sym) : failure_to_datum(moved.error())));
}

void RobotMemory::add_taken(Transaction& transaction) const { transaction.retract(released_fact("?"_sym)); }

void RobotMemory::add_released(Transaction& transaction, const std::string& client) const {
  transaction.tell(released_fact(Datum::symbol(client)));
}

}  // namespace pizarra::robot
