#include "agents/console/page_stops.hpp"

#include "agents/console/change_text.hpp"
#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

Relation stop_relation() {
  return relation_from_datum(read_one("(relation stop ((who symbol) (reason string)) (key who) (durable))").value())
      .value();
}

}  // namespace

void PageStops::stop(const Datum& form) {
  const std::int64_t number = form[1].integer();
  if (number <= newest_) return;
  newest_ = number;
  telling_.push_back(board_.executor().spawn(tell(number, std::string(form[2].text()))));
  std::erase_if(telling_, [](const Job& job) { return job.done(); });
}

Task<void> PageStops::tell(std::int64_t number, std::string reason) {
  const Datum fact = list("stop"_sym, board_.client(), reason);
  Result<Revision> told = co_await board_.facts().tell(fact);
  // It stands also for a robot that is yet to come.
  if (!told && told.error().symbol == "undeclared-relation") {
    const std::vector<Relation> relations(1, stop_relation());
    const Result<void> declared = co_await board_.facts().declare(relations);
    if (declared) told = co_await board_.facts().tell(fact);
  }
  told = if_it_stands(std::move(told));
  const Datum done;
  voice_.say(told ? reply_text(number, done) : refusal_text(number, told.error()));
}

}  // namespace pizarra::console
