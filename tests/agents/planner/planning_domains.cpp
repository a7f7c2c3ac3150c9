#include "tests/agents/planner/planning_domains.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

Datum block(std::size_t index) { return Datum::symbol(fmt::format("b{}", index)); }

std::vector<std::vector<std::size_t>> random_piles(std::size_t blocks, Random& random) {
  std::vector<std::size_t> order(blocks);
  for (std::size_t i = 0; i < blocks; ++i) {
    order[i] = i;
    std::swap(order[i], order[random.below(i + 1)]);
  }
  std::vector<std::vector<std::size_t>> piles;
  for (const std::size_t b : order) {
    const std::size_t pile = random.below(piles.size() + 1);
    if (pile == piles.size()) piles.emplace_back();
    piles[pile].push_back(b);
  }
  return piles;
}

void add_objects(PlanningTask& task, std::string_view names, const std::string& type) {
  for (const Datum& name : facts_of(names)) task.objects.push_back({name, type});
}

}  // namespace

Datum form(std::string_view text) { return read_one(text).value(); }

std::vector<Datum> facts_of(std::string_view text) {
  const Datum all = form(fmt::format("({})", text));
  return {all.items().begin(), all.items().end()};
}

PlanningTask blocks_domain(std::size_t blocks) {
  PlanningTask task;
  task.operators = {{"PICK-UP",
                     {{"?x", "OBJECT"}},
                     facts_of("(clear ?x) (on-table ?x) (arm-empty)"),
                     facts_of("(holding ?x)"),
                     facts_of("(clear ?x) (on-table ?x) (arm-empty)")},
                    {"PUT-DOWN",
                     {{"?x", "OBJECT"}},
                     facts_of("(holding ?x)"),
                     facts_of("(clear ?x) (on-table ?x) (arm-empty)"),
                     facts_of("(holding ?x)")},
                    {"STACK",
                     {{"?x", "OBJECT"}, {"?y", "OBJECT"}},
                     facts_of("(clear ?y) (holding ?x)"),
                     facts_of("(arm-empty) (clear ?x) (on ?x ?y)"),
                     facts_of("(clear ?y) (holding ?x)")},
                    {"UNSTACK",
                     {{"?x", "OBJECT"}, {"?y", "OBJECT"}},
                     facts_of("(on ?x ?y) (clear ?x) (arm-empty)"),
                     facts_of("(holding ?x) (clear ?y)"),
                     facts_of("(on ?x ?y) (clear ?x) (arm-empty)")}};
  for (std::size_t i = 0; i < blocks; ++i) task.objects.push_back({block(i), "OBJECT"});
  return task;
}

PlanningTask random_blocks(std::size_t blocks, Random& random) {
  PlanningTask task = blocks_domain(blocks);
  for (const std::vector<std::size_t>& pile : random_piles(blocks, random)) {
    task.initials.push_back(list("on-table"_sym, block(pile.front())));
    task.initials.push_back(list("clear"_sym, block(pile.back())));
    for (std::size_t i = 1; i < pile.size(); ++i) {
      task.initials.push_back(list("on"_sym, block(pile[i]), block(pile[i - 1])));
    }
  }
  task.initials.push_back(list("arm-empty"_sym));
  for (const std::vector<std::size_t>& pile : random_piles(blocks, random)) {
    for (std::size_t i = 1; i < pile.size(); ++i) {
      task.goals.push_back(list("on"_sym, block(pile[i]), block(pile[i - 1])));
    }
  }
  return task;
}

PlanningTask random_logistics(Random& random) {
  PlanningTask task;
  task.operators = {{"LOAD",
                     {{"?p", "PARCEL"}, {"?t", "TRUCK"}, {"?l", "TOWN"}},
                     facts_of("(at ?p ?l) (at ?t ?l)"),
                     facts_of("(in ?p ?t)"),
                     facts_of("(at ?p ?l)")},
                    {"UNLOAD",
                     {{"?p", "PARCEL"}, {"?t", "TRUCK"}, {"?l", "TOWN"}},
                     facts_of("(in ?p ?t) (at ?t ?l)"),
                     facts_of("(at ?p ?l)"),
                     facts_of("(in ?p ?t)")},
                    {"DRIVE",
                     {{"?t", "TRUCK"}, {"?from", "TOWN"}, {"?to", "TOWN"}},
                     facts_of("(at ?t ?from) (road ?from ?to)"),
                     facts_of("(at ?t ?to)"),
                     facts_of("(at ?t ?from)")}};
  add_objects(task, "p q", "PARCEL");
  add_objects(task, "t u", "TRUCK");
  add_objects(task, "paris lyon nice", "TOWN");
  const std::vector<Datum> towns = facts_of("paris lyon nice");
  for (const Datum& from : towns) {
    for (const Datum& to : towns) {
      if (from != to && random.below(3) != 0) task.initials.push_back(list("road"_sym, from, to));
    }
  }
  for (const Datum& thing : facts_of("p q t u")) task.initials.push_back(list("at"_sym, thing, towns[random.below(3)]));
  for (const Datum& thing : facts_of("p q t")) {
    if (random.below(4) != 0) task.goals.push_back(list("at"_sym, thing, towns[random.below(3)]));
  }
  if (task.goals.empty()) task.goals.push_back(form("(at u nice)"));
  return task;
}

PlanningTask random_gripper(Random& random) {
  PlanningTask task;
  task.operators = {{"PICK",
                     {{"?b", "BALL"}, {"?r", "ROOM"}, {"?g", "GRIPPER"}},
                     facts_of("(at ?b ?r) (robot ?r) (free ?g)"),
                     facts_of("(carry ?b ?g)"),
                     facts_of("(at ?b ?r) (free ?g)")},
                    {"DROP",
                     {{"?b", "BALL"}, {"?r", "ROOM"}, {"?g", "GRIPPER"}},
                     facts_of("(carry ?b ?g) (robot ?r)"),
                     facts_of("(at ?b ?r) (free ?g)"),
                     facts_of("(carry ?b ?g)")},
                    {"MOVE",
                     {{"?from", "ROOM"}, {"?to", "ROOM"}},
                     facts_of("(robot ?from)"),
                     facts_of("(robot ?to)"),
                     facts_of("(robot ?from)")}};
  add_objects(task, "x y z", "BALL");
  add_objects(task, "kitchen cellar", "ROOM");
  add_objects(task, "left right", "GRIPPER");
  const std::vector<Datum> rooms = facts_of("kitchen cellar");
  task.initials = facts_of("(free left) (free right)");
  task.initials.push_back(list("robot"_sym, rooms[random.below(2)]));
  for (const Datum& ball : facts_of("x y z")) {
    task.initials.push_back(list("at"_sym, ball, rooms[random.below(2)]));
    task.goals.push_back(list("at"_sym, ball, rooms[random.below(2)]));
  }
  if (random.below(3) == 0) task.goals.back() = form("(carry z left)");
  return task;
}

namespace {

// The place of each disc, the smallest first: each stands on a peg chosen at random.
std::vector<Datum> random_towers(const std::vector<Datum>& discs, Random& random) {
  std::vector<Datum> tops = facts_of("p q r");
  std::vector<Datum> facts;
  for (std::size_t i = discs.size(); i-- > 0;) {
    Datum& top = tops[random.below(tops.size())];
    facts.push_back(list("on"_sym, discs[i], top));
    top = discs[i];
  }
  for (const Datum& top : tops) facts.push_back(list("clear"_sym, top));
  return facts;
}

}  // namespace

PlanningTask random_hanoi(Random& random) {
  PlanningTask task;
  task.types = {{"disc", "place"}, {"peg", "place"}};
  task.operators = {{"MOVE",
                     {{"?d", "disc"}, {"?from", "place"}, {"?to", "place"}},
                     facts_of("(smaller ?d ?to) (on ?d ?from) (clear ?d) (clear ?to)"),
                     facts_of("(on ?d ?to) (clear ?from)"),
                     facts_of("(on ?d ?from) (clear ?to)")}};
  task.operators.front().equalities.push_back({"?from"_sym, "?to"_sym, false});
  std::vector<Datum> discs = facts_of("a b c");
  discs.resize(2 + random.below(2));
  for (const Datum& disc : discs) task.objects.push_back({disc, "disc"});
  add_objects(task, "p q r", "peg");
  task.initials = random_towers(discs, random);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (const Datum& peg : facts_of("p q r")) task.initials.push_back(list("smaller"_sym, discs[i], peg));
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      task.initials.push_back(list("smaller"_sym, discs[i], discs[j]));
    }
  }
  for (const Datum& fact : random_towers(discs, random)) {
    if (random.below(3) != 0) task.goals.push_back(fact);
  }
  if (random.below(5) == 0) task.goals.push_back(list("on"_sym, discs.back(), discs.front()));
  if (random.below(4) == 0) task.absent_goals.push_back(list("on"_sym, discs.front(), discs.back()));
  return task;
}

PlanningTask random_nonsense(Random& random) {
  constexpr std::size_t fact_count = 7;
  PlanningTask task;
  const auto fact = [](std::size_t index) { return list(Datum::symbol(fmt::format("f{}", index))); };
  const auto some = [&](std::uint64_t one_in) {
    std::vector<Datum> facts;
    for (std::size_t i = 0; i < fact_count; ++i) {
      if (random.below(one_in) == 0) facts.push_back(fact(i));
    }
    return facts;
  };
  for (std::size_t i = 0; i < 8; ++i) {
    task.operators.push_back({fmt::format("OP{}", i), {}, some(4), some(5), some(3)});
  }
  task.initials = some(3);
  task.goals = some(2);
  // An unused name is refused, which does not matter here.
  std::erase_if(task.goals, [&](const Datum& goal) {
    const auto said = [&](const std::vector<Datum>& facts) { return std::ranges::find(facts, goal) != facts.end(); };
    return !said(task.initials) && std::ranges::none_of(task.operators, [&](const PlanningOperator& op) {
      return said(op.preconditions) || said(op.adds) || said(op.deletes);
    });
  });
  return task;
}

PlanningTask random_conditions(Random& random) {
  PlanningTask task;
  task.types = {{"cup", "thing"}, {"box", "thing"}};
  task.objects = {{"c"_sym, "cup"}, {"d"_sym, "cup"}, {"e"_sym, "box"}, {"f"_sym, "thing"}};
  const std::vector<std::string> types{"cup", "box", "thing"};
  const auto some = [&](std::string_view atoms, std::uint64_t one_in) {
    std::vector<Datum> chosen;
    for (const Datum& atom : facts_of(atoms)) {
      if (random.below(one_in) == 0) chosen.push_back(atom);
    }
    return chosen;
  };
  const std::string_view atoms = "(p ?x) (p ?y) (q ?x) (q ?y) (r) (p c)";
  const std::string_view facts = "(p c) (p d) (p e) (p f) (q c) (q d) (q e) (q f) (r)";
  for (std::size_t i = 0; i < 4; ++i) {
    PlanningOperator op{fmt::format("OP{}", i),
                        {{"?x", types[random.below(3)]}, {"?y", types[random.below(3)]}},
                        some(atoms, 5),
                        some(atoms, 4),
                        some(atoms, 3)};
    op.absents = some(atoms, 5);
    if (random.below(3) == 0) op.equalities.push_back({"?x"_sym, "?y"_sym, random.below(3) == 0});
    if (random.below(6) == 0) op.equalities.push_back({"?x"_sym, "c"_sym, random.below(2) == 0});
    task.operators.push_back(std::move(op));
  }
  // Every predicate is spoken of, so that no goal is refused for what it says.
  task.operators.push_back({"NOTHING", {{"?x", "thing"}}, facts_of("(p ?x) (q ?x) (r)"), {}, {}});
  task.initials = some(facts, 3);
  task.goals = some(facts, 5);
  task.absent_goals = some(facts, 5);
  return task;
}

std::string show(const PlanningTask& task) {
  std::string text;
  for (const PlanningOperator& op : task.operators) {
    text += op.name;
    for (const PlanningParameter& parameter : op.parameters)
      text += fmt::format(" {}-{}", parameter.variable, parameter.type);
    text += fmt::format(": {} not {}", write(Datum::list(op.preconditions)), write(Datum::list(op.absents)));
    for (const PlanningEquality& equality : op.equalities) {
      text += fmt::format(" ({} {} {})", write(equality.left), equality.equal ? "=" : "differs from",
                          write(equality.right));
    }
    text += fmt::format(" -> {} / {}\n", write(Datum::list(op.adds)), write(Datum::list(op.deletes)));
  }
  return text + fmt::format("{} -> {} not {}", write(Datum::list(task.initials)), write(Datum::list(task.goals)),
                            write(Datum::list(task.absent_goals)));
}

}  // namespace pizarra::planner
