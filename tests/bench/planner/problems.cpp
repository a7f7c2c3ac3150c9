#include "tests/bench/planner/problems.hpp"

#include <fmt/format.h>

#include "lisp/reader.hpp"
#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra::bench {

namespace {

void add_objects(planner::PlanningTask& task, std::string_view prefix, std::size_t count, const std::string& type) {
  for (std::size_t i = 0; i < count; ++i) task.objects.push_back({planner::form(fmt::format("{}{}", prefix, i)), type});
}

void hold(planner::PlanningTask& task, std::string_view facts) {
  for (Datum& fact : planner::facts_of(facts)) task.initials.push_back(std::move(fact));
}

void want(planner::PlanningTask& task, std::string_view facts) {
  for (Datum& fact : planner::facts_of(facts)) task.goals.push_back(std::move(fact));
}

}  // namespace

planner::PlanningTask blocks_problem(std::size_t blocks, std::uint64_t seed) {
  Random random(seed);
  return planner::random_blocks(blocks, random);
}

planner::PlanningTask hanoi_problem(std::size_t discs) {
  planner::PlanningTask task;
  task.operators = {{"MOVE",
                     {{"?disc", "DISC"}, {"?from", "THING"}, {"?to", "THING"}},
                     planner::facts_of("(smaller ?disc ?to) (on ?disc ?from) (clear ?disc) (clear ?to)"),
                     planner::facts_of("(clear ?from) (on ?disc ?to)"),
                     planner::facts_of("(on ?disc ?from) (clear ?to)")}};
  task.types = {{"DISC", "THING"}};
  add_objects(task, "d", discs, "DISC");
  add_objects(task, "peg", 3, "THING");
  for (std::size_t disc = 0; disc < discs; ++disc) {
    for (std::size_t larger = disc + 1; larger < discs; ++larger)
      hold(task, fmt::format("(smaller d{} d{})", disc, larger));
    for (std::size_t peg = 0; peg < 3; ++peg) hold(task, fmt::format("(smaller d{} peg{})", disc, peg));
    const bool last = disc + 1 == discs;
    hold(task, last ? fmt::format("(on d{} peg0)", disc) : fmt::format("(on d{} d{})", disc, disc + 1));
    want(task, last ? fmt::format("(on d{} peg2)", disc) : fmt::format("(on d{} d{})", disc, disc + 1));
  }
  hold(task, "(clear d0) (clear peg1) (clear peg2)");
  return task;
}

planner::PlanningTask gripper_problem(std::size_t balls) {
  planner::PlanningTask task;
  task.operators = {{"MOVE",
                     {{"?from", "ROOM"}, {"?to", "ROOM"}},
                     planner::facts_of("(at-robby ?from)"),
                     planner::facts_of("(at-robby ?to)"),
                     planner::facts_of("(at-robby ?from)")},
                    {"PICK",
                     {{"?ball", "BALL"}, {"?room", "ROOM"}, {"?gripper", "GRIPPER"}},
                     planner::facts_of("(at ?ball ?room) (at-robby ?room) (free ?gripper)"),
                     planner::facts_of("(carry ?ball ?gripper)"),
                     planner::facts_of("(at ?ball ?room) (free ?gripper)")},
                    {"DROP",
                     {{"?ball", "BALL"}, {"?room", "ROOM"}, {"?gripper", "GRIPPER"}},
                     planner::facts_of("(carry ?ball ?gripper) (at-robby ?room)"),
                     planner::facts_of("(at ?ball ?room) (free ?gripper)"),
                     planner::facts_of("(carry ?ball ?gripper)")}};
  add_objects(task, "room", 2, "ROOM");
  add_objects(task, "ball", balls, "BALL");
  add_objects(task, "gripper", 2, "GRIPPER");
  hold(task, "(at-robby room0) (free gripper0) (free gripper1)");
  for (std::size_t ball = 0; ball < balls; ++ball) {
    hold(task, fmt::format("(at ball{} room0)", ball));
    want(task, fmt::format("(at ball{} room1)", ball));
  }
  return task;
}

planner::PlanningTask logistics_problem(std::size_t cities, std::size_t parcels, std::uint64_t seed) {
  planner::PlanningTask task;
  task.operators = {{"LOAD",
                     {{"?parcel", "PARCEL"}, {"?vehicle", "VEHICLE"}, {"?place", "PLACE"}},
                     planner::facts_of("(at ?parcel ?place) (at ?vehicle ?place)"),
                     planner::facts_of("(in ?parcel ?vehicle)"),
                     planner::facts_of("(at ?parcel ?place)")},
                    {"UNLOAD",
                     {{"?parcel", "PARCEL"}, {"?vehicle", "VEHICLE"}, {"?place", "PLACE"}},
                     planner::facts_of("(in ?parcel ?vehicle) (at ?vehicle ?place)"),
                     planner::facts_of("(at ?parcel ?place)"),
                     planner::facts_of("(in ?parcel ?vehicle)")},
                    {"GO",
                     {{"?vehicle", "VEHICLE"}, {"?from", "PLACE"}, {"?to", "PLACE"}},
                     planner::facts_of("(at ?vehicle ?from) (way ?vehicle ?from ?to)"),
                     planner::facts_of("(at ?vehicle ?to)"),
                     planner::facts_of("(at ?vehicle ?from)")}};
  add_objects(task, "parcel", parcels, "PARCEL");
  add_objects(task, "truck", cities, "VEHICLE");
  add_objects(task, "plane", 1, "VEHICLE");
  add_objects(task, "depot", cities, "PLACE");
  add_objects(task, "airport", cities, "PLACE");
  hold(task, "(at plane0 airport0)");
  for (std::size_t city = 0; city < cities; ++city) {
    hold(task,
         fmt::format("(at truck{0} depot{0}) (way truck{0} depot{0} airport{0}) (way truck{0} airport{0} depot{0})",
                     city));
    for (std::size_t other = 0; other < cities; ++other) {
      if (other != city) hold(task, fmt::format("(way plane0 airport{} airport{})", city, other));
    }
  }
  Random random(seed);
  for (std::size_t parcel = 0; parcel < parcels; ++parcel) {
    hold(task, fmt::format("(at parcel{} depot{})", parcel, random.below(cities)));
    want(task, fmt::format("(at parcel{} depot{})", parcel, random.below(cities)));
  }
  return task;
}

}  // namespace pizarra::bench
