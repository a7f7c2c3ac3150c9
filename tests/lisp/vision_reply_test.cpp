#include "lisp/forms/vision_reply.hpp"

#include <gtest/gtest.h>

#include "lisp/writer.hpp"

namespace pizarra {
namespace {

std::string reading(std::string_view text) {
  const auto reply = forms::interpret_vision_reply(text);
  return reply ? write(*reply) : reply.error().symbol;
}

TEST(VisionReplyTest, ReadsEveryReplyOfTheTable) {
  EXPECT_EQ(reading("(LEARN \"circle\" OK)"), "(learn \"circle\" ok)");
  EXPECT_EQ(reading("(LEARN \"circle\" FAIL)"), "(learn \"circle\" fail)");
  EXPECT_EQ(reading("(FIND \"circle\" OK (112, 87))"), "(find \"circle\" ok 112 87)");
  EXPECT_EQ(reading("(FIND \"circle\" FAIL)"), "(find \"circle\" fail)");
  EXPECT_EQ(reading("(TRACK 2 (\"End-Effector\" OK (160.25, 20.50, 790.00)) (\"circle\" FAIL))"),
            "(track (\"End-Effector\" 160.25 20.5 790.0) (\"circle\" fail))");
  EXPECT_EQ(reading("(GET 3 (\"a\", \"b\" ,\"c\"))"), "(get \"a\" \"b\" \"c\")");
  EXPECT_EQ(reading("(GET 0 ())"), "(get)");
}

TEST(VisionReplyTest, EverySpellingOfTheCommaIsTwoNumbers) {
  for (const char* pair : {"(112, 87)", "(112 ,87)", "(112,87)", "( 112 , 87 )"}) {
    EXPECT_EQ(reading("(FIND \"circle\" OK " + std::string(pair) + ")"), "(find \"circle\" ok 112 87)") << pair;
  }
  EXPECT_EQ(reading("(FIND \"circle\" OK (112.25 ,87.50))"), "(find \"circle\" ok 112.25 87.5)");
}

TEST(VisionReplyTest, RefusesWhatTheTableDoesNotHave) {
  EXPECT_EQ(reading("(FIND \"circle\" OK (112 87))"), "malformed");
  EXPECT_EQ(reading("(FIND \"circle\" OK 112, 87)"), "malformed");
  EXPECT_EQ(reading("(TRACK 3 (\"circle\" FAIL))"), "wrong-count");
  EXPECT_EQ(reading("(find \"circle\" FAIL)"), "malformed");
  EXPECT_EQ(reading("(FIND \"circle\" FAIL"), "unclosed-list");
  EXPECT_EQ(reading("(FIND 'circle FAIL)"), "bad-character");
  EXPECT_EQ(reading("(GET 1 (((((\"a\"))))))"), "too-deep");
  EXPECT_EQ(reading(std::string(100'000, ' ')), "too-long");
  EXPECT_EQ(reading(""), "malformed");
}

TEST(VisionReplyTest, ARefusalShowsThePlace) {
  const auto reply = forms::interpret_vision_reply("(TRACK 1 (\"circle\" OK (1, 2)))");
  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().place, "vision:1:23\n  (TRACK 1 (\"circle\" OK (1, 2)))\n                        ^");
}

}  // namespace
}  // namespace pizarra
