#include "agents/coordinator/pursue/plan_in_hand.hpp"

#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra::coordinator {

Task<Result<std::optional<NextOperation>>> PlanInHand::next(std::int64_t goal) {
  if (!was_made_for(goal)) co_return std::nullopt;
  Result<NextOperation> next = co_await planning_.next(goal);
  if (next) co_return std::move(*next);
  const std::string& why = next.error().symbol;
  if (why == "off-plan" || why == "not-ready") co_return std::nullopt;
  co_return fail(next);
}

Task<void> PlanInHand::tell(std::int64_t goal, std::vector<Datum> operations) {
  std::string told;
  for (const Datum& operation : operations) told += ' ' + write(operation);
  const bool again = was_made_for(goal);
  goal_ = goal;
  const std::string sentence =
      operations.empty() ? "nothing needs to be done" : fmt::format("{}:{}", again ? "new plan" : "plan", told);
  const Datum detail = list("plan"_sym, goal, Datum::list(std::move(operations)));
  co_await story_.tell("plan", sentence, detail);
}

}  // namespace pizarra::coordinator
