#include <fmt/format.h>

#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

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
  EXPECT_NE(facts("(vision-failed vision ? ? ? ?)").find("on the ground"), std::string::npos);
  EXPECT_EQ(call("(learn 20 200 \"cir cle\")"), "bad-name \"cir cle\"");
  EXPECT_EQ(call("(find \"star\")"), R"x((FIND "star" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? ? ?)").find("nothing is learned"), std::string::npos);
  EXPECT_EQ(call("(track \"star\")"), "not-learned \"star\"");
}

TEST_F(Vision, AReplyThatSaysFailGivesTheReasonThatIsTold) {
  Result<Datum> reply;
  for (const char* operation : {"(learn 500 20 \"circle\")", "(find \"star\")"}) {
    const Job job = executor.spawn([](runtime::Caller& asking, Datum asked, Result<Datum>& answer) -> Task<void> {
      answer = co_await asking.call("vision", asked, 20s);
    }(caller, form(operation), reply));
    executor.run_until([&] { return job.done(); });
    ASSERT_TRUE(reply && gives_reason(*reply)) << operation;
    EXPECT_NE(facts(fmt::format("(vision-failed vision ? {} {} {})", write((*reply)[0]), write((*reply)[1]),
                                write((*reply)[2]))),
              "");
  }
}

// Else a reply could be made to say what was never seen.
TEST_F(Vision, NamesAreCheckedAtTheDoorWhateverIsAsked) {
  learn_all();
  const std::string forged = R"x("a\" OK (1, 2)) (FIND \"b")x";
  const std::vector<std::string> none = {forged, R"("../evil")", R"("line\nbreak")", R"("")"};
  for (const std::string& name : none) {
    for (const char* word : {"find", "track", "accept", "reject", "forget"}) {
      EXPECT_EQ(call("(" + std::string(word) + " " + name + ")"), "bad-name " + name) << word;
    }
    EXPECT_EQ(call("(learn 20 200 " + name + ")"), "bad-name " + name);
    EXPECT_EQ(call("(rename " + name + " \"disc\")"), "bad-name " + name);
    EXPECT_EQ(call("(rename \"circle\" " + name + ")"), "bad-name " + name);
  }
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
}

// Anyone may tell the facts in which the board remembers what was learned.
TEST_F(Vision, AFactOfANameThatIsNoneIsNotRecalled) {
  learn_all();
  for (const char* pattern :
       {"(learned vision \"circle\" ? ? ? ? ? ? ?)", "(learned-focal vision \"circle\" ? ?)",
        "(learned-template vision \"circle\" ? ? ? ? ? ? ? ? ?)", "(learned-print vision \"circle\" ? ?)"}) {
    std::string fact = facts(pattern);
    tell(form(fact.replace(fact.find("circle"), 6, R"(a\" OK)")));
  }
  life.reset();
  run_for(3s);
  live();
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  EXPECT_NE(facts("(objects-damaged vision \"a\\\" OK\" ? ?)"), "");
}

TEST_F(Vision, TellsTheReasonOfAFailureAsASymbolAndASentence) {
  EXPECT_EQ(call("(learn 20 200 \"circle\")"), R"x((LEARN "circle" FAIL))x");
  EXPECT_EQ(
      facts("(vision-failed vision ? \"(LEARN \\\"circle\\\" FAIL)\" background ?)").find("(vision-failed vision "),
      0U);
}

TEST_F(Vision, SaysThatMoreIsInTheImageThanIsLookedAt) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  camera.scene.faces.clear();
  for (int i = 0; i < 140; ++i) {
    const int row = i / 14;
    camera.scene.blots.push_back({.box = {20.0 + i % 14 * 20, 20.0 + row * 20, 10, 10}, .level = 20});
  }
  EXPECT_EQ(call("(find \"circle\")"), R"x((FIND "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? crowded ?)").find("only the 128 largest were looked at, and 12 smaller"),
            std::string::npos)
      << facts("(vision-failed vision ? ? ? ?)");
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

TEST_F(Vision, WhatWasFoundGoesByItsNewNameAndNotBeyondWhatIsKnown) {
  learn_all();
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
  EXPECT_TRUE(call("(find \"end-effector\")").starts_with(R"x((FIND "end-effector" OK ()x"));
  const std::string found = facts("(found vision \"circle\" ? ? ? ? ? ?)");
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_EQ(facts("(found vision \"circle\" ? ? ? ? ? ?)"), "");
  const std::string renamed = facts("(found vision \"disc\" ? ? ? ? ? ?)");
  EXPECT_EQ(renamed.substr(renamed.find("disc") + 4), found.substr(found.find("circle") + 6));
  EXPECT_EQ(call("(reject \"end-effector\")"), "()");
  EXPECT_EQ(facts("(found vision ? ? ? ? ? ? ?)"), renamed);
  EXPECT_EQ(call("(forget \"disc\")"), "()");
  EXPECT_EQ(facts("(found vision ? ? ? ? ? ? ?)"), "");
}

TEST_F(Vision, WhatWasFoundNamesNoSecondThatIsNotKnownAnyMore) {
  for (const auto& [face, name] : {std::pair(0, "circle"), std::pair(1, "square")}) {
    EXPECT_NE(call(learn_request(static_cast<std::size_t>(face), name)).find("OK"), std::string::npos);
  }
  const std::string seconds_square = "(found vision \"circle\" ? ? \"square\" ? ? ?)";
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
  EXPECT_NE(facts(seconds_square), "");
  EXPECT_EQ(call("(rename \"square\" \"box\")"), "()");
  EXPECT_EQ(facts(seconds_square), "");
  EXPECT_NE(facts("(found vision \"circle\" ? ? \"box\" ? ? ?)"), "");
  EXPECT_EQ(call("(forget \"box\")"), "()");
  EXPECT_EQ(facts("(found vision ? ? ? ? ? ? ?)"), "");
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
  const std::string one = facts("(look vision ? ? ?)");
  run_for(100ms);
  EXPECT_NE(facts("(look vision ? ? ?)"), one);
  camera.scene.faces[0].mark = "none";
  run_for(200ms);
  EXPECT_TRUE(says().ends_with("(\"circle\" FAIL))")) << says();
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(says(), "nothing");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision capturing yes)");
}

TEST_F(Vision, ARestartedAgentKnowsWhatWasLearnedAndTracksNothing) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(300ms);
  life.reset();
  run_for(3s);
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "");
  EXPECT_EQ(facts("(look vision ? ? ?)"), "");
  live();
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
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

TEST_F(Vision, OfTwoThatAreEqualFindsTheOneWhereItWasFoundLast) {
  learn_all();
  const cv::Point2d left = project(camera.model(), camera.scene.faces[0].place, false);
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
  camera.scene.faces[1] = camera.scene.faces[0];
  camera.scene.faces[1].place.x = 20;
  for (int i = 0; i < 12; ++i) {
    double x = 0;
    double y = 0;
    const std::string found = call("(find \"circle\")");
    ASSERT_EQ(std::sscanf(found.c_str(), R"x((FIND "circle" OK (%lf, %lf)))x", &x, &y), 2) << found;
    EXPECT_NEAR(x, left.x, 1);
    // That there is another is said.
    EXPECT_EQ(facts("(found vision \"circle\" ? ? ? ? () ?)"), "");
  }
}

TEST_F(Vision, SaysOfWhatAMarkIsAsMuchLike) {
  learn_all();
  const Datum learned = form(facts("(learned vision \"circle\" ? ? ? ? ? ? ?)"));
  const Datum picture = form(facts("(learned-template vision \"circle\" ? ? ? ? ? ? ? ? ?)"));
  life.reset();
  // A cell's facts may have been put together by hand.
  for (const Datum& fact : {learned, picture}) {
    std::vector<Datum> items(fact.items().begin(), fact.items().end());
    items[2] = to_datum("ball");
    tell(Datum::list(std::move(items)));
  }
  live();
  EXPECT_EQ(call("(find \"circle\")"), R"x((FIND "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? ambiguous ?)").find("a mark looks like it, and as much like ball"),
            std::string::npos)
      << facts("(vision-failed vision ? ? ? ?)");
}

TEST_F(Vision, SaysThatWhatIsLikeItIsOfAnotherSizeThanIsLookedFor) {
  // Learned nearer, so that what is far too small is still some ten pixels high.
  const auto put_at = [&](double scale) { camera.scene.faces[0].place = {-122 / scale, 0, 740 / scale}; };
  put_at(1);
  learn_all();
  const auto find_at = [&](double scale) {
    put_at(scale);
    EXPECT_EQ(call("(find \"circle\")"), R"x((FIND "circle" FAIL))x");
    return facts("(vision-failed vision ? ? ? ?)");
  };
  const std::string large = find_at(3.0);
  EXPECT_NE(large.find("too-large"), std::string::npos) << large;
  EXPECT_NE(large.find("3.0 times as high as it was learned"), std::string::npos) << large;
  const std::string small = find_at(0.34);
  EXPECT_NE(small.find("too-small"), std::string::npos) << small;
  camera.scene.faces.clear();
  EXPECT_EQ(call("(find \"circle\")"), R"x((FIND "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? not-seen ?)").find("no mark in the image is like it"), std::string::npos);
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
  EXPECT_EQ(facts("(look vision ? ? ?)"), "");
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

}  // namespace
}  // namespace pizarra::vision
