// Several clients of one pair of eyes: who may do what while others do something else.

#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

TEST_F(Vision, AFindSuspendsATrackingAndResumesIt) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(200ms);
  std::string found;
  const Job finding = executor.spawn(ask("vision", form("(find \"circle\")"), 20s, found));
  run_for(10ms);
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision finding yes)");
  executor.run_until([&] { return finding.done(); });
  EXPECT_TRUE(found.starts_with(R"x((FIND "circle" OK ()x")) << found;
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision tracking yes)");
  const std::string before = facts("(look vision ? ? ?)");
  run_for(200ms);
  EXPECT_NE(facts("(look vision ? ? ?)"), before);
}

TEST_F(Vision, LearningAndFindingAreServedInTurn) {
  EXPECT_EQ(call("(connect)"), "()");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision capturing yes)");
  Client other(*this, "other");
  std::string learned;
  const Job learning = executor.spawn(ask("vision", form(learn_request(0, "circle")), 20s, learned));
  run_for(300ms);
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision learning yes)");
  EXPECT_EQ(facts("(vision-held vision ? learning)"), "(vision-held vision tester learning)");
  std::vector<std::string> later(4);
  std::vector<Job> jobs;
  jobs.push_back(executor.spawn(other.ask(form(learn_request(1, "square")), later[0])));
  jobs.push_back(executor.spawn(other.ask(form("(find \"disc\")"), later[1])));
  jobs.push_back(executor.spawn(ask("vision", form("(rename \"circle\" \"disc\")"), 20s, later[2])));
  jobs.push_back(executor.spawn(other.ask(form("(rename \"square\" \"box\")"), later[3])));
  EXPECT_EQ(call("(get-objects)"), R"x((GET 0 ()))x");
  executor.run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
  EXPECT_EQ(learned, R"x((LEARN "circle" OK))x");
  EXPECT_EQ(later[0], R"x((LEARN "square" OK))x");
  EXPECT_TRUE(later[1].starts_with(R"x((FIND "disc" OK ()x")) << later[1];
  EXPECT_EQ(later[2], "()");
  EXPECT_EQ(later[3], "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("disc", "box")))x");
}

TEST_F(Vision, WhatATrackingExcludesIsRefusedWithWhoTracks) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  Client other(*this, "other");
  EXPECT_EQ(other.call(learn_request(1, "square")), "busy tester");
  EXPECT_EQ(call(learn_request(1, "square")), "busy tester");
  EXPECT_EQ(other.call("(end-track)"), "busy tester");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision tracking yes)");
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(other.call("(end-track)"), "()");
  EXPECT_EQ(other.call(learn_request(1, "square")), R"x((LEARN "square" OK))x");
}

TEST_F(Vision, WhatAnotherTracksIsNeitherForgottenNorRenamedNorTakenBack) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(track \"circle\")"), "()");
  Client other(*this, "other");
  EXPECT_EQ(other.call("(forget \"Circle\")"), "busy tester");
  EXPECT_EQ(other.call("(rename \"circle\" \"disc\")"), "busy tester");
  EXPECT_EQ(other.call("(reject \"circle\")"), "busy tester");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(call("(accept \"disc\")"), "()");
  EXPECT_EQ(other.call("(forget \"disc\")"), "()");
}

TEST_F(Vision, HoweverMuchOneClientAsksForAnothersTurnComes) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  Client greedy(*this, "greedy");
  Client other(*this, "other");
  std::vector<std::string> answers(30);
  std::vector<Job> jobs;
  for (std::string& answer : answers) jobs.push_back(executor.spawn(greedy.ask(form("(find \"circle\")"), answer)));
  run_for(10ms);
  EXPECT_TRUE(other.call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
  executor.run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
  const auto refused = std::ranges::count(answers, "busy greedy");
  EXPECT_GT(refused, 0);
  EXPECT_EQ(std::ranges::count_if(answers, [](const std::string& a) { return a.starts_with("(FIND \"circle\" OK"); }),
            static_cast<std::ptrdiff_t>(answers.size()) - refused);
}

TEST_F(Vision, EachClientTracksAndConnectsForItself) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call(learn_request(1, "square")), R"x((LEARN "square" OK))x");
  Client other(*this, "other");
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(other.call("(track \"square\")"), "()");
  run_for(200ms);
  EXPECT_TRUE(says().starts_with("(TRACK 2 ")) << says();
  EXPECT_EQ(facts("(vision-held vision ? tracking)"),
            "(vision-held vision tester tracking)\n(vision-held vision other tracking)");
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(call("(disconnect)"), "()");
  run_for(200ms);
  EXPECT_TRUE(says().starts_with("(TRACK 1 (\"square\" OK")) << says();
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision tracking yes)");
  EXPECT_EQ(other.call("(end-track)"), "()");
  EXPECT_EQ(other.call("(disconnect)"), "()");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
  EXPECT_EQ(facts("(vision-held vision ? ?)"), "");
}

TEST_F(Vision, AClientThatDiesLetsGoOfItsModes) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  {
    Client dying(*this, "dying");
    EXPECT_EQ(dying.call("(track \"circle\")"), "()");
    run_for(5s);
    EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision tracking yes)");
  }
  run_for(5s);
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
  EXPECT_EQ(facts("(vision-held vision ? ?)"), "");
  EXPECT_EQ(says(), "nothing");
}

TEST_F(Vision, WhatAClientAskedToKeepGoesOnWithoutItUntilAnyoneEndsIt) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  {
    Client passing(*this, "passing");
    EXPECT_EQ(passing.call("(keep)"), "nothing-held keep");
    EXPECT_EQ(passing.call("(track \"circle\")"), "()");
    EXPECT_EQ(passing.call("(keep)"), "()");
  }
  run_for(10s);
  EXPECT_EQ(facts("(vision-held vision ? ?)"),
            "(vision-held vision anybody connected)\n(vision-held vision anybody tracking)");
  EXPECT_NE(says(), "nothing");
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(call("(disconnect)"), "()");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
}

// What they held would be anyone's to end.
TEST_F(Vision, NoClientIsCalledAsThoseAreWhoseModesAreAnyones) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  for (const char* name : {"anybody", "absent"}) {
    Client client(*this, name);
    EXPECT_EQ(client.call("(track \"circle\")"), "bad-name " + std::string(name));
    EXPECT_EQ(client.call("(get-objects)"), "bad-name " + std::string(name));
  }
  EXPECT_EQ(facts("(vision-held vision ? ?)"), "");
}

// A script that only tells requests has no presence: nobody can see it die.
class AbsentClient : public Vision {
 protected:
  AbsentClient() { EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x"); }
  void request(const std::string& operation) {
    const std::string name = "r" + std::to_string(++requests);
    const Job telling = executor.spawn(tell(*script, form("(request " + name + " vision " + operation + ")")));
    run_for(1s);
  }
  std::string held() { return facts("(vision-held vision ? ?)"); }

  const std::unique_ptr<Board> script = board.view("script");
  int requests = 0;
};

TEST_F(AbsentClient, HoldsWhatItBeganSoThatAnyoneMayEndIt) {
  request("(track \"circle\")");
  run_for(6s);
  EXPECT_EQ(held(), "(vision-held vision absent connected)\n(vision-held vision absent tracking)");
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision capturing yes)");
}

TEST_F(AbsentClient, HoldsItForAMinuteAfterItAskedLast) {
  request("(track \"circle\")");
  // No images need be drawn for it.
  camera.plugged = false;
  for (int n = 0; n < 3; ++n) {
    run_for(50s);
    EXPECT_NE(held(), "") << n;
    request("(track \"circle\")");
  }
  run_for(62s);
  EXPECT_EQ(held(), "");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
}

TEST_F(AbsentClient, MayHaveItKept) {
  request("(track \"circle\")");
  request("(keep)");
  camera.plugged = false;
  run_for(100s);
  EXPECT_EQ(held(), "(vision-held vision anybody connected)\n(vision-held vision anybody tracking)");
}

}  // namespace
}  // namespace pizarra::vision
