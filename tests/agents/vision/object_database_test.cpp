#include "agents/vision/database/object_database.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/agents/vision/eyes.hpp"
#include "tests/scratch.hpp"

namespace pizarra::vision {
namespace {

namespace fs = std::filesystem;

class Database : public testing::Test {
 protected:
  std::string folder() const { return (room / "objects").string(); }
  ObjectDatabase open() { return ObjectDatabase::open(folder()).value(); }
  static KeepSample keep(const std::string& name) { return {name, learned_cell().find(name)->samples.front()}; }
  void learn(const std::vector<std::string>& names) {
    ObjectDatabase database = open();
    for (const std::string& name : names) ASSERT_TRUE(database.apply(keep(name)));
  }
  // As older versions did.
  void learn_along_y(const std::vector<std::string>& names) {
    ObjectDatabase database = open();
    for (const std::string& name : names) {
      KeepSample old = keep(name);
      old.sample.size_by = LearnedSample::SizeBy::measured;
      old.sample.focal_px = 0;
      old.sample.contrast = 0;
      ASSERT_TRUE(database.apply(old));
    }
  }
  // What is there, `name*samples`, and what is damaged, `!file`.
  std::string content() {
    const KeptObjects kept = open().read().value();
    std::string out;
    for (const LearnedObject& object : kept.objects.all()) {
      out += object.name + "*" + std::to_string(object.samples.size()) + " ";
    }
    for (const auto& [object, why] : kept.damaged) out += "!" + std::string(why.subject.text()) + " ";
    return out;
  }
  std::vector<std::string> files() {
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(folder())) out.push_back(entry.path().filename().string());
    std::ranges::sort(out);
    return out;
  }
  // Changes one byte of a file.
  void damage(const fs::path& file, std::streamoff at) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(at);
    const char was = static_cast<char>(stream.get());
    stream.seekp(at);
    stream.put(static_cast<char>(was ^ 0x55));
  }

  Database() {
    fs::remove_all(room);
    fs::create_directories(room);
  }
  const fs::path room = fs::path(scratch_folder()) / "database";
};

TEST_F(Database, GivesBackExactlyWhatItWasGiven) {
  learn(cell_marks());
  const KeptObjects kept = open().read().value();
  EXPECT_TRUE(kept.damaged.empty());
  ASSERT_EQ(kept.objects.all().size(), cell_marks().size());
  EXPECT_EQ(facts_of(kept.objects), facts_of(learned_cell()));
}

// A folder's name is whatever bytes a file system takes.
TEST_F(Database, InAFolderWhoseNameIsNoTextKeepsObjectsAndSaysWhatIsWrong) {
  const std::string odd = (room / "f\xFCr\x1b[31m").string();
  ASSERT_TRUE(ObjectDatabase::open(odd).value().apply(keep("circle")));
  EXPECT_EQ(ObjectDatabase::open(odd).value().read().value().objects.all().size(), 1u);
  const Result<ObjectDatabase> gone = ObjectDatabase::open_again(odd + "/nowhere");
  ASSERT_FALSE(gone);
  EXPECT_TRUE(is_string_text(gone.error().subject.text()));
  std::ofstream(room / "\xFF") << "no folder";
  const Result<ObjectDatabase> none = ObjectDatabase::open((room / "\xFF/objects").string());
  ASSERT_FALSE(none);
  EXPECT_EQ(describe(none.error()).find('\xFF'), std::string::npos);
  EXPECT_TRUE(is_string_text(describe(failure_from_datum(failure_to_datum(none.error())))));
}

TEST_F(Database, KeepsSeveralSamplesUnderTheFirstSpelling) {
  learn({"circle", "circle", "square"});
  ObjectDatabase database = open();
  ASSERT_TRUE(database.apply(KeepSample{"CIRCLE", learned_cell().find("circle")->samples.front()}));
  EXPECT_EQ(content(), "circle*3 square*1 ");
  EXPECT_EQ(files(), (std::vector<std::string>{"circle-1.pgm", "circle-2.pgm", "circle-3.pgm", "objects.sqlite",
                                               "square-1.pgm"}));
}

// Another agent may have kept one of the same name before anything is read again.
TEST_F(Database, SaysWhichRowItHasMade) {
  ObjectDatabase one = open();
  ObjectDatabase other = open();
  const Result<std::int64_t> ours = one.apply(keep("circle"));
  const Result<std::int64_t> theirs = other.apply(keep("circle"));
  ASSERT_TRUE(ours);
  ASSERT_TRUE(theirs);
  const KeptObjects kept = one.read().value();
  const std::vector<LearnedSample>& samples = kept.objects.find("circle")->samples;
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].id, *ours);
  EXPECT_EQ(samples[1].id, *theirs);
  EXPECT_EQ(one.apply(RenameObject{"circle", "disc"}).value(), 0);
}

TEST_F(Database, RenamesForgetsAndWithdrawsWithTheBitmaps) {
  learn({"circle", "circle", "square"});
  ObjectDatabase database = open();
  ASSERT_TRUE(database.apply(RenameObject{"Circle", "disc"}));
  const std::int64_t second = database.read().value().objects.find("disc")->samples[1].id;
  ASSERT_TRUE(database.apply(WithdrawSample{"DISC", 2, second}));
  EXPECT_EQ(database.apply(WithdrawSample{"DISC", 2, second}).error().symbol, "not-learned");
  ASSERT_TRUE(database.apply(ForgetObject{"square"}));
  EXPECT_EQ(content(), "disc*1 ");
  EXPECT_EQ(files(), (std::vector<std::string>{"disc-1.pgm", "objects.sqlite"}));
  EXPECT_EQ(database.apply(ForgetObject{"square"}).error().symbol, "not-learned");
  learn({"square"});
  EXPECT_EQ(database.apply(RenameObject{"square", "Disc"}).error().symbol, "name-taken");
  EXPECT_TRUE(database.apply(RenameObject{"disc", "Disc"}));
  EXPECT_EQ(content(), "Disc*1 square*1 ");
}

TEST_F(Database, ARenameThatCannotWriteItsBitmapChangesNothing) {
  learn({"circle", "circle", "square"});
  // Where the second bitmap would go something else stands.
  fs::create_directories(fs::path(folder()) / "disc-2.pgm" / "in-the-way");
  ObjectDatabase database = open();
  const Result<std::int64_t> renamed = database.apply(RenameObject{"circle", "disc"});
  ASSERT_FALSE(renamed.has_value());
  EXPECT_EQ(renamed.error().symbol, "cannot-write");
  EXPECT_EQ(content(), "circle*2 square*1 ");
}

TEST_F(Database, WhatIsDamagedStaysSoUnderANewName) {
  learn({"circle", "circle", "square"});
  damage(fs::path(folder()) / "circle-1.pgm", 100);
  fs::remove(fs::path(folder()) / "circle-2.pgm");
  EXPECT_EQ(content(), "square*1 !circle-1.pgm !circle-2.pgm ");
  ASSERT_TRUE(open().apply(RenameObject{"circle", "disc"}));
  EXPECT_EQ(content(), "square*1 !disc-1.pgm !disc-2.pgm ");
}

TEST_F(Database, RemembersThatASizeIsAGuess) {
  KeepSample guessed = keep("circle");
  guessed.sample.size_by = LearnedSample::SizeBy::guessed_face;
  ASSERT_TRUE(open().apply(guessed));
  learn({"square"});
  const KeptObjects kept = open().read().value();
  ASSERT_TRUE(kept.damaged.empty());
  EXPECT_TRUE(kept.objects.find("circle")->samples.front().size_guessed());
  EXPECT_FALSE(kept.objects.find("square")->samples.front().size_guessed());
}

TEST_F(Database, RemembersByWhichFocalLengthASampleWasLearnedAndThatOlderFormatsDidNotSay) {
  learn_along_y({"circle"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(
      raw.run("ALTER TABLE samples DROP COLUMN axis; ALTER TABLE samples DROP COLUMN contrast; ALTER TABLE samples "
              "DROP COLUMN focal; ALTER TABLE samples "
              "RENAME COLUMN size_by TO guessed;"
              "PRAGMA user_version = 3"));
  learn({"square"});
  const KeptObjects kept = open().read().value();
  ASSERT_TRUE(kept.damaged.empty());
  EXPECT_EQ(kept.objects.find("circle")->samples.front().focal_px, 0);
  EXPECT_EQ(kept.objects.find("square")->samples.front().focal_px, DrawnSight::model().focal_px);
}

TEST_F(Database, RemembersHowBoldAPrintWasAndThatTheFourthFormatDidNotSay) {
  KeepSample old = keep("circle");
  old.sample.contrast = 0;
  ASSERT_TRUE(open().apply(old));
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(raw.run(
      "ALTER TABLE samples DROP COLUMN axis; ALTER TABLE samples DROP COLUMN contrast; PRAGMA user_version = 4"));
  learn({"square"});
  const KeptObjects kept = open().read().value();
  ASSERT_TRUE(kept.damaged.empty());
  EXPECT_EQ(kept.objects.find("circle")->contrast(), 0);
  EXPECT_EQ(kept.objects.find("square")->contrast(), keep("square").sample.contrast);
  EXPECT_GT(kept.objects.find("square")->contrast(), 1);
}

TEST_F(Database, RemembersHowASlimMarkLiesAndThatTheFifthFormatDidNotSay) {
  learn({"circle"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(raw.run("ALTER TABLE samples DROP COLUMN axis; PRAGMA user_version = 5"));
  KeepSample slim = keep("square");
  slim.sample.axis_deg = 30;
  ASSERT_TRUE(open().apply(slim));
  const KeptObjects kept = open().read().value();
  ASSERT_TRUE(kept.damaged.empty());
  EXPECT_EQ(kept.objects.find("circle")->samples.front().axis_deg, 0);
  EXPECT_EQ(kept.objects.find("square")->samples.front().axis_deg, 30);
}

TEST_F(Database, ReadsWhatTheThirdFormatKept) {
  learn_along_y({"circle", "square"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(
      raw.run("ALTER TABLE samples DROP COLUMN axis; ALTER TABLE samples DROP COLUMN contrast; ALTER TABLE samples "
              "DROP COLUMN focal; ALTER TABLE samples "
              "RENAME COLUMN size_by TO guessed;"
              "PRAGMA user_version = 3"));
  EXPECT_EQ(content(), "circle*1 square*1 ");
  learn({"cross"});
  EXPECT_EQ(content(), "circle*1 square*1 cross*1 ");
}

TEST_F(Database, ReadsWhatTheSecondFormatKept) {
  learn_along_y({"circle", "square"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(
      raw.run("ALTER TABLE samples DROP COLUMN axis; ALTER TABLE samples DROP COLUMN contrast; ALTER TABLE samples "
              "DROP COLUMN focal; ALTER TABLE samples "
              "DROP COLUMN size_by;"
              "PRAGMA user_version = 2"));
  EXPECT_EQ(content(), "circle*1 square*1 ");
  learn({"cross"});
  EXPECT_EQ(content(), "circle*1 square*1 cross*1 ");
}

TEST_F(Database, ReadsWhatTheFirstFormatKept) {
  learn_along_y({"circle", "square"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(
      raw.run("CREATE TABLE old (name TEXT COLLATE NOCASE, num INTEGER, tone TEXT, area REAL, "
              "perimeter INTEGER, nf INTEGER, m0 REAL, m1 REAL, m2 REAL, height REAL, slimness REAL, "
              "roundness REAL, roundness_spread REAL, size REAL, sum INTEGER, UNIQUE (name, num));"
              "INSERT INTO old SELECT name, num, tone, area, perimeter, nf, m0, m1, m2, height, slimness, "
              "roundness, roundness_spread, size, sum FROM samples;"
              "DROP TABLE samples; ALTER TABLE old RENAME TO samples; PRAGMA user_version = 1"));
  EXPECT_EQ(content(), "circle*1 square*1 ");
  learn({"circle"});
  EXPECT_EQ(content(), "circle*2 square*1 ");
}

TEST_F(Database, AChangeThatFailsLeavesNoBitmap) {
  learn({"circle"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(raw.run("CREATE TRIGGER refuse BEFORE INSERT ON samples BEGIN SELECT RAISE(ABORT, 'no'); END"));
  EXPECT_FALSE(open().apply(keep("square")).has_value());
  EXPECT_EQ(files(), (std::vector<std::string>{"circle-1.pgm", "objects.sqlite"}));
}

TEST_F(Database, TellsAnotherThatItHasChanged) {
  ObjectDatabase one = open();
  ObjectDatabase other = open();
  const std::int64_t before = other.version().value();
  EXPECT_EQ(other.version().value(), before);
  ASSERT_TRUE(one.apply(keep("circle")));
  EXPECT_NE(other.version().value(), before);
  EXPECT_NE(other.read().value().objects.find("circle"), nullptr);
  // Its own changes are none of another.
  const std::int64_t now = one.version().value();
  ASSERT_TRUE(one.apply(keep("square")));
  EXPECT_EQ(one.version().value(), now);
}

TEST_F(Database, IsCopiedAsAFolder) {
  learn({"circle", "cross"});
  fs::copy(folder(), room / "copy");
  fs::remove_all(folder());
  fs::rename(room / "copy", folder());
  EXPECT_EQ(content(), "circle*1 cross*1 ");
}

TEST_F(Database, RefusesMoreThanItsBounds) {
  ObjectDatabase database = open();
  for (std::size_t i = 0; i < most_samples; ++i) ASSERT_TRUE(database.apply(keep("circle")));
  EXPECT_EQ(database.apply(keep("circle")).error().symbol, "full");
}

TEST_F(Database, ADamagedBitmapCostsOneSampleAndIsNamed) {
  learn({"circle", "circle", "square"});
  const fs::path bitmap = fs::path(folder()) / "circle-2.pgm";
  for (const std::streamoff at : {0, 5, 40, 700}) {
    fs::copy(bitmap, room / "sound.pgm");
    damage(bitmap, at);
    EXPECT_EQ(content(), "circle*1 square*1 !circle-2.pgm ") << "at " << at;
    fs::remove(bitmap);
    fs::rename(room / "sound.pgm", bitmap);
  }
  EXPECT_EQ(content(), "circle*2 square*1 ");
  fs::resize_file(bitmap, 500);
  EXPECT_EQ(content(), "circle*1 square*1 !circle-2.pgm ");
  fs::remove(bitmap);
  EXPECT_EQ(content(), "circle*1 square*1 !circle-2.pgm ");
  // Its number is not given again, and forgetting the object mends it.
  ASSERT_TRUE(open().apply(keep("circle")));
  EXPECT_EQ(content(), "circle*2 square*1 !circle-2.pgm ");
  ASSERT_TRUE(open().apply(ForgetObject{"circle"}));
  EXPECT_EQ(content(), "square*1 ");
}

// A bitmap of sound form that shows something else.
TEST_F(Database, ABitmapOfAnotherObjectIsFoundOut) {
  learn({"circle", "square"});
  fs::copy(fs::path(folder()) / "circle-1.pgm", fs::path(folder()) / "square-1.pgm",
           fs::copy_options::overwrite_existing);
  EXPECT_EQ(content(), "circle*1 !square-1.pgm ");
}

TEST_F(Database, ADamagedRowCostsOneSample) {
  learn({"circle", "square", "cross"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  const std::vector<std::string> values = {"height = 0",     "slimness = -1", "size = 9e999",  "roundness = 1.3",
                                           "tone = 'light'", "num = 0",       "name = '../x'", "focal = 430",
                                           "focal = -1",     "focal = 9e999"};
  for (const std::string& value : values) {
    const std::string where = " WHERE rowid = 2";
    ASSERT_TRUE(raw.run(("CREATE TABLE kept AS SELECT * FROM samples; UPDATE samples SET " + value + where).c_str()));
    const KeptObjects kept = open().read().value();
    EXPECT_EQ(kept.objects.all().size(), 2U) << value;
    ASSERT_EQ(kept.damaged.size(), 1U) << value;
    ASSERT_TRUE(raw.run("DELETE FROM samples; INSERT INTO samples SELECT * FROM kept; DROP TABLE kept"));
  }
  EXPECT_EQ(content(), "circle*1 square*1 cross*1 ");
}

// A copied database may hold any.
TEST_F(Database, ANameThatIsNoneIsDamageAndNoFileElsewhereIsTouched) {
  learn({"circle", "square", "cross"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(
      raw.run("UPDATE samples SET name = '../evil' WHERE name = 'circle';"
              "UPDATE samples SET name = CAST(x'ff00' AS TEXT) WHERE name = 'square'"));
  fs::rename(fs::path(folder()) / "circle-1.pgm", room / "evil-1.pgm");
  EXPECT_EQ(content(), "cross*1 !objects.sqlite, row 1 !objects.sqlite, row 2 ");
  ObjectDatabase database = open();
  const std::vector<std::string> none = {"../evil", "\xff", "", "a\" OK"};
  for (const std::string& name : none) {
    EXPECT_EQ(database.apply(ForgetObject{name}).error().symbol, "bad-name") << name;
    EXPECT_EQ(database.apply(RenameObject{name, "disc"}).error().symbol, "bad-name") << name;
    EXPECT_EQ(database.apply(RenameObject{"cross", name}).error().symbol, "bad-name") << name;
    EXPECT_EQ(database.apply(KeepSample{name, keep("cross").sample}).error().symbol, "bad-name") << name;
  }
  ASSERT_TRUE(database.apply(WithdrawSample{"circle", 1, 1}));
  EXPECT_TRUE(fs::exists(room / "evil-1.pgm"));
  EXPECT_EQ(content(), "cross*1 !objects.sqlite, row 2 ");
}

TEST_F(Database, AFileThatIsNoDatabaseOrAnothersIsRefused) {
  fs::create_directories(folder());
  const std::string file = folder() + "/objects.sqlite";
  std::ofstream(file) << std::string(5000, 'x');
  EXPECT_EQ(ObjectDatabase::open(folder()).error().symbol, "damaged");
  fs::remove(file);
  ASSERT_TRUE(journal::sqlite::Database::open(file, journal::sqlite::Access::write)->run("CREATE TABLE t (a)"));
  EXPECT_EQ(ObjectDatabase::open(folder()).error().symbol, "unusable");
  std::ofstream(room / "plain") << "no folder";
  EXPECT_EQ(ObjectDatabase::open((room / "plain").string()).error().symbol, "unusable");
}

TEST_F(Database, WhatIsSaidOfDamageIsText) {
  learn({"circle"});
  journal::sqlite::Database raw =
      journal::sqlite::Database::open(folder() + "/objects.sqlite", journal::sqlite::Access::write).value();
  ASSERT_TRUE(
      raw.run("PRAGMA writable_schema = ON;"
              "UPDATE sqlite_schema SET sql = CAST(x'435245415445205441424cff2073' AS TEXT)"));
  const Result<KeptObjects> kept = open().read();
  ASSERT_FALSE(kept.has_value());
  EXPECT_TRUE(is_string_text(kept.error().sentence));
}

// Bytes of the file changed anywhere: an answer or a failure, never a crash, and no other object in an object's place.
TEST_F(Database, SurvivesAnyDamageToItsFile) {
  learn(cell_marks());
  const fs::path file = fs::path(folder()) / "objects.sqlite";
  const std::uintmax_t size = fs::file_size(file);
  fs::copy(file, room / "sound.sqlite");
  Random random(3);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    fs::copy(room / "sound.sqlite", file, fs::copy_options::overwrite_existing);
    for (int i = 0; i < 5; ++i) damage(file, static_cast<std::streamoff>(random.below(size)));
    Result<ObjectDatabase> database = ObjectDatabase::open(folder());
    if (!database) continue;
    const Result<KeptObjects> kept = database->read();
    if (!kept) continue;
    for (const LearnedObject& object : kept->objects.all()) {
      const LearnedObject* learned = learned_cell().find(object.name);
      ASSERT_NE(learned, nullptr) << object.name;
      EXPECT_EQ(object.samples.front().picture, learned->samples.front().picture);
    }
  }
}

}  // namespace
}  // namespace pizarra::vision
