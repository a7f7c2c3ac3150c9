#include "blackboard/watch/pattern_index.hpp"

#include <gtest/gtest.h>
#include <set>

#include "blackboard/store/evaluate.hpp"
#include "blackboard/time/random.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

using Found = std::set<const watch::WatchedPattern*>;

std::string one_of(Random& random, const std::vector<std::string>& choices) {
  return choices[random.below(choices.size())];
}

std::string value(Random& random) {
  return one_of(random,
                {"1", "1.0", "2", "2.5", "-3", "9007199254740993", "9007199254740992.0", "x", "\"x\"", "(1 2)"});
}

std::string arguments(Random& random, const std::vector<std::string>& variables) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += " " + (random.below(3) == 0 ? value(random) : one_of(random, variables));
  return text;
}

// Most of what chance writes is a query.
Query random_query(Random& random) {
  while (true) {
    std::string text = "(and (p" + arguments(random, {"?x", "?y", "?z", "?"}) + ")";
    for (std::uint64_t comparisons = random.below(4); comparisons > 0; --comparisons) {
      const std::string variable = one_of(random, {"?x", "?y", "?z"});
      const std::string other = random.below(6) == 0 ? "?x" : value(random);
      const std::string name = one_of(random, {"<", "<=", ">", ">=", "=", "/="});
      text += " (" + name + " " + (random.below(2) == 0 ? variable + " " + other : other + " " + variable) + ")";
    }
    if (random.below(4) == 0) text += " (not (p" + arguments(random, {"?x", "?w"}) + "))";
    const Result<Query> made = query_from_datum(read(text + ")"));
    if (made) return *made;
  }
}

bool fits(const Query& query, const Datum& fact) {
  Bindings bindings;
  return match(query.clauses[0].form, fact, bindings) &&
         std::ranges::all_of(query.clauses, [&](const Query::Clause& clause) {
           return clause.kind != Query::Clause::Kind::compare || store::holds(clause.form, bindings);
         });
}

Found found(const watch::PatternIndex& index, const Datum& fact) {
  Found found;
  index.visit(fact, [&](const watch::WatchedPattern& pattern) {
    EXPECT_TRUE(!pattern.may_fit(fact) || found.insert(&pattern).second);
  });
  return found;
}

TEST(PatternIndex, FindsWhatTryingAllFinds) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    watch::PatternIndex index;
    struct Watched {
      Query query;
      std::vector<watch::WatchedPattern> patterns;
    };
    std::vector<Watched> watched;
    for (int step = 0; step < 200; ++step) {
      if (random.below(4) == 0 && !watched.empty()) {
        const auto gone = watched.begin() + static_cast<std::ptrdiff_t>(random.below(watched.size()));
        for (const watch::WatchedPattern& pattern : gone->patterns) index.remove(pattern);
        watched.erase(gone);
      } else {
        const Query query = random_query(random);
        watched.push_back({query, watch::patterns_of(query, nullptr)});
        for (watch::WatchedPattern& pattern : watched.back().patterns) index.add(pattern);
      }
      const Datum fact = read("(p " + value(random) + " " + value(random) + " " + value(random) + ")");
      Found all;
      for (const Watched& watch : watched) {
        for (const watch::WatchedPattern& pattern : watch.patterns) {
          if (pattern.may_fit(fact)) all.insert(&pattern);
        }
        ASSERT_TRUE(!fits(watch.query, fact) || all.contains(&watch.patterns[0]))
            << write(fact) << write(query_to_datum(watch.query));
      }
      ASSERT_EQ(found(index, fact), all) << write(fact);
    }
    for (const Watched& watch : watched) {
      for (const watch::WatchedPattern& pattern : watch.patterns) index.remove(pattern);
    }
    index.visit_all([](const watch::WatchedPattern& pattern) { ADD_FAILURE() << write(pattern.pattern); });
  }
}

// How many of the patterns of 2000 watches, N from 1000 on, a fact leads to.
std::size_t looked_at(const std::string& before, const std::string& after, const std::string& fact) {
  watch::PatternIndex index;
  std::vector<std::vector<watch::WatchedPattern>> watched;
  for (int n = 1000; n < 3000; ++n) {
    watched.push_back(watch::patterns_of(query(before + std::to_string(n) + after), nullptr));
    for (watch::WatchedPattern& pattern : watched.back()) index.add(pattern);
  }
  std::size_t count = 0;
  index.visit(read(fact), [&](const watch::WatchedPattern&) { ++count; });
  return count;
}

TEST(PatternIndex, AFactLeadsToFewThatItDoesNotFit) {
  EXPECT_LE(looked_at("(reading s ", ")", "(reading s 7)"), 1U);
  EXPECT_LE(looked_at("(and (reading s ?v) (= ?v ", "))", "(reading s 7)"), 1U);
  EXPECT_EQ(looked_at("(and (reading ?s ?v) (= ", " ?v))", "(reading s 1500.0)"), 1U);
  EXPECT_EQ(looked_at("(and (reading s ?v) (> ?v ", "))", "(reading s 7)"), 0U);
  EXPECT_EQ(looked_at("(and (reading ?s ?v) (<= ", " ?v))", "(reading s 1009)"), 10U);
  EXPECT_EQ(looked_at("(and (reading s ?v) (< ?v ", "))", "(reading s 7000)"), 0U);
  EXPECT_EQ(looked_at("(and (reading ?s ?v) (>= ", " ?v))", "(reading s 2990.5)"), 9U);
}

}  // namespace
}  // namespace pizarra
