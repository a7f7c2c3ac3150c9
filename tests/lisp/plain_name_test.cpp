#include "lisp/plain_name.hpp"

#include <gtest/gtest.h>
#include <string>

namespace pizarra {
namespace {

TEST(PlainName, HasLettersDigitsAndDashesALetterFirst) {
  for (const char* name : {"a", "Z", "ur5e-2", "end-effector", "a-"}) EXPECT_TRUE(is_plain_name(name)) << name;
  for (const char* name : {"", "2nd", "-a", "a b", "a_b", "a.b", "a/b", "\xC3\xA4", "a\xE4"}) {
    EXPECT_FALSE(is_plain_name(name)) << name;
  }
}

TEST(PlainName, HasABound) {
  EXPECT_TRUE(is_plain_name(std::string(longest_plain_name, 'x')));
  EXPECT_FALSE(is_plain_name(std::string(longest_plain_name + 1, 'x')));
}

}  // namespace
}  // namespace pizarra
