#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "agents/runtime/service.hpp"
#include "agents/vision/agent/vision_agent.hpp"
#include "agents/vision/memory/object_database.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/vision/fake_camera.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

Datum form(std::string_view written) { return read_one(written).value(); }

// One life of the agent: destroying it is its death.
class VisionLife {
 public:
  VisionLife(Executor& executor, MemoryBoard& board, StereoCamera& camera, Streams* streams, VisionOptions options,
             const std::string& name = "vision")
      : view_(board.view(name)),
        agent_({name, "here", executor, *view_, Random(1)}, camera, streams, std::move(options)) {
    job_ = executor.spawn(live());
  }

 private:
  Task<void> live() {
    const Result<void> ended = co_await agent_.run();
    EXPECT_TRUE(ended.has_value()) << describe(ended.error());
  }
  std::unique_ptr<Board> view_;
  VisionAgent agent_;
  Job job_;
};

class Vision : public testing::Test {
 protected:
  Vision() {
    camera.scene.faces = {{.mark = "circle", .place = {-100, 0, 850}},
                          {.mark = "square", .place = {0, 0, 850}},
                          {.mark = "plate", .place = {100, 0, 840}}};
    const Job started = executor.spawn(start());
    executor.run_until([&] { return started.done(); });
    live();
  }
  void live(const std::string& objects = "") {
    life.emplace(executor, board, camera, &streams, VisionOptions{.objects_directory = objects});
  }
  Task<void> start() {
    const Result<void> present = co_await service.start();
    EXPECT_TRUE(present.has_value());
  }

  // The text that was answered, "()" where there is none, or the failure's symbol and subject.
  std::string call(const std::string& operation, Duration timeout = 20s, const std::string& agent = "vision") {
    std::string answer;
    const Job job = executor.spawn(ask(agent, form(operation), timeout, answer));
    executor.run_until([&] { return job.done(); });
    return answer;
  }
  Task<void> ask(std::string agent, Datum operation, Duration timeout, std::string& answer) {
    const Result<Datum> result = co_await caller.call(agent, operation, timeout);
    answer = shown(result);
  }
  void run_for(Duration duration) {
    const Time end = executor.now() + duration;
    executor.call_at(end, [] {});
    executor.run_until([&] { return executor.now() >= end; });
  }
  // Every fact that fits, as written, one a line.
  std::string facts(std::string_view pattern) {
    std::string out;
    const Answers answers = board.ask(query_from_datum(form(pattern)).value()).value();
    for (const Answer& answer : answers.answers) {
      if (!out.empty()) out += "\n";
      out += write(answer.facts.front().datum);
    }
    return out;
  }
  void retract(std::string_view pattern) {
    const Job job = executor.spawn(retract_task(form(pattern)));
    executor.run_until([&] { return job.done(); });
  }
  Task<void> retract_task(Datum pattern) {
    const Result<Revision> retracted = co_await view->retract(pattern);
    EXPECT_TRUE(retracted.has_value());
  }
  std::string learn_request(std::size_t face, const std::string& name) {
    const cv::Point2d at = project(camera.model(), camera.scene.faces[face].place, false);
    return write(list("learn"_sym, at.x, at.y, name));
  }
  void learn_all() {
    EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
    EXPECT_EQ(call(learn_request(2, "end-effector")), R"x((LEARN "end-effector" OK))x");
  }
  std::string says() {
    const Answers answers = board.ask(query_from_datum(form("(vision-says vision ?frame ?text)")).value()).value();
    if (answers.answers.empty()) return "nothing";
    return std::string(answers.answers[0].bindings.find("?text")->text());
  }

  // Another client, present until it is destroyed.
  struct Client {
    Client(Vision& room, const std::string& name)
        : fixture(room), view(room.board.view(name)), context{name, "here", room.executor, *view, Random(3)} {
      const Job started = fixture.executor.spawn(start());
      fixture.executor.run_until([&] { return started.done(); });
    }
    Task<void> start() {
      const Result<void> present = co_await service.start();
      EXPECT_TRUE(present.has_value());
    }
    std::string call(const std::string& operation) {
      std::string answer;
      const Job job = fixture.executor.spawn(ask(form(operation), answer));
      fixture.executor.run_until([&] { return job.done(); });
      return answer;
    }
    Task<void> ask(Datum operation, std::string& answer) {
      const Result<Datum> result = co_await caller.call("vision", operation, 20s);
      answer = Vision::shown(result);
    }
    Vision& fixture;
    std::unique_ptr<Board> view;
    AgentContext context;
    Service service{context, contract_from_text("(contract client)").value()};
    Caller caller{context, service};
  };
  static std::string shown(const Result<Datum>& result) {
    if (!result) return result.error().symbol + " " + write(result.error().subject);
    return result->size() == 1 ? std::string((*result)[0].text()) : write(*result);
  }
  static Task<void> tell(Board& teller, Datum fact) {
    const Result<Revision> told = co_await teller.tell(fact);
    EXPECT_TRUE(told.has_value());
  }

  VirtualExecutor executor;
  MemoryBoard board{executor};
  LocalStreams streams;
  FakeCamera camera{executor, 7};
  std::unique_ptr<Board> view = board.view("tester");
  AgentContext context{"tester", "here", executor, *view, Random(2)};
  Service service{context, contract_from_text("(contract tester)").value()};
  Caller caller{context, service};
  std::optional<VisionLife> life;
};

TEST_F(Vision, LearnsFindsAndListsInTheThesisWords) {
  EXPECT_EQ(call("(get-objects)"), R"x((GET 0 ()))x");
  learn_all();
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  const std::string found = call("(find \"Circle\")");
  double x = 0;
  double y = 0;
  ASSERT_EQ(std::sscanf(found.c_str(), R"x((FIND "Circle" OK (%lf, %lf)))x", &x, &y), 2) << found;
  const cv::Point2d truth = project(camera.model(), camera.scene.faces[0].place, false);
  EXPECT_NEAR(x, truth.x, 0.2);
  EXPECT_NEAR(y, truth.y, 0.2);
  EXPECT_EQ(found.substr(found.find('.') + 3, 2), ", ");
  EXPECT_NE(facts("(learned vision \"circle\" 1 ? ? ? ? ? ?)"), "");
}

TEST_F(Vision, LearningANameTwiceKeepsASecondSample) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call(learn_request(0, "CIRCLE")), R"x((LEARN "CIRCLE" OK))x");
  EXPECT_NE(facts("(learned vision \"circle\" 2 ? ? ? ? ? ?)"), "");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
}

TEST_F(Vision, SaysWhyItCouldNotLearn) {
  EXPECT_EQ(call("(learn 500 20 \"circle\")"), R"x((LEARN "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? ? ?)").find("outside the image"), std::string::npos);
  EXPECT_EQ(call("(learn 20 200 \"circle\")"), R"x((LEARN "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? ? ?)").find("even ground"), std::string::npos);
  EXPECT_EQ(call("(learn 20 200 \"cir cle\")"), "bad-name \"cir cle\"");
  EXPECT_EQ(call("(find \"star\")"), R"x((FIND "star" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? ? ?)").find("nothing is learned"), std::string::npos);
  EXPECT_EQ(call("(track \"star\")"), "not-learned \"star\"");
}

TEST_F(Vision, TellsTheReasonOfAFailureAsASymbolAndASentence) {
  EXPECT_EQ(call("(learn 20 200 \"circle\")"), R"x((LEARN "circle" FAIL))x");
  EXPECT_EQ(
      facts("(vision-failed vision ? \"(LEARN \\\"circle\\\" FAIL)\" background ?)").find("(vision-failed vision "),
      0U);
}

TEST_F(Vision, ALearnedSampleMayBeRejectedUntilItIsAccepted) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(facts("(to-accept vision ? ?)"), "(to-accept vision \"circle\" 1)");
  EXPECT_EQ(call("(accept \"Circle\")"), "()");
  EXPECT_EQ(facts("(to-accept vision ? ?)"), "");
  EXPECT_EQ(call("(reject \"circle\")"), "nothing-to-accept \"circle\"");
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(reject \"square\")"), "nothing-to-accept \"square\"");
  EXPECT_EQ(call("(reject \"circle\")"), "()");
  EXPECT_EQ(facts("(learned vision ? 2 ? ? ? ? ? ?)"), "");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
  EXPECT_EQ(call(learn_request(2, "end-effector")), R"x((LEARN "end-effector" OK))x");
  EXPECT_EQ(call("(reject \"end-effector\")"), "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
}

TEST_F(Vision, ObjectsAreRenamedAndForgottenAlsoWhileTheyAreTracked) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(200ms);
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  run_for(300ms);
  EXPECT_NE(says().find("(\"disc\" OK"), std::string::npos) << says();
  EXPECT_NE(facts("(learned vision \"disc\" 1 ? ? ? ? ? ?)"), "");
  EXPECT_EQ(facts("(learned vision \"circle\" ? ? ? ? ? ? ?)"), "");
  EXPECT_EQ(call("(rename \"disc\" \"End-Effector\")"), "name-taken \"End-Effector\"");
  EXPECT_EQ(call("(rename \"disc\" \"a b\")"), "bad-name \"a b\"");
  EXPECT_EQ(call("(rename \"circle\" \"ring\")"), "not-learned \"circle\"");
  EXPECT_EQ(call("(forget \"disc\")"), "()");
  run_for(300ms);
  EXPECT_TRUE(says().ends_with("(\"disc\" FAIL))")) << says();
  EXPECT_EQ(call("(forget \"disc\")"), "not-learned \"disc\"");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("end-effector")))x");
}

TEST_F(Vision, WhatIsRenamedTakesTheTrackOfOneThatWasForgotten) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(200ms);
  EXPECT_EQ(call("(forget \"circle\")"), "()");
  EXPECT_EQ(call("(rename \"end-effector\" \"circle\")"), "()");
  run_for(300ms);
  EXPECT_EQ(says().find("(\"circle\" OK"), says().rfind("\"circle\"") - 1) << says();
}

TEST_F(Vision, WhatIsToBeAcceptedStaysSoBesideOtherChanges) {
  learn_all();
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(forget \"end-effector\")"), "()");
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_EQ(facts("(to-accept vision ? ?)"), "(to-accept vision \"disc\" 2)");
  EXPECT_EQ(call("(reject \"disc\")"), "()");
  EXPECT_EQ(facts("(learned vision \"disc\" 2 ? ? ? ? ? ?)"), "");
  EXPECT_NE(facts("(learned vision \"disc\" 1 ? ? ? ? ? ?)"), "");
  EXPECT_EQ(call(learn_request(0, "disc")), R"x((LEARN "disc" OK))x");
  EXPECT_EQ(call("(forget \"disc\")"), "()");
  EXPECT_EQ(call("(reject \"disc\")"), "nothing-to-accept \"disc\"");
}

// With a database: agent, board and all may go.
class KeptVision : public Vision {
 protected:
  KeptVision() {
    std::filesystem::remove_all(folder);
    live(folder);
  }
  const std::string folder = scratch_folder() + "kept-objects";
};

TEST_F(KeptVision, WhatWasLearnedOutlivesTheBoardsMemoryOfIt) {
  learn_all();
  life.reset();
  run_for(3s);
  retract("(learned vision ? ? ? ? ? ? ? ?)");
  retract("(learned-template vision ? ? ? ? ? ? ? ? ? ?)");
  live(folder);
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  EXPECT_NE(facts("(learned vision \"circle\" 1 ? ? ? ? ? ?)"), "");
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
}

TEST_F(KeptVision, WhatTheDatabaseDoesNotKnowIsTakenFromTheBoard) {
  learn_all();
  ObjectDatabase other = ObjectDatabase::open(folder).value();
  ASSERT_TRUE(other.apply(RenameObject{"circle", "disc"}));
  run_for(2s);
  EXPECT_EQ(facts("(learned vision \"circle\" ? ? ? ? ? ? ?)"), "");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("disc", "end-effector")))x");
  EXPECT_TRUE(call("(find \"disc\")").starts_with(R"x((FIND "disc" OK ()x"));
}

TEST_F(KeptVision, WhatAnotherAgentRenamesIsTrackedOnUnderItsNewName) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(1s);
  ObjectDatabase other = ObjectDatabase::open(folder).value();
  ASSERT_TRUE(other.apply(RenameObject{"circle", "disc"}));
  run_for(2s);
  EXPECT_NE(says().find(R"x(("disc" OK ()x"), std::string::npos) << says();
  EXPECT_EQ(says().find("circle"), std::string::npos) << says();
}

TEST_F(KeptVision, WhatExchangesItsNamesStaysTwo) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(1s);
  ObjectDatabase other = ObjectDatabase::open(folder).value();
  ASSERT_TRUE(other.apply(RenameObject{"circle", "third"}));
  ASSERT_TRUE(other.apply(RenameObject{"end-effector", "circle"}));
  ASSERT_TRUE(other.apply(RenameObject{"third", "end-effector"}));
  run_for(2s);
  EXPECT_NE(says().find("(\"circle\" OK"), std::string::npos) << says();
  EXPECT_NE(says().find("(\"end-effector\" OK"), std::string::npos) << says();
}

TEST_F(KeptVision, AChoiceFollowsItsSampleThroughOtherChanges) {
  learn_all();
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_EQ(facts("(to-accept vision ? ?)"), "(to-accept vision \"end-effector\" 1)");
  EXPECT_EQ(call("(rename \"end-effector\" \"hand\")"), "()");
  EXPECT_EQ(facts("(to-accept vision ? ?)"), "(to-accept vision \"hand\" 1)");
  EXPECT_EQ(call("(reject \"hand\")"), "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("disc")))x");
}

TEST_F(KeptVision, APipeInABitmapsPlaceIsDamageAndHoldsNothingUp) {
  learn_all();
  const std::string bitmap = folder + "/circle-1.pgm";
  std::filesystem::remove(bitmap);
  ASSERT_EQ(::mkfifo(bitmap.c_str(), 0600), 0);
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_NE(facts("(objects-damaged vision ? ? ?)"), "");
  EXPECT_EQ(call("(rename \"end-effector\" \"hand\")"), "()");
}

TEST_F(KeptVision, ADamagedSampleIsSaidOnceAndTheOthersGoOn) {
  learn_all();
  std::filesystem::resize_file(folder + "/circle-1.pgm", 100);
  life.reset();
  run_for(3s);
  live(folder);
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("end-effector")))x");
  EXPECT_EQ(facts("(objects-damaged vision ? ? ?)"),
            "(objects-damaged vision \"circle-1.pgm\" damaged \"the template bitmap is damaged\")");
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("end-effector", "circle")))x");
}

TEST_F(KeptVision, ADatabaseThatIsNoneLeavesWhatTheBoardRemembersAndRefusesToLearn) {
  learn_all();
  life.reset();
  run_for(3s);
  const std::string file = folder + "/objects.sqlite";
  std::filesystem::rename(file, file + ".sound");
  std::ofstream(file) << std::string(4000, 'x');
  live(folder);
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  EXPECT_EQ(facts("(objects-damaged vision \"objects.sqlite\" damaged ?)").find("(objects-damaged"), 0U);
  EXPECT_EQ(call(learn_request(1, "square")), R"x((LEARN "square" FAIL))x");
  EXPECT_EQ(facts("(vision-failed vision ? ? damaged ?)").find("(vision-failed"), 0U);
  // Mended, it is used again.
  std::filesystem::rename(file + ".sound", file);
  run_for(2s);
  EXPECT_EQ(facts("(objects-damaged vision ? ? ?)"), "");
  EXPECT_EQ(call(learn_request(1, "square")), R"x((LEARN "square" OK))x");
}

// Two agents before cameras of their own, which show the circle elsewhere, with one database.
class TwoVisions : public KeptVision {
 protected:
  TwoVisions() {
    other_camera.scene.faces = {{.mark = "circle", .place = {60, 20, 850}}, {.mark = "square", .place = {-60, 0, 850}}};
    other_life.emplace(executor, board, other_camera, &streams, VisionOptions{.objects_directory = folder}, "side");
    run_for(1s);
  }
  std::string call_other(const std::string& operation) { return call(operation, 20s, "side"); }

  FakeCamera other_camera{executor, 8};
  std::optional<VisionLife> other_life;
};

TEST_F(TwoVisions, WhatOneLearnsTheOtherFindsByItsOwnCamera) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  run_for(2s);
  const std::string found = call_other("(find \"circle\")");
  double x = 0;
  double y = 0;
  ASSERT_EQ(std::sscanf(found.c_str(), R"x((FIND "circle" OK (%lf, %lf)))x", &x, &y), 2) << found;
  const cv::Point2d truth = project(other_camera.model(), other_camera.scene.faces[0].place, false);
  EXPECT_NEAR(x, truth.x, 0.5);
  EXPECT_NEAR(y, truth.y, 0.5);
  EXPECT_NE(facts("(found side \"circle\" ? ? ? ? ? ?)"), "");
  EXPECT_EQ(facts("(found vision \"circle\" ? ? ? ? ? ?)"), "");
}

TEST_F(TwoVisions, EachTellsOfItselfAndEndsForItself) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(facts("(to-accept ? ? ?)"), R"((to-accept vision "circle" 1))");
  run_for(2s);
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(facts("(vision-mode ? ? ?)"), "(vision-mode side idle no)\n(vision-mode vision tracking yes)");
  EXPECT_EQ(call_other("(track \"circle\")"), "()");
  run_for(1s);
  EXPECT_EQ(board.ask(query_from_datum(form("(vision-says ?eyes ?frame ?text)")).value())->answers.size(), 2U);
  EXPECT_EQ(call_other("(end-track)"), "()");
  EXPECT_EQ(call_other("(disconnect)"), "()");
  run_for(1s);
  EXPECT_EQ(facts("(vision-says side ? ?)"), "");
  const std::string before = says();
  EXPECT_NE(before, "nothing");
  EXPECT_EQ(facts("(vision-held ? ? ?)"),
            "(vision-held vision tester connected)\n(vision-held vision tester tracking)");
  // Even its death is its own.
  other_life.reset();
  run_for(5s);
  EXPECT_EQ(facts("(vision-mode ? ? ?)"), "(vision-mode vision tracking yes)");
  EXPECT_NE(facts("(tracked vision \"circle\" seen ? ?)"), "");
}

TEST_F(TwoVisions, RejectingLeavesTheSampleThatAnotherHasLearnedUnderTheNameSince) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  run_for(2s);
  EXPECT_EQ(call_other("(forget \"circle\")"), "()");
  const cv::Point2d at = project(other_camera.model(), other_camera.scene.faces[1].place, false);
  EXPECT_EQ(call_other(write(list("learn"_sym, at.x, at.y, "circle"))), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(reject \"circle\")"), "nothing-to-accept \"circle\"");
  EXPECT_EQ(facts("(to-accept ? ? ?)"), R"((to-accept side "circle" 1))");
  EXPECT_EQ(call_other("(get-objects)"), R"x((GET 1 ("circle")))x");
  EXPECT_TRUE(std::filesystem::exists(folder + "/circle-1.pgm"));
}

TEST_F(TwoVisions, WhatIsToBeAcceptedFollowsWhatAnotherDoesWithIt) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  run_for(2s);
  EXPECT_EQ(call_other("(rename \"circle\" \"disc\")"), "()");
  run_for(2s);
  EXPECT_EQ(facts("(to-accept ? ? ?)"), R"((to-accept vision "disc" 1))");
  EXPECT_EQ(call_other("(forget \"disc\")"), "()");
  run_for(2s);
  EXPECT_EQ(facts("(to-accept ? ? ?)"), "");
}

// As a backup is put in the place of what was moved away.
TEST_F(TwoVisions, AnotherDatabaseInItsPlaceIsTakenUpByAll) {
  namespace fs = std::filesystem;
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  run_for(2s);
  const std::string away = folder + "-away";
  fs::remove_all(away);
  fs::rename(folder, away);
  run_for(2s);
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
  EXPECT_EQ(call(learn_request(2, "end-effector")), R"x((LEARN "end-effector" FAIL))x");
  fs::copy(away, folder);
  run_for(2s);
  EXPECT_EQ(facts("(objects-damaged ? ? ? ?)"), "");
  EXPECT_EQ(call(learn_request(2, "end-effector")), R"x((LEARN "end-effector" OK))x");
  EXPECT_EQ(call_other("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  fs::remove_all(away);
}

TEST_F(Vision, TwoWithoutADatabaseRememberEachItsOwn) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  FakeCamera other_camera{executor, 8};
  VisionLife other(executor, board, other_camera, &streams, {}, "side");
  EXPECT_EQ(call("(get-objects)", 20s, "side"), "(GET 0 ())");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
}

TEST_F(Vision, TracksTheEndEffectorFirstAndTellsOnceAFrame) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(250ms);
  const std::string text = says();
  double x[2] = {};
  double y[2] = {};
  double d[2] = {};
  ASSERT_EQ(std::sscanf(text.c_str(), "(TRACK 2 (\"end-effector\" OK (%lf, %lf, %lf)) (\"circle\" OK (%lf, %lf, %lf)))",
                        &x[0], &y[0], &d[0], &x[1], &y[1], &d[1]),
            6)
      << text;
  EXPECT_NEAR(d[0], cv::norm(camera.scene.faces[2].place), 4);
  EXPECT_NEAR(d[1], cv::norm(camera.scene.faces[0].place), 4);
  const std::string one = facts("(vision-says vision ? ?)");
  run_for(100ms);
  EXPECT_NE(facts("(vision-says vision ? ?)"), one);
  camera.scene.faces[0].mark = "none";
  run_for(200ms);
  EXPECT_TRUE(says().ends_with("(\"circle\" FAIL))")) << says();
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(says(), "nothing");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision capturing yes)");
}

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
  const std::string before = facts("(vision-says vision ? ?)");
  run_for(200ms);
  EXPECT_NE(facts("(vision-says vision ? ?)"), before);
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
  jobs.push_back(executor.spawn(other.ask(form("(find \"circle\")"), later[1])));
  jobs.push_back(executor.spawn(ask("vision", form("(find \"square\")"), 20s, later[2])));
  jobs.push_back(executor.spawn(other.ask(form("(rename \"square\" \"box\")"), later[3])));
  EXPECT_EQ(call("(get-objects)"), R"x((GET 0 ()))x");
  executor.run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
  EXPECT_EQ(learned, R"x((LEARN "circle" OK))x");
  EXPECT_EQ(later[0], R"x((LEARN "square" OK))x");
  EXPECT_TRUE(later[1].starts_with(R"x((FIND "circle" OK ()x")) << later[1];
  EXPECT_TRUE(later[2].starts_with(R"x((FIND "square" OK ()x")) << later[2];
  EXPECT_EQ(later[3], "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "box")))x");
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

// A script that only tells requests has no presence: what it began lasts until someone ends it.
TEST_F(Vision, WhatAClientWithoutPresenceBeganAnyoneMayEnd) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  const std::unique_ptr<Board> script = board.view("script");
  const Job telling = executor.spawn(tell(*script, form("(request r1 vision (track \"circle\"))")));
  run_for(6s);
  EXPECT_EQ(facts("(vision-held vision ? ?)"),
            "(vision-held vision anybody connected)\n(vision-held vision anybody tracking)");
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision capturing yes)");
}

TEST_F(Vision, DisconnectedItCapturesOnlyWhileItMust) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  run_for(300ms);
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
  EXPECT_EQ(facts("(camera-state vision ? ?)"), "(camera-state vision closed \"\")");
  EXPECT_EQ(call("(connect)"), "()");
  run_for(300ms);
  EXPECT_EQ(facts("(camera-state vision ? ?)"), "(camera-state vision open \"\")");
  EXPECT_EQ(facts("(camera-model vision ? ? ? ? ? ?)"), "(camera-model vision 320 240 431.0 159.5 119.5 90.0)");
  EXPECT_EQ(call("(disconnect)"), "()");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
}

TEST_F(Vision, ARestartedAgentKnowsWhatWasLearnedAndTracksNothing) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(300ms);
  life.reset();
  run_for(3s);
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "");
  EXPECT_EQ(facts("(vision-says vision ? ?)"), "");
  live();
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
}

TEST_F(Vision, ImagesOfASizeThatDoesNotWorkAreRefusedWithTheSizesThatDo) {
  camera.plugged = false;
  run_for(1s);
  camera.resize(60, 60);
  camera.plugged = true;
  call("(connect)");
  run_for(6s);
  EXPECT_EQ(facts("(camera-state vision ? ?)"),
            "(camera-state vision lost \"the camera's images are 60x60, and what works is 64x64 to 8192x8192\")");
}

TEST_F(Vision, ALostCameraIsSaidAndTriedAgain) {
  EXPECT_EQ(call("(connect)"), "()");
  run_for(300ms);
  camera.plugged = false;
  run_for(5s);
  EXPECT_TRUE(facts("(camera-state vision ? ?)").starts_with("(camera-state vision lost \"the camera is unplugged"));
  EXPECT_LT(camera.opened, 9);
  EXPECT_EQ(call("(learn 100 100 \"circle\")"), R"x((LEARN "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? ? ?)").find("unplugged"), std::string::npos);
  camera.plugged = true;
  run_for(6s);
  EXPECT_EQ(facts("(camera-state vision ? ?)"), "(camera-state vision open \"\")");
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
}

TEST_F(Vision, ALostCameraLeavesNoOldPositionsAndTrackingGoesOnWhenItIsBack) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(300ms);
  EXPECT_NE(says(), "nothing");
  camera.plugged = false;
  run_for(300ms);
  EXPECT_EQ(says(), "nothing");
  camera.plugged = true;
  run_for(2s);
  EXPECT_TRUE(says().starts_with(R"x((TRACK 1 ("circle" OK ()x")) << says();
}

TEST_F(Vision, PublishesImagesWhileTheyAreWatched) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  int grey = 0;
  std::map<std::string, int> channels;
  std::shared_ptr<const Image> annotated;
  {
    const auto left = streams.subscribe("vision-left", [&](const StreamFrame& f) { grey += f.image->channels == 1; });
    std::vector<std::unique_ptr<Streams::Subscription>> others;
    for (const std::string kind : {"colour", "grey", "right"}) {
      others.push_back(streams.subscribe(
          "vision-" + kind, [&channels, kind](const StreamFrame& f) { channels[kind] = f.image->channels; }));
    }
    const auto shown = streams.subscribe("vision-annotated", [&](const StreamFrame& f) { annotated = f.image; });
    run_for(350ms);
  }
  EXPECT_EQ(grey, 3);
  EXPECT_EQ(facts("(stream ? annotated ?)"), "(stream vision-annotated annotated ())");
  EXPECT_EQ(channels, (std::map<std::string, int>{{"colour", 3}, {"grey", 1}, {"right", 1}}));
  ASSERT_NE(annotated, nullptr);
  EXPECT_EQ(annotated->channels, 3);
  EXPECT_EQ(annotated->width, 640);
  run_for(300ms);
  EXPECT_EQ(grey, 3);
}

TEST_F(Vision, SaysHowSureAFindIsAndWhereElseOneLikeItIs) {
  learn_all();
  EXPECT_EQ(call(learn_request(1, "square")), R"x((LEARN "square" OK))x");
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
  EXPECT_NE(facts("(and (found vision \"circle\" ?f ?c \"square\" ?m () ?places) (> ?c 0.9) (> ?m 0.03))"), "");
  const std::string found = facts("(found vision \"circle\" ? ? ? ? ? ?)");
  EXPECT_NE(found.find("((left "), std::string::npos) << found;
  EXPECT_NE(found.find("(right "), std::string::npos) << found;
  EXPECT_NE(found.find("(range 8"), std::string::npos) << found;
  camera.scene.faces[1].mark = "circle";
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
  EXPECT_EQ(facts("(found vision \"circle\" ? ? ? ? () ?)"), "");
}

TEST_F(Vision, TellsWhenAnObjectIsLostAndSeenAgain) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(250ms);
  EXPECT_EQ(facts("(tracked vision \"circle\" seen ? ?)").find("(tracked vision \"circle\" seen "), 0U);
  const std::string first = facts("(tracked vision \"circle\" ? ? ?)");
  run_for(300ms);
  EXPECT_EQ(facts("(tracked vision \"circle\" ? ? ?)"), first);
  camera.scene.faces[0].mark = "none";
  run_for(250ms);
  EXPECT_NE(facts("(tracked vision \"circle\" bridged ? ?)"), "");
  EXPECT_TRUE(says().ends_with("(\"circle\" FAIL))")) << says();
  run_for(600ms);
  EXPECT_NE(facts("(tracked vision \"circle\" lost ? ?)"), "");
  camera.scene.faces[0].mark = "circle";
  run_for(250ms);
  EXPECT_NE(facts("(tracked vision \"circle\" seen ? ?)"), "");
  EXPECT_NE(facts("(tracked vision \"circle\" seen ? ?)"), first);
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(facts("(tracked vision ? ? ? ?)"), "");
  EXPECT_EQ(facts("(sightings vision ? ?)"), "");
  EXPECT_EQ(facts("(faces vision ? ?)"), "");
}

TEST_F(Vision, WhatIsFollowedNoLongerIsNotSaidToBeSeen) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(call("(track \"end-effector\")"), "()");
  run_for(250ms);
  EXPECT_NE(facts("(tracked vision \"circle\" seen ? ?)"), "");
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  run_for(250ms);
  EXPECT_EQ(facts("(tracked vision \"circle\" ? ? ?)"), "");
  EXPECT_NE(facts("(tracked vision \"disc\" seen ? ?)"), "");
  EXPECT_EQ(call("(rename \"disc\" \"circle\")"), "()");
  run_for(250ms);
  EXPECT_EQ(facts("(tracked vision \"disc\" ? ? ?)"), "");
  EXPECT_NE(facts("(tracked vision \"circle\" seen ? ?)"), "");
}

// Colour is asked of the camera, and pictures are drawn, only for those who look.
TEST_F(Vision, SendsEachImageOnlyWhileSomeoneWatchesThatKind) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(500ms);
  EXPECT_EQ(camera.colour_asked, 0);
  for (const std::string kind : {"left", "right", "grey", "colour", "annotated"}) {
    SCOPED_TRACE(kind);
    std::map<std::string, int> sent;
    const int colours = camera.colour_asked;
    {
      const auto watching = streams.subscribe("vision-" + kind, [&](const StreamFrame&) { ++sent[kind]; });
      run_for(350ms);
    }
    EXPECT_GE(sent[kind], 3);
    EXPECT_EQ(camera.colour_asked > colours, kind == "colour" || kind == "annotated");
    const int before = sent[kind];
    const int colours_before = camera.colour_asked;
    run_for(300ms);
    EXPECT_EQ(sent[kind], before);
    EXPECT_EQ(camera.colour_asked, colours_before);
  }
}

}  // namespace
}  // namespace pizarra
