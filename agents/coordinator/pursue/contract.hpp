#pragma once

// What the coordinator offers, posts, reads, lets you configure and monitor. The domain's predicates come on top.

#include <string_view>

namespace pizarra::coordinator {

inline constexpr std::string_view coordinator_contract = R"scheme(
(contract coordinator
  (offers (goal (fact list) ...) (cancel) (why))
  (posts (relation goal ((n integer) (facts list)) (key n) (durable))
         (relation goal-state ((n integer) (state symbol) (detail list)) (key n) (durable))
         (relation place ((name symbol) (x number) (y number) (z number) (frame integer)) (key name))
         (relation believed ((fact list)))
         (relation plan ((n integer) (operations list)) (key) (durable))
         (relation operation ((index integer) (operation list) (state symbol)) (key) (durable))
         (relation micro-task ((index integer) (step list) (state symbol)) (key) (durable))
         (relation servo ((state integer) (object symbol) (err-x number) (err-y number) (err-d number)) (key))
         (relation event ((seq integer) (kind symbol) (sentence string) (detail datum)) (key seq) (durable)))
  (reads agent vision-says camera-model gripper arm-pose)
  (configures)
  (monitors goal-state operation servo event))
)scheme";

}  // namespace pizarra::coordinator
