#include "agents/coordinator/pursue/coordinator_contract.hpp"

#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

constexpr std::string_view contract_form = R"scheme(
(contract coordinator
  (offers (goal (fact list) ...) (cancel) (why) (why-not (fact list) ...))
  (posts (relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))
         (relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role))
         (relation goal ((n integer) (facts list)) (key n) (durable))
         (relation goal-state ((n integer) (state symbol) (detail list)) (key n) (durable))
         (relation place ((name symbol) (x number) (y number) (z number) (frame integer)) (key name))
         (relation believed ((fact list)))
         (relation operation ((index integer) (operation list) (state symbol)) (key) (durable))
         (relation micro-task ((index integer) (step list) (state symbol)) (key) (durable))
         (relation servo ((state integer) (object symbol) (err-x number) (err-y number) (err-d number)) (key))
         (relation camera-pose ((x number) (y number) (z number) (pan number) (tilt number) (roll number)
                                (state symbol) (spread number) (guess list)) (key) (durable))
         (relation event ((seq integer) (kind symbol) (sentence string) (detail datum)) (key seq) (durable)){})
  (reads agent bound wired look camera-model gripper arm arm-pose arm-foot robot-speed goal goal-state camera-pose event believed{})
  (configures)
  (monitors goal-state operation servo event))
)scheme";

}  // namespace

std::string coordinator_contract(const TaskDomain& domain, bool head) {
  std::string relations, names;
  for (const Relation& predicate : domain.relations()) {
    relations += ' ' + write(relation_to_datum(predicate));
    names += ' ' + predicate.name;
  }
  return fmt::format(contract_form, relations, names + (head ? " head looking-at pan-tilt-unit stop" : ""));
}

}  // namespace pizarra::coordinator
