#include <gtest/gtest.h>

#include "agents/person/person_agent.hpp"
#include "agents/robot/robot_agent.hpp"
#include "agents/runtime/roles.hpp"
#include "agents/vision/agent/vision_agent.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/simulation/simulated_camera.hpp"
#include "drivers/simulation/world.hpp"
#include "lisp/writer.hpp"

namespace pizarra::person {
namespace {

Task<void> until_it_ends(runtime::Agent& agent) {
  const Result<void> ended = co_await agent.run();
  static_cast<void>(ended);
}

simulation::WorldConfig four_cubes() {
  simulation::WorldConfig config;
  config.cubes = {{"circle", simulation::Mark::circle, 450, -150, 0, ""},
                  {"triangle", simulation::Mark::triangle, 450, -50, 0, ""},
                  {"square", simulation::Mark::square, 450, 50, 0, ""},
                  {"cross", simulation::Mark::cross, 450, 50, 0, "square"}};
  return config;
}

// The world, the arm and the eyes, and a person who teaches.
struct Room {
  explicit Room(const simulation::WorldConfig& config = four_cubes()) : world{executor, config} {}

  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  simulation::World world;
  simulation::LocalLink link{world};
  simulation::SimulatedArm arm{link};
  simulation::SimulatedCamera eyes{executor, link};
  std::unique_ptr<Board> robot_view = board.view("robot");
  std::unique_ptr<Board> vision_view = board.view("vision");
  std::unique_ptr<Board> person_view = board.view("person");
  robot::RobotAgent robot{runtime::AgentContext{"robot", "localhost", executor, *robot_view, Random(1)}, arm,
                          arm::crs_f3()};
  vision::VisionAgent vision{runtime::AgentContext{"vision", "localhost", executor, *vision_view, Random(2)}, eyes,
                             nullptr};
  std::vector<std::string> names{"circle", "triangle", "square", "cross"};

  std::string facts(const Datum& pattern) {
    Query query;
    query.clauses.push_back({Query::Clause::Kind::fact, pattern});
    const Result<Answers> answers = board.ask(query);
    std::string out;
    if (!answers) return describe(answers.error());
    for (const Answer& answer : answers->answers) out += write(answer.facts[0].datum) + "\n";
    return out;
  }
};

TEST(Person, TeachesEveryCubeAndTheEndEffectorByClickingOnThem) {
  Room room;
  PersonAgent person(runtime::AgentContext{"person", "localhost", room.executor, *room.person_view, Random(3)},
                     room.link, room.names);
  const Job robot = room.executor.spawn(until_it_ends(room.robot));
  const Job vision = room.executor.spawn(until_it_ends(room.vision));
  const Job teaching = room.executor.spawn(until_it_ends(person));
  room.executor.run_for(40s);
  EXPECT_EQ(room.facts(list("person"_sym, "?"_sym, "?"_sym)),
            "(person done (\"end-effector\" \"circle\" \"triangle\" \"square\" \"cross\"))\n");
  EXPECT_EQ(room.facts(list("to-accept"_sym, "?"_sym, "?"_sym, "?"_sym)), "") << "others may forget all of it";
}

// As this lens shows it from where the arm is ready.
TEST(Person, LowersTheArmWhereTheBorderOfTheImageCutsItsMark) {
  simulation::WorldConfig config = four_cubes();
  config.camera.lens = {0.1, 0.1, 0, 0, 0};
  Room room(config);
  PersonAgent person(runtime::AgentContext{"person", "localhost", room.executor, *room.person_view, Random(3)},
                     room.link, room.names);
  const Job robot = room.executor.spawn(until_it_ends(room.robot));
  const Job vision = room.executor.spawn(until_it_ends(room.vision));
  const Job teaching = room.executor.spawn(until_it_ends(person));
  room.executor.run_for(60s);
  EXPECT_TRUE(room.facts(list("person"_sym, "?"_sym, "?"_sym)).starts_with("(person done "))
      << room.facts(list("person"_sym, "?"_sym, "?"_sym));
}

TEST(Person, AsksForAMotionAgainThatWasStopped) {
  Room room;
  PersonAgent person(runtime::AgentContext{"person", "localhost", room.executor, *room.person_view, Random(3)},
                     room.link, room.names);
  const Job robot = room.executor.spawn(until_it_ends(room.robot));
  const Job vision = room.executor.spawn(until_it_ends(room.vision));
  const Job teaching = room.executor.spawn(until_it_ends(person));
  const Datum moving = list("arm"_sym, "robot"_sym, "moving"_sym, "?"_sym);
  const auto moves = [&] { return room.facts(moving).starts_with("(arm"); };
  room.executor.run_until([&] { return moves() || room.executor.now() > Time{} + 20s; });
  ASSERT_TRUE(moves());
  Transaction stop;
  stop.tell(list("request"_sym, "s1"_sym, "robot"_sym, list("finish"_sym, "stop"_sym)));
  ASSERT_TRUE(room.board.transact("somebody", stop));
  room.executor.run_for(60s);
  EXPECT_TRUE(room.facts(list("person"_sym, "?"_sym, "?"_sym)).starts_with("(person done"));
}

TEST(Person, WhoComesBackDoesNotTeachAgain) {
  Room room;
  const Job robot = room.executor.spawn(until_it_ends(room.robot));
  const Job vision = room.executor.spawn(until_it_ends(room.vision));
  std::vector<Datum> pattern(10, "?"_sym);
  pattern[0] = "learned"_sym;
  const Datum learned = Datum::list(pattern);
  const runtime::AgentContext context{"person", "localhost", room.executor, *room.person_view, Random(3)};
  {
    PersonAgent person(context, room.link, room.names);
    const Job teaching = room.executor.spawn(until_it_ends(person));
    room.executor.run_for(40s);
  }
  const std::string before = room.facts(learned);
  PersonAgent again(context, room.link, room.names);
  const Job teaching = room.executor.spawn(until_it_ends(again));
  room.executor.run_for(20s);
  EXPECT_EQ(room.facts(learned), before);
  EXPECT_FALSE(before.empty());
}

// The usual robot is away, and other eyes than the usual ones are wired.
TEST(Person, AsksTheRobotAndTheEyesThatPlayItsRoles) {
  Room room;
  simulation::SimulatedArm arm{room.link};
  simulation::SimulatedCamera camera{room.executor, room.link};
  const std::unique_ptr<Board> robot_view = room.board.view("robot-2");
  const std::unique_ptr<Board> vision_view = room.board.view("vision-2");
  robot::RobotAgent robot{runtime::AgentContext{"robot-2", "localhost", room.executor, *robot_view, Random(4)}, arm,
                          arm::crs_f3()};
  vision::VisionAgent eyes{runtime::AgentContext{"vision-2", "localhost", room.executor, *vision_view, Random(5)},
                           camera, nullptr};
  ASSERT_TRUE(room.board.declare("somebody", runtime::role_relations()));
  Transaction wiring;
  wiring.tell(list("wired"_sym, "person"_sym, "eyes"_sym, "vision-2"_sym));
  ASSERT_TRUE(room.board.transact("somebody", wiring));
  PersonAgent person(runtime::AgentContext{"person", "localhost", room.executor, *room.person_view, Random(3)},
                     room.link, room.names);
  const Job moved = room.executor.spawn(until_it_ends(robot));
  const Job usual = room.executor.spawn(until_it_ends(room.vision));
  const Job wired = room.executor.spawn(until_it_ends(eyes));
  const Job teaching = room.executor.spawn(until_it_ends(person));
  room.executor.run_for(40s);
  EXPECT_EQ(room.facts(list("person"_sym, "?"_sym, "?"_sym)),
            "(person done (\"end-effector\" \"circle\" \"triangle\" \"square\" \"cross\"))\n");
  std::vector<Datum> learned(10, "?"_sym);
  learned[0] = "learned"_sym;
  learned[1] = "vision"_sym;
  EXPECT_EQ(room.facts(Datum::list(learned)), "");
  learned[1] = "vision-2"_sym;
  EXPECT_NE(room.facts(Datum::list(learned)), "");
  EXPECT_EQ(room.facts(list("holder"_sym, "person"_sym, "?"_sym, "?"_sym, "?"_sym)),
            "(holder person robot robot-2 stands-in)\n(holder person eyes vision-2 wired)\n");
}

Task<void> rename(Board& board, std::string name, std::string new_name) {
  const Datum request = list("request"_sym, "r1"_sym, "vision"_sym, list("rename"_sym, name, new_name));
  const Result<Revision> told = co_await board.tell(request);
  EXPECT_TRUE(told.has_value());
}

TEST(Person, WhoComesBackAcceptsThatACubeWasGivenAnotherName) {
  Room room;
  const Job robot = room.executor.spawn(until_it_ends(room.robot));
  const Job vision = room.executor.spawn(until_it_ends(room.vision));
  const runtime::AgentContext context{"person", "localhost", room.executor, *room.person_view, Random(3)};
  {
    PersonAgent person(context, room.link, room.names);
    const Job teaching = room.executor.spawn(until_it_ends(person));
    room.executor.run_for(40s);
  }
  const Job renaming = room.executor.spawn(rename(*room.person_view, "circle", "disc"));
  room.executor.run_for(2s);
  PersonAgent again(context, room.link, room.names);
  const Job teaching = room.executor.spawn(until_it_ends(again));
  room.executor.run_for(40s);
  EXPECT_EQ(room.facts(list("person"_sym, "?"_sym, "?"_sym)),
            "(person done (\"end-effector\" \"circle\" \"triangle\" \"square\" \"cross\"))\n");
}

}  // namespace
}  // namespace pizarra::person
