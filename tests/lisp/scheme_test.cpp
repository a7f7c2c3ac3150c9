#include "lisp/guile/scheme.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include "lisp/writer.hpp"
#include "tests/lisp/random_datum.hpp"

namespace pizarra {
namespace {

TEST(SchemeTest, DataPassBothWaysUnchanged) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const Datum datum = RandomDatum(seed).any(6);
    const auto back = guile::call_scheme("echo", "echo", {datum});
    ASSERT_TRUE(back) << "seed " << seed << " " << describe(back.error());
    EXPECT_EQ(*back, datum) << "seed " << seed;
  }
}

TEST(SchemeTest, AnErrorInSchemeIsAFailureAndTheNextCallWorks) {
  for (int i = 0; i < 100; ++i) {
    const auto raised = guile::call_scheme("echo", "raise", {to_datum("some words")});
    ASSERT_FALSE(raised);
    EXPECT_EQ(raised.error().symbol, "scheme-error");
    EXPECT_NE(raised.error().sentence.find("some words"), std::string::npos) << raised.error().sentence;
    EXPECT_TRUE(guile::call_scheme("echo", "echo", {to_datum(i)}));
  }
}

TEST(SchemeTest, WhatIsMissingIsAFailure) {
  EXPECT_EQ(guile::call_scheme("no-such-module", "echo", {}).error().symbol, "scheme-error");
  EXPECT_EQ(guile::call_scheme("echo", "no-such-procedure", {}).error().symbol, "scheme-error");
  EXPECT_EQ(guile::call_scheme("echo", "echo", {}).error().symbol, "scheme-error");
}

TEST(SchemeTest, AValueThatIsNoDatumIsRefused) {
  for (const char* odd :
       {"procedure", "boolean", "improper", "infinite", "big", "nul", "spaced-symbol", "circular", "deep"}) {
    const auto returned = guile::call_scheme("echo", "odd", {Datum::symbol(odd)});
    ASSERT_FALSE(returned) << odd << " " << write(*returned);
    EXPECT_EQ(returned.error().symbol, "scheme-error") << odd;
  }
  EXPECT_EQ(guile::call_scheme("echo", "odd", {"fraction"_sym}).value(), to_datum(0.5));
}

TEST(SchemeTest, ManyCallsKeepNoMemory) {
  const Datum fact = list("seen"_sym, std::string(2000, 'x'), 112, 87.5, list("a-rather-long-symbol"_sym));
  const auto call_often = [&](int times) {
    for (int i = 0; i < times; ++i) ASSERT_EQ(guile::call_scheme("echo", "echo", {fact}).value(), fact);
  };
  call_often(100);
  const std::size_t before = mallinfo2().uordblks;
  call_often(10'000);
  EXPECT_LT(mallinfo2().uordblks, before + 1'000'000);
}

TEST(InterpretTest, AllErrorsAreInOneReport) {
  const Source source = read_source("(a 1)\n  (b \"two\") (c)", "text").value();
  const auto read = guile::interpret(source, "echo", {"extra"_sym});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().symbol, "odd");
  EXPECT_EQ(read.error().sentence, "first (and 1 more)");
  EXPECT_EQ(read.error().subject, to_datum(1));
  EXPECT_EQ(read.error().place,
            "text:1:4\n  (a 1)\n     ^\nsecond extra\ntext:2:6\n    (b \"two\") (c)\n       ^\n  in the test\n  in b");
}

}  // namespace
}  // namespace pizarra
