// Many clients who ask for much at once: each has its turn, whatever the others ask for.

#include <fmt/format.h>
#include <set>

#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

class Turns : public Vision {
 protected:
  Turns() { EXPECT_EQ(call(learn_request(0, "circle")), circle_learned); }

  // A client, and what it has asked for without waiting for the answers.
  struct Asking {
    Asking(Turns& room, const std::string& name) : executor(room.executor), client(room, name) {}
    void ask(const std::string& operation) {
      answers.push_back(std::make_unique<std::string>());
      jobs.push_back(executor.spawn(client.ask(form(operation), *answers.back())));
    }
    bool done() const { return std::ranges::all_of(jobs, &Job::done); }
    std::ptrdiff_t answered(std::string_view text) const {
      return std::ranges::count_if(answers, [&](const auto& answer) { return *answer == text; });
    }
    Executor& executor;
    Client client;
    std::vector<std::unique_ptr<std::string>> answers;
    std::vector<Job> jobs;
  };
  Asking& add(const std::string& name) { return *clients.emplace_back(std::make_unique<Asking>(*this, name)); }
  // So many, who ask for as many learnings as may wait.
  void add_learners(int count) {
    for (int n = 0; n < count; ++n) {
      Asking& learner = add(fmt::format("learner-{}", n));
      for (int i = 0; i < 8; ++i) learner.ask(learn_request(0, "circle"));
    }
    run_for(300ms);
  }
  // How long it takes, whatever the answer.
  Duration time_for(Client& client, const std::string& operation, std::string& answer) {
    const Time begun = executor.now();
    answer = client.call(operation);
    return executor.now() - begun;
  }
  bool all_done() const {
    return std::ranges::all_of(clients, [](const auto& each) { return each->done(); });
  }

  static constexpr std::string_view circle_learned = R"x((LEARN "circle" OK))x";
  static constexpr std::string_view found = R"x((FIND "circle" OK ()x";
  std::vector<std::unique_ptr<Asking>> clients;
};

TEST_F(Turns, AFindWaitsForNoLearningOfOthers) {
  for (const int learners : {1, 10}) {
    clients.clear();
    add_learners(learners);
    Client other(*this, "other");
    Duration worst = {};
    for (int n = 0; n < 20; ++n) {
      std::string answer;
      worst = std::max(worst, time_for(other, "(find \"circle\")", answer));
      EXPECT_TRUE(answer.starts_with(found)) << answer << ", beside " << learners;
      run_for(170ms);
    }
    EXPECT_LE(worst, 300ms) << "beside " << learners;
  }
}

TEST_F(Turns, ANameThatIsNoneIsToldAtOnce) {
  add_learners(10);
  Client other(*this, "other");
  for (const std::string operation : {"(learn 20 200 \"a b\")", "(rename \"circle\" \"a b\")"}) {
    std::string answer;
    EXPECT_LE(time_for(other, operation, answer), 100ms) << operation;
    EXPECT_EQ(answer, "bad-name \"a b\"") << operation;
  }
}

TEST_F(Turns, WhatIsSoonDoneWaitsForOneLearningAtMost) {
  add_learners(10);
  Client other(*this, "other");
  std::string answer;
  EXPECT_LE(time_for(other, "(rename \"nothing\" \"something\")", answer), 2500ms);
  EXPECT_EQ(answer, "not-learned \"nothing\"");
  EXPECT_LE(time_for(other, "(get-objects)", answer), 100ms);
  EXPECT_EQ(answer, R"x((GET 1 ("circle")))x");
}

TEST_F(Turns, ALearningIsNotPutOffForEverByWhatIsSoonDone) {
  std::vector<Job> hurrying;
  bool over = false;
  std::vector<std::unique_ptr<Client>> hasty;
  const auto hurry = [&](Client& client) -> Task<void> {
    std::string answer;
    while (!over) co_await client.ask(form("(rename \"nothing\" \"something\")"), answer);
  };
  for (int n = 0; n < 5; ++n) {
    hasty.push_back(std::make_unique<Client>(*this, fmt::format("hasty-{}", n)));
    for (int i = 0; i < 4; ++i) hurrying.push_back(executor.spawn(hurry(*hasty.back())));
  }
  Client other(*this, "other");
  EXPECT_EQ(other.call(learn_request(0, "circle")), circle_learned);
  over = true;
  executor.run_until([&] { return std::ranges::all_of(hurrying, &Job::done); });
}

TEST_F(Turns, ClientsThatLearnAreServedOneAfterAnother) {
  for (int n = 0; n < 3; ++n) {
    Asking& learner = add(fmt::format("learner-{}", n));
    for (int i = 0; i < 2; ++i) learner.ask(learn_request(0, "circle"));
  }
  run_for(6500ms);
  for (const auto& learner : clients) EXPECT_EQ(learner->answered(circle_learned), 1) << learner->client.context.name;
  executor.run_until([&] { return all_done(); });
  for (const auto& learner : clients) EXPECT_EQ(learner->answered(circle_learned), 2) << learner->client.context.name;
}

// As many as do not all have a turn within the time limit, each of which asks again at once when it is refused.
TEST_F(Turns, OfClientsThatLearnWithoutAPauseEachHasItsTurn) {
  constexpr int learners = 16;
  bool over = false;
  std::vector<int> learned(learners);
  const auto learn = [&](Client& client, int& count) -> Task<void> {
    std::string answer;
    while (!over) {
      co_await client.ask(form(learn_request(0, "circle")), answer);
      count += answer.starts_with("(LEARN") ? 1 : 0;
    }
  };
  std::vector<std::unique_ptr<Client>> each;
  std::vector<Job> jobs;
  for (int& count : learned) {
    each.push_back(std::make_unique<Client>(*this, fmt::format("learner-{}", each.size())));
    jobs.push_back(executor.spawn(learn(*each.back(), count)));
  }
  run_for(60s);
  over = true;
  executor.run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
  EXPECT_GE(std::ranges::min(learned), 1) << testing::PrintToString(learned);
  EXPECT_LE(std::ranges::max(learned), 4) << testing::PrintToString(learned);
}

TEST_F(Turns, WhatAClientWaitsForItselfIsNotItsTimeLimit) {
  Asking& patient = add("patient");
  for (int i = 0; i < 7; ++i) patient.ask(learn_request(0, "circle"));
  executor.run_until([&] { return all_done(); });
  EXPECT_EQ(patient.answered(circle_learned), 7);
}

TEST_F(Turns, WhoAsksForMuchMakesRoomForWhoAsksForLittle) {
  add_learners(8);
  for (int n = 0; n < 8; ++n) add(fmt::format("other-{}", n)).ask("(find \"circle\")");
  run_for(500ms);
  for (const auto& client : clients) {
    if (!client->client.context.name.starts_with("other")) continue;
    EXPECT_TRUE(client->answers.front()->starts_with(found)) << *client->answers.front();
  }
}

TEST_F(Turns, WhatOneClientAsksForIsDoneInItsOrder) {
  add_learners(1);
  Asking& hasty = add("hasty");
  for (const std::string& each : {learn_request(1, "square"), std::string("(find \"square\")"),
                                  std::string("(reject \"square\")"), std::string("(find \"square\")")}) {
    hasty.ask(each);
  }
  executor.run_until([&] { return hasty.done(); });
  EXPECT_EQ(*hasty.answers[0], R"x((LEARN "square" OK))x");
  EXPECT_TRUE(hasty.answers[1]->starts_with(R"x((FIND "square" OK)x")) << *hasty.answers[1];
  EXPECT_EQ(*hasty.answers[2], "()");
  EXPECT_EQ(*hasty.answers[3], R"x((FIND "square" FAIL))x");
}

TEST_F(Turns, TracksThatAreEndedAtOnceLeaveNothingBehind) {
  add_learners(1);
  Asking& hasty = add("hasty");
  for (int n = 0; n < 4; ++n) {
    hasty.ask("(track \"circle\")");
    hasty.ask("(end-track)");
  }
  executor.run_until([&] { return hasty.done(); });
  EXPECT_EQ(hasty.answered("()"), 8);
  EXPECT_EQ(facts("(vision-held vision ? tracking)"), "");
}

TEST_F(Turns, ATrackingGoesOnBesideClientsThatFindWithoutAPause) {
  EXPECT_EQ(call("(track \"circle\")"), "()");
  bool over = false;
  int finds = 0;
  const auto search = [&](Client& client) -> Task<void> {
    std::string answer;
    while (!over) {
      co_await client.ask(form("(find \"circle\")"), answer);
      finds += answer.starts_with(found) ? 1 : 0;
    }
  };
  std::vector<std::unique_ptr<Client>> searchers;
  std::vector<Job> jobs;
  for (int n = 0; n < 5; ++n) {
    searchers.push_back(std::make_unique<Client>(*this, fmt::format("searcher-{}", n)));
    jobs.push_back(executor.spawn(search(*searchers.back())));
  }
  std::set<std::string> looks;
  for (int n = 0; n < 30; ++n) {
    run_for(100ms);
    looks.insert(facts("(look vision ? ? ?)"));
  }
  over = true;
  executor.run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
  EXPECT_GE(looks.size(), 14U);
  EXPECT_GE(finds, 60);
}

TEST_F(Turns, ACameraThatVanishesDuringALearningHoldsUpNobody) {
  EXPECT_EQ(call("(connect)"), "()");
  Asking& first = add("first");
  Asking& second = add("second");
  Client other(*this, "other");
  first.ask(learn_request(0, "circle"));
  second.ask(learn_request(0, "circle"));
  run_for(500ms);
  camera.plugged = false;
  std::string answer;
  EXPECT_LE(time_for(other, "(find \"circle\")", answer), 3100ms);
  EXPECT_EQ(answer, R"x((FIND "circle" FAIL))x");
  run_for(200ms);
  EXPECT_EQ(*first.answers[0], R"x((LEARN "circle" FAIL))x");
  camera.plugged = true;
  executor.run_until([&] { return all_done(); });
  EXPECT_EQ(facts("(vision-held vision ? learning)"), "");
  EXPECT_TRUE(other.call("(find \"circle\")").starts_with(found));
}

TEST_F(Turns, AFindThatSuspendsATrackingFailsInTimeWhereTheCameraVanishes) {
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(300ms);
  Client other(*this, "other");
  EXPECT_TRUE(other.call("(find \"circle\")").starts_with(found));
  camera.plugged = false;
  std::string answer;
  EXPECT_LE(time_for(other, "(find \"circle\")", answer), 3500ms);
  EXPECT_EQ(answer, R"x((FIND "circle" FAIL))x");
}

TEST_F(Turns, WhatAClientThatDiedWaitedForIsNotDone) {
  for (const char* name : {"one", "two"}) add(name).ask(learn_request(0, "circle"));
  run_for(100ms);
  {
    Asking dying(*this, "dying");
    dying.ask(learn_request(1, "square"));
    run_for(100ms);
  }
  run_for(20s);
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
}

}  // namespace
}  // namespace pizarra::vision
