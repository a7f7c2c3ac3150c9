#include "tests/bench/figures.hpp"

#include <gtest/gtest.h>

#include "tests/bench/measure.hpp"

namespace pizarra::bench {
namespace {

class BenchFigures : public testing::Test {
 protected:
  ~BenchFigures() override { std::fclose(out_); }

  std::string printed() {
    std::fflush(out_);
    std::rewind(out_);
    std::string text(4096, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), out_));
    return text;
  }

  std::FILE* out_ = std::tmpfile();
};

TEST_F(BenchFigures, AreCountedAsMetOrShortAndThoseWithoutTheirPeerNotAtAll) {
  Figures figures("blackboard", Figures::Style::plain, out_);
  figures.say({"ask", 0.8, "us", at_most(1), {{"redis", 50.0}}});
  figures.say({"tells", 0.9e6, "1/s", at_least(1e6)});
  figures.say({"fan-out", 2, "ms", not_comparable("redis is not installed"), {{"redis", {}}}});
  EXPECT_EQ(figures.finish(), 0);
  const std::string text = printed();
  EXPECT_NE(text.find("redis 50  met\n"), std::string::npos) << text;
  EXPECT_NE(text.find(">= 1e+06"), std::string::npos) << text;
  EXPECT_NE(text.find("SHORT\n"), std::string::npos) << text;
  EXPECT_NE(text.find("n/a: redis is not installed  "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("goals met 1 of 2\n")) << text;
}

TEST_F(BenchFigures, SayWhatLimitsThemWhereTheyAreShort) {
  Figures figures("blackboard", Figures::Style::plain, out_);
  figures.say({.name = "met", .value = 1, .unit = "us", .goal = at_most(1), .limit = "nothing"});
  figures.say({.name = "tells", .value = 2, .unit = "us", .goal = at_most(1), .note = "quiet", .limit = "the cores"});
  const std::string text = printed();
  EXPECT_EQ(text.find("nothing"), std::string::npos) << text;
  EXPECT_NE(text.find("SHORT  (quiet; limited by the cores)\n"), std::string::npos) << text;
}

TEST_F(BenchFigures, ThatCouldNotBeMeasuredFailTheBench) {
  Figures figures("blackboard", Figures::Style::plain, out_);
  figures.say({"ask", {}, "us", at_most(1)});
  EXPECT_EQ(figures.finish(), 1);
  EXPECT_TRUE(printed().ends_with("not measured: 1\ngoals met 0 of 1\n"));
}

TEST_F(BenchFigures, DoNotHideWhatWentWrongWhileTheyWereMeasured) {
  Figures figures("cluster", Figures::Style::plain, out_);
  figures.say({"first tell", 0.2, "s", at_most(1)});
  figures.must_be_none("done twice", 0);
  figures.must_be_none("acknowledged and lost", 2);
  EXPECT_EQ(figures.finish(), 1);
  EXPECT_TRUE(printed().ends_with("WRONG: acknowledged and lost 2\ngoals met 1 of 1\n"));
}

TEST_F(BenchFigures, AreOneJsonObjectALineForPrograms) {
  Figures figures("planner", Figures::Style::json, out_);
  figures.say({"blocks \"4\"", 0.25, "s", at_most(1), {{"m", {}}}});
  figures.finish();
  EXPECT_EQ(printed(),
            "{\"bench\":\"planner\",\"figure\":\"blocks \\\"4\\\"\",\"value\":0.25,\"unit\":\"s\",\"goal\":\"<= 1\","
            "\"verdict\":\"met\",\"peers\":{\"m\":null},\"note\":\"\"}\n"
            "{\"bench\":\"planner\",\"goals_met\":1,\"goals\":1,\"unmeasured\":0}\n");
}

TEST(Percentile, IsTheNearestSample) {
  const std::vector<double> samples = {5, 1, 4, 2, 3};
  EXPECT_EQ(percentile(samples, 0), 1);
  EXPECT_EQ(percentile(samples, 0.5), 3);
  EXPECT_EQ(percentile(samples, 1), 5);
  EXPECT_EQ(percentile({}, 0.5), 0);
}

}  // namespace
}  // namespace pizarra::bench
