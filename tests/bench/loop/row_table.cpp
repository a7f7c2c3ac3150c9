#include "tests/bench/loop/row_table.hpp"

namespace pizarra::bench {

namespace {

constexpr const char* slips_seldom = "open loop 56.7, IM 81.7 (2.60x), DoReMi 83.3 (1.94x), CaM 95.0 (1.57x)";
constexpr const char* slips_often = "open loop 21.7, IM 75.0 (3.19x), DoReMi 76.7 (2.55x), CaM 88.3 (1.90x)";

}  // namespace

const std::vector<Row>& row_table() {
  static const std::vector<Row> rows{
      {"p=0", {}, 99, {}, "open loop, IM, DoReMi, CaM: not told"},
      {"p=0.15", {.slip_chance = 0.15}, 99, 1.4, slips_seldom, 56.7},
      {"p=0.3", {.slip_chance = 0.3, .slip_draws = 3}, 98, 1.7, slips_often, 21.7},
      {"p=0.15-once", {.slip_chance = 0.15, .slip_draws = 1}, 99, 1.4, slips_seldom, 56.7},
      {"p=0.3-once", {.slip_chance = 0.3, .slip_draws = 1}, 98, 1.7, slips_often, 21.7},
      {"q=0.25", {.misplace = 0.25}, 98.3, {}, "open loop 90.0, IM 90.0, DoReMi 96.7, CaM 98.3", 90.0},
      {"q=0.5", {.misplace = 0.5}, 95, {}, "open loop 41.7, IM 71.7, DoReMi 75.0, CaM 83.3", 41.7},
      {"q=0.75", {.misplace = 0.75}, 95, {}, "open loop 15.0, IM 40.0, DoReMi 40.0, CaM 63.3", 15.0},
      {"moved", {.moved = true}, 99, {}, "CaM 93 to 97, on a real robot"},
      {"slid-20", {.slide_mm_s = 20}, 99, {}, "the thesis' Fig. 6.37, without figures; at rest 0.3 s before the grip"},
      {"slid-50", {.slide_mm_s = 50}, 99, {}, "as above"},
      {"slid-100", {.slide_mm_s = 100}, 99, {}, "as above"},
      {"sliding-20", {.slide_mm_s = 20, .at_the_grip = true}, 90, {}, "none; it moves while the fingers close"},
      {"sliding-50", {.slide_mm_s = 50, .at_the_grip = true}, 90, {}, "as above"},
      {"sliding-100", {.slide_mm_s = 100, .at_the_grip = true}, 90, {}, "as above"},
      {"removed", {.removed = true}, 99, {}, "CaM 90 to 97, on a real robot"},
      {"tower-4", {.slip_chance = 0.15, .cubes = 4}, 98, {}, "not told; p=0.15 with four cubes"},
  };
  return rows;
}

}  // namespace pizarra::bench
