// The files in which keys are kept.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "blackboard/wire/keys.hpp"
#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

TEST(KeyFiles, AreWrittenSoThatOnlyTheOwnerReadsTheSecretAndReadBack) {
  const std::string folder = ipc_address().substr(6) + ".keys";
  const wire::Permissions may{{"arm", "arm-*"}, {"request"}, {"*"}, {}};
  const wire::KeyPair made = wire::make_keys(folder, "robot", may).value();
  EXPECT_EQ(std::filesystem::status(folder + "/robot.secret").permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_EQ(wire::read_public_key(folder + "/robot.key").value(), (wire::PublicKey{"robot", made.public_key, may}));
  EXPECT_EQ(wire::read_secret_key(folder + "/robot.secret").value().secret_key, made.secret_key);
  EXPECT_EQ(symbol_of(wire::make_keys(folder, "robot", may)), "already-there");
  EXPECT_EQ(symbol_of(wire::make_keys(folder, "../robot", may)), "bad-name");
  EXPECT_EQ(symbol_of(wire::read_client_keys(folder + "/robot.secret")), "unreadable-file") << "no board.key";
  std::filesystem::permissions(folder + "/robot.secret", std::filesystem::perms::group_read,
                               std::filesystem::perm_options::add);
  EXPECT_EQ(symbol_of(wire::read_secret_key(folder + "/robot.secret")), "exposed-key");
  std::filesystem::remove_all(folder);
}

TEST(KeyFiles, AreNotMadeForWhatIsNoRelationAndNothingIsLeftBehind) {
  const std::string folder = ipc_address().substr(6) + ".keys";
  const std::string longest(limits::name_bytes, 'r');
  for (const std::string& name :
       {std::string(), std::string(" x"), std::string("a*b"), std::string("**"), std::string("?x"), std::string("12"),
        std::string("."), std::string("a(b"), std::string("\xff"), std::string("a\0", 2), longest + "r"}) {
    for (const wire::Permissions& may :
         {wire::Permissions{{"arm", name}, {}, {}, {}}, wire::Permissions{{}, {name}, {}, {}},
          wire::Permissions{{}, {}, {name}, {}}, wire::Permissions{{}, {}, {}, {name}}}) {
      EXPECT_EQ(symbol_of(wire::make_keys(folder, "robot", may)), "bad-name") << name;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
  const wire::Permissions may{{"arm-*", longest}, {"*"}, {"<-*"}, {}};
  ASSERT_EQ(symbol_of(wire::make_keys(folder, "robot", may)), "ok");
  EXPECT_EQ(wire::read_public_key(folder + "/robot.key").value().may, may);
  std::filesystem::remove_all(folder);
}

TEST(KeyFiles, SayWhereTheyAreWrong) {
  const std::string file = ipc_address().substr(6) + ".key";
  const std::string key(40, '0');
  for (const std::string& text :
       {std::string("(key)"), std::string("(key robot)"), "(key robot \"" + key.substr(1) + "\")",
        "(key \"robot\" \"" + key + "\")", "(key robot \"" + key + "\" (dance *))",
        "(key robot \"" + key + "\" (tell a*b))", "(key robot \"" + key + "\" (tell ?a))",
        "(key robot \"" + key + "\" (tell \"arm\"))", "(key robot \"" + key + "\" (tell a) (tell b))",
        "(key robot \"" + key + "\") (key)"}) {
    std::ofstream(file) << text;
    const Result<wire::PublicKey> read = wire::read_public_key(file);
    ASSERT_EQ(symbol_of(read), "bad-key") << text;
    EXPECT_NE(read.error().place.find(file + ":1:"), std::string::npos) << read.error().place;
  }
  std::ofstream(file) << "(key robot \"" + key + "\" (read *))";
  EXPECT_EQ(symbol_of(wire::read_public_key(file)), "ok");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace pizarra
