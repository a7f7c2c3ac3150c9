// Only its learner can accept or take back a newly learned object, and nobody else has it meanwhile.

#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {
namespace {

class Accepting : public Vision {
 protected:
  Accepting() { EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x"); }
  std::string to_accept() { return facts("(to-accept vision ? ?)"); }
};

TEST_F(Accepting, AnothersNewSampleIsNeitherTakenBackNorAcceptedNorForgottenNorRenamed) {
  Client other(*this, "other");
  EXPECT_EQ(other.call("(reject \"Circle\")"), "busy tester");
  EXPECT_EQ(other.call("(accept \"circle\")"), "busy tester");
  EXPECT_EQ(other.call("(forget \"circle\")"), "busy tester");
  EXPECT_EQ(other.call("(rename \"circle\" \"disc\")"), "busy tester");
  EXPECT_EQ(to_accept(), "(to-accept vision \"circle\" 1)");
  EXPECT_EQ(call("(reject \"circle\")"), "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 0 ()))x");
}

TEST_F(Accepting, WhatWasAcceptedAnyoneMayForget) {
  Client other(*this, "other");
  EXPECT_EQ(call("(accept \"circle\")"), "()");
  EXPECT_EQ(other.call("(reject \"circle\")"), "nothing-to-accept \"circle\"");
  EXPECT_EQ(other.call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_EQ(other.call("(forget \"disc\")"), "()");
}

TEST_F(Accepting, EachClientJudgesWhatItLearnedItself) {
  Client other(*this, "other");
  EXPECT_EQ(other.call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(to_accept(), "(to-accept vision \"circle\" 1)\n(to-accept vision \"circle\" 2)");
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "busy other");
  EXPECT_EQ(call("(reject \"circle\")"), "()");
  EXPECT_EQ(to_accept(), "(to-accept vision \"circle\" 2)");
  EXPECT_EQ(other.call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_EQ(to_accept(), "(to-accept vision \"disc\" 2)");
  EXPECT_EQ(other.call("(reject \"disc\")"), "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 0 ()))x");
}

TEST_F(Accepting, AClientsNextLearningAcceptsItsLast) {
  EXPECT_EQ(call(learn_request(1, "square")), R"x((LEARN "square" OK))x");
  EXPECT_EQ(to_accept(), "(to-accept vision \"square\" 1)");
  EXPECT_EQ(call("(reject \"circle\")"), "nothing-to-accept \"circle\"");
}

TEST_F(Accepting, WhoDiedLeavesItToOthers) {
  Client other(*this, "other");
  {
    Client dying(*this, "dying");
    EXPECT_EQ(dying.call(learn_request(1, "square")), R"x((LEARN "square" OK))x");
  }
  EXPECT_EQ(other.call("(reject \"square\")"), "busy dying");
  run_for(3s);
  EXPECT_EQ(other.call("(reject \"square\")"), "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("circle")))x");
}

TEST_F(Accepting, WhoSaysNothingForAMinuteLeavesItToOthers) {
  Client other(*this, "other");
  run_for(58s);
  EXPECT_EQ(other.call("(reject \"circle\")"), "busy tester");
  run_for(3s);
  EXPECT_EQ(other.call("(reject \"circle\")"), "()");
  EXPECT_EQ(call("(reject \"circle\")"), "nothing-to-accept \"circle\"");
}

}  // namespace
}  // namespace pizarra::vision
