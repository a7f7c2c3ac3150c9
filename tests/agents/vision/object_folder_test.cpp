// What is learned, kept in a folder: agent, board and all may go, and several agents may use one.

#include <filesystem>
#include <fstream>
#include <sys/stat.h>

#include "agents/vision/database/object_database.hpp"
#include "tests/agents/vision/vision_life.hpp"
#include "tests/scratch.hpp"

namespace pizarra::vision {
namespace {

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
  retract("(learned-focal vision ? ? ?)");
  retract("(learned-print vision ? ? ?)");
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
  EXPECT_EQ(call("(find \"Circle\")"), R"x((FIND "Circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? damaged ?)").find("circle-1.pgm: the template bitmap is damaged"),
            std::string::npos);
  EXPECT_EQ(call("(track \"circle\")"), "damaged \"circle\"");
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("end-effector", "circle")))x");
}

TEST_F(KeptVision, NamesThatAreNoneInACopiedDatabaseAreSaidToBeDamageAndLeadNowhere) {
  learn_all();
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(raw.run("UPDATE samples SET name = '../evil' WHERE name = 'circle'"));
  const std::string outside = scratch_folder() + "evil-1.pgm";
  std::filesystem::copy_file(folder + "/circle-1.pgm", outside, std::filesystem::copy_options::overwrite_existing);
  run_for(2s);
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("end-effector")))x");
  EXPECT_NE(facts("(objects-damaged vision \"objects.sqlite, row 1\" damaged ?)"), "");
  EXPECT_EQ(call("(forget \"../evil\")"), "bad-name \"../evil\"");
  EXPECT_TRUE(std::filesystem::exists(outside));
}

// A damaged object takes no place, so that another comes in its own; mended, one is too many.
TEST_F(KeptVision, WhatIsBeyondTheBoundIsSaidToBeSoAndKnownWhenAnotherIsForgotten) {
  learn_all();
  ObjectDatabase other = ObjectDatabase::open(folder).value();
  const LearnedSample sample = other.read()->objects.find("circle")->samples.front();
  for (std::size_t i = 2; i < most_objects; ++i) {
    ASSERT_TRUE(other.apply(KeepSample{"further-" + std::to_string(i), sample}));
  }
  const std::string bitmap = folder + "/circle-1.pgm";
  std::filesystem::copy_file(bitmap, bitmap + ".sound");
  std::filesystem::resize_file(bitmap, 100);
  ASSERT_TRUE(other.apply(KeepSample{"last", sample}));
  std::filesystem::rename(bitmap + ".sound", bitmap);
  run_for(2s);
  EXPECT_NE(facts("(objects-damaged vision \"last-1.pgm\" full ?)"), "");
  EXPECT_EQ(call("(track \"last\")"), "full \"last\"");
  EXPECT_EQ(call("(forget \"further-2\")"), "()");
  EXPECT_EQ(facts("(objects-damaged vision ? ? ?)"), "");
  EXPECT_EQ(call("(track \"last\")"), "()");
}

TEST_F(KeptVision, WhileAnotherHasTheDatabaseWhatIsKnownIsAnsweredAtOnce) {
  learn_all();
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(raw.run("BEGIN EXCLUSIVE; DELETE FROM samples WHERE name = 'circle'"));
  run_for(3s);
  const Time asked = executor.now();
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("circle", "end-effector")))x");
  EXPECT_LT(executor.now() - asked, 50ms);
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
  EXPECT_LT(executor.now() - asked, 700ms);
  EXPECT_EQ(facts("(objects-damaged vision ? ? ?)"), "");
  ASSERT_TRUE(raw.run("COMMIT"));
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("end-effector")))x");
}

// As a failing disk does, or who restores a copy with its times.
TEST(FileStates, TellOfAFileThatChangedAndKeptItsSizeAndItsTimeOfWriting) {
  const std::filesystem::path file = scratch_folder() + "kept-time.pgm";
  std::ofstream(file) << "sound";
  FileStates states;
  states.note(file);
  EXPECT_TRUE(states.unchanged());
  const auto written = std::filesystem::last_write_time(file);
  std::fstream(file, std::ios::in | std::ios::out) << "s0und";
  std::filesystem::last_write_time(file, written);
  EXPECT_FALSE(states.unchanged());
}

TEST_F(KeptVision, ABitmapThatIsDamagedWhileTheAgentRunsIsSaidAndKnownAgainWhenItIsMended) {
  learn_all();
  const std::string bitmap = folder + "/circle-1.pgm";
  std::filesystem::copy_file(bitmap, bitmap + ".sound");
  std::filesystem::resize_file(bitmap, 100);
  run_for(2s);
  EXPECT_EQ(facts("(objects-damaged vision ? ? ?)"),
            "(objects-damaged vision \"circle-1.pgm\" damaged \"the template bitmap is damaged\")");
  EXPECT_TRUE(call("(find \"end-effector\")").starts_with(R"x((FIND "end-effector" OK ()x"));
  std::filesystem::rename(bitmap + ".sound", bitmap);
  run_for(2s);
  EXPECT_EQ(facts("(objects-damaged vision ? ? ?)"), "");
  EXPECT_TRUE(call("(find \"circle\")").starts_with(R"x((FIND "circle" OK ()x"));
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

TEST_F(TwoVisions, WhatOneForgetsTheOtherFindsNoMore) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  run_for(2s);
  EXPECT_NE(call_other("(find \"circle\")").find("OK"), std::string::npos);
  EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
  EXPECT_NE(call_other("(find \"disc\")").find("OK"), std::string::npos);
  EXPECT_EQ(call("(forget \"disc\")"), "()");
  EXPECT_EQ(call_other("(find \"disc\")"), R"x((FIND "disc" FAIL))x");
  EXPECT_NE(facts("(vision-failed side ? ? not-learned ?)"), "");
}

TEST_F(TwoVisions, EachTellsOfItselfAndEndsForItself) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(facts("(to-accept ? ? ?)"), R"((to-accept vision "circle" 1))");
  run_for(2s);
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(facts("(vision-mode ? ? ?)"), "(vision-mode side idle no)\n(vision-mode vision tracking yes)");
  EXPECT_EQ(call_other("(track \"circle\")"), "()");
  run_for(1s);
  EXPECT_EQ(board.ask(query_from_datum(form("(look ?eyes ?frame ?text ?of)")).value())->answers.size(), 2U);
  EXPECT_EQ(call_other("(end-track)"), "()");
  EXPECT_EQ(call_other("(disconnect)"), "()");
  run_for(1s);
  EXPECT_EQ(facts("(look side ? ? ?)"), "");
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

}  // namespace
}  // namespace pizarra::vision
