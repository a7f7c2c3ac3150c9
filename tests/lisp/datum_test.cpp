#include <gtest/gtest.h>
#include <unordered_set>

#include "lisp/result.hpp"
#include "lisp/writer.hpp"

namespace pizarra {
namespace {

TEST(DatumTest, KindsShowTheirValues) {
  const Datum fact = list("seen"_sym, "circle", 112, 87.5, list());
  EXPECT_EQ(fact.head(), "seen");
  EXPECT_TRUE(fact.is_form("seen"));
  EXPECT_FALSE(fact.is_form(""));
  EXPECT_EQ(fact[1].text(), "circle");
  EXPECT_TRUE(fact[1].is_string());
  EXPECT_EQ(fact[2].integer(), 112);
  EXPECT_EQ(fact[2].number(), 112.0);
  EXPECT_EQ(fact[3].number(), 87.5);
  EXPECT_EQ(fact[3].integer(), 0);
  EXPECT_EQ(fact[4], Datum());
  EXPECT_EQ(fact.size(), 5u);
}

TEST(DatumTest, TextOfAnyLengthIsKeptWhole) {
  for (std::size_t length = 0; length < 40; ++length) {
    const std::string text(length, 'x');
    EXPECT_EQ(Datum::string(text).text(), text);
    if (length == 0) continue;
    EXPECT_EQ(Datum::symbol(text).text(), text);
    EXPECT_NE(Datum::symbol(text), Datum::string(text));
  }
}

TEST(DatumTest, IntegerAndRealOfOneValueDiffer) {
  EXPECT_NE(to_datum(1), to_datum(1.0));
  EXPECT_EQ(write(list(1, 1.0, 1e300, -0.0, 0.1)), "(1 1.0 1e+300 0.0 0.1)");
}

TEST(DatumTest, KindsOrderAsDeclared) {
  EXPECT_LT("z"_sym, to_datum("a"));
  EXPECT_LT(to_datum("z"), to_datum(-5));
  EXPECT_LT(to_datum(7), to_datum(-7.5));
  EXPECT_LT(to_datum(7.5), Datum());
  EXPECT_LT(list(1), list(1, 1));
  EXPECT_LT(list(1, 5), list(2));
}

TEST(DatumTest, HashesOfAGridOfFactsDiffer) {
  std::unordered_set<std::size_t> hashes;
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 100; ++y) hashes.insert(list("at"_sym, x, y).hash());
  }
  EXPECT_EQ(hashes.size(), 10'000u);
}

// The child begins anew, with what this process has put into the environment.
TEST(DatumTest, HashesAreAnotherProcesssOwn) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const Datum& datum : {to_datum(7), to_datum("short"), to_datum("longer than what stands in a datum"), list(7)}) {
    const std::string hash = std::to_string(datum.hash());
    const std::string name =
        "PIZARRA_TEST_HASH_" + std::to_string(static_cast<int>(datum.kind())) + std::to_string(datum.text().size());
    setenv(name.c_str(), hash.c_str(), 0);
    EXPECT_EXIT(std::exit(getenv(name.c_str()) == hash ? 1 : 0), testing::ExitedWithCode(0), "");
  }
}

TEST(FailureTest, CrossesTheBoardWhole) {
  const Failure failure{"unknown-object", "nothing is called star", "star"_sym, "goal:1:5"};
  EXPECT_EQ(write(failure_to_datum(failure)), R"((fail unknown-object "nothing is called star" star "goal:1:5"))");
  EXPECT_EQ(failure_from_datum(failure_to_datum(failure)), failure);
  EXPECT_EQ(failure_from_datum(list("fail"_sym, 3)).symbol, "malformed-failure");
}

TEST(FailureTest, IsDescribedWithASubjectOnlyWhereThatSaysMore) {
  EXPECT_EQ(describe({"a", "nothing is called star", "star"_sym, {}}), "nothing is called star");
  EXPECT_EQ(describe({"a", "refused", list("on"_sym, 1), "goal:1:5"}), "refused: (on 1)\ngoal:1:5");
}

}  // namespace
}  // namespace pizarra
