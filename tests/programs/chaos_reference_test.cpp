#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

#include "programs/chaos/reference.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::chaos {
namespace {

Reference some_runs() {
  Reference reference{.runs = 200, .first_seed = 1, .failed = 3, .unsafe = 0, .hung = 1, .coverage = {}};
  reference.coverage.hit("event plan", 12);
  reference.coverage.hit("fault slip STACK 3", 4);
  return reference;
}

Result<Reference> read(const std::string& text) {
  const std::string file = scratch_folder() + "reference.txt";
  std::ofstream(file) << text;
  return read_reference(file);
}

std::string trouble_with(const std::string& text) {
  const Result<Reference> reference = read(text);
  return reference ? std::string() : reference.error().sentence;
}

TEST(ChaosReference, ComesBackFromItsFile) {
  const Result<Reference> back = read(text_of(some_runs()));
  ASSERT_TRUE(back) << back.error().sentence;
  EXPECT_EQ(text_of(*back), text_of(some_runs()));
  EXPECT_EQ(back->failed, 3U);
  EXPECT_EQ(back->coverage.counts().size(), 2U);
}

TEST(ChaosReference, MoreFailuresUnsafeAndHungRunsAreWorse) {
  Reference now = some_runs();
  EXPECT_TRUE(worse_than(some_runs(), now).empty());
  now.failed = 4;
  now.unsafe = 1;
  now.hung = 2;
  EXPECT_EQ(worse_than(some_runs(), now), (std::vector<std::string>{"worse: failed 4, and 3 in the reference",
                                                                    "worse: unsafe 1, and 0 in the reference",
                                                                    "worse: hung 2, and 1 in the reference"}));
}

TEST(ChaosReference, FewerFailuresAreToldSoThatTheFileFollows) {
  Reference now = some_runs();
  now.failed = 1;
  EXPECT_TRUE(worse_than(some_runs(), now).empty());
  EXPECT_EQ(better_than(some_runs(), now), (std::vector<std::string>{"better: failed 1, and 3 in the reference"}));
}

TEST(ChaosReference, OnlyWhatWasComeToOftenIsMissed) {
  Reference now = some_runs();
  now.coverage = {};
  EXPECT_EQ(worse_than(some_runs(), now), (std::vector<std::string>{"lost: event plan"}));
}

// Otherwise nothing would say that no run came to it any more, where the file counts it less than five times.
TEST(ChaosReference, EveryPointThatTheShippedFileCountsIsNamed) {
  const Result<Reference> shipped = read_reference(source_dir() + "/tests/programs/chaos-coverage.txt");
  ASSERT_TRUE(shipped) << shipped.error().sentence;
  ASSERT_GT(shipped->coverage.counts().size(), 100U);
  for (const auto& [point, count] : shipped->coverage.counts()) {
    EXPECT_NE(std::ranges::find(named_points(), point), named_points().end()) << point;
  }
}

TEST(ChaosReference, AFileThatIsNoneIsToldWithItsLine) {
  const std::string file = scratch_folder() + "reference.txt";
  const std::string head = "runs 1\nfirst-seed 1\nfailed 0\nunsafe 0\n";
  EXPECT_EQ(trouble_with(head + "hung none\n"), file + ":5: not a name and a count");
  EXPECT_EQ(trouble_with(head + "hung 0\nevent plan -1\n"), file + ":6: not a name and a count");
  EXPECT_EQ(trouble_with(head + "event plan 7\n"), file + ":5: it has no line \"hung COUNT\"");
  EXPECT_EQ(trouble_with(""), file + ":0: it has no line \"failed COUNT\"");
}

}  // namespace
}  // namespace pizarra::chaos
