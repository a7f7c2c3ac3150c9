#include "programs/story/seed_pool.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <unistd.h>
#include <utility>

namespace pizarra::story {
namespace {

using Answers = std::vector<std::pair<std::uint64_t, std::string>>;

Answers answers(SeedPool::Seeds seeds, SeedPool::Work work) {
  Answers out;
  SeedPool pool(seeds, std::move(work));
  const SeedPool::End end = pool.run([&](std::uint64_t seed, const SeedPool::Answer& answer) {
    out.emplace_back(seed, answer.trouble.empty() ? answer.text : answer.trouble);
    return true;
  });
  EXPECT_EQ(end, SeedPool::End::heard);
  return out;
}

// The first end last.
TEST(SeedPool, AnswersComeInTheOrderOfTheSeeds) {
  const auto slow_first = [](std::uint64_t seed) {
    usleep(static_cast<useconds_t>((7 - seed) * 3000));
    return std::to_string(seed);
  };
  EXPECT_EQ(answers({.first = 4, .seeds = 3, .jobs = 3}, slow_first), (Answers{{4, "4"}, {5, "5"}, {6, "6"}}));
}

TEST(SeedPool, ALongAnswerComesWhole) {
  const std::string text(300'000, 'x');
  EXPECT_EQ(answers({.seeds = 1}, [&](std::uint64_t) { return text; }), (Answers{{1, text}}));
}

TEST(SeedPool, ARunThatDiesSaysByWhichSignal) {
  const auto second_dies = [](std::uint64_t seed) {
    if (seed == 2) raise(SIGKILL);
    return std::string("alive");
  };
  EXPECT_EQ(answers({.seeds = 3, .jobs = 2}, second_dies),
            (Answers{{1, "alive"}, {2, "ended by signal 9"}, {3, "alive"}}));
}

TEST(SeedPool, ARunThatHangsIsEndedAndSaidToBeOverdue) {
  SeedPool pool({.seeds = 1, .longest = std::chrono::seconds(1)}, [](std::uint64_t) {
    pause();
    return std::string("never");
  });
  pool.run([](std::uint64_t, const SeedPool::Answer& answer) {
    EXPECT_TRUE(answer.overdue);
    EXPECT_EQ(answer.text, "");
    return true;
  });
}

TEST(SeedPool, NoMoreAreHeardOnceTheListenerHasEnough) {
  int heard = 0;
  SeedPool pool({.seeds = 50, .jobs = 2}, [](std::uint64_t) { return std::string("one"); });
  EXPECT_EQ(pool.run([&](std::uint64_t, const SeedPool::Answer&) { return ++heard < 2; }), SeedPool::End::heard);
  EXPECT_EQ(heard, 2);
}

}  // namespace
}  // namespace pizarra::story
