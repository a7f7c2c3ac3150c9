#include "agents/runtime/contract.hpp"

#include <gtest/gtest.h>

#include "lisp/reader.hpp"

namespace pizarra::runtime {
namespace {

constexpr std::string_view text = R"((contract adder
  (offers (add (a number) (b number)) (sum (x number) ...) (stop) (add (c string)))
  (posts (relation total ((value number)) (key)))
  (reads clock)))";

Datum datum_of(std::string_view written) { return read_one(written).value(); }

TEST(Contract, SaysWhatIsOfferedAndPosted) {
  const Contract contract = contract_from_text(text).value();
  EXPECT_EQ(contract.kind, "adder");
  ASSERT_EQ(contract.offers.size(), 4u);
  EXPECT_EQ(contract.offers[0].name, "add");
  EXPECT_TRUE(contract.offers[1].repeats);
  ASSERT_EQ(contract.posts.size(), 1u);
  EXPECT_EQ(contract.posts[0].name, "total");
}

TEST(Contract, ShowsWhatIsReadByNameAndDeclaresWhatIsGivenWhole) {
  const Contract contract =
      contract_from_text("(contract lamp (reads clock (relation night ((since number)) (key))) (monitors heat))")
          .value();
  EXPECT_EQ(contract.form, datum_of("(contract lamp (reads clock night) (monitors heat))"));
  ASSERT_EQ(contract.reads.size(), 1u);
  EXPECT_EQ(contract.reads[0].name, "night");
  EXPECT_TRUE(contract.posts.empty());
}

TEST(Contract, PostsByNameWhatAnotherAgentDeclares) {
  const Contract contract =
      contract_from_text("(contract page (posts stop (relation wish ((robot symbol)) (key robot))))").value();
  ASSERT_EQ(contract.posts.size(), 1U);
  EXPECT_EQ(contract.posts.front().name, "wish");
  EXPECT_EQ(contract.form[2][1], "stop"_sym);
}

TEST(Contract, RefusesWhatIsNotAContract) {
  for (const std::string_view wrong :
       {"(contract)", "(contact x)", "(contract x (ofers))", "(contract x (offers 3))",
        "(contract x (offers (f (a nmber))))", "(contract x (offers (f ...)))", "(contract x (posts (relation)))",
        "(contract x (posts 3))", "(contract x (reads (relation)))", "(contract x (reads 3))", "(contract x"}) {
    EXPECT_FALSE(contract_from_text(wrong).has_value()) << wrong;
  }
}

TEST(Contract, AcceptsOperationsThatFitAndNoOthers) {
  const Contract contract = contract_from_text(text).value();
  for (const std::string_view right : {"(add 1 2.5)", "(add \"three\")", "(sum)", "(sum 1)", "(sum 1 2 3)", "(stop)"}) {
    EXPECT_TRUE(check_operation(contract, datum_of(right)).has_value()) << right;
  }
  for (const std::string_view wrong : {"(add 1)", "(add 1 \"2\")", "(add 1 2 3)", "(sum 1 x)", "(stop 1)"}) {
    const Result<void> checked = check_operation(contract, datum_of(wrong));
    ASSERT_FALSE(checked.has_value()) << wrong;
    EXPECT_EQ(checked.error().symbol, "wrong-shape") << wrong;
  }
  for (const std::string_view unknown : {"(ad 1 2)", "()", "(1)", "add"}) {
    const Result<void> checked = check_operation(contract, datum_of(unknown));
    ASSERT_FALSE(checked.has_value()) << unknown;
    EXPECT_EQ(checked.error().symbol, "unknown-operation") << unknown;
  }
  EXPECT_NE(check_operation(contract, datum_of("(ad 1 2)")).error().sentence.find("did you mean add?"),
            std::string::npos);
}

}  // namespace
}  // namespace pizarra::runtime
