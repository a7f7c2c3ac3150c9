#include "blackboard/store/fact_list.hpp"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace pizarra {
namespace {

store::StandingFact fact_of(FactId id) {
  store::StandingFact standing;
  standing.fact.id = id;
  standing.fact.datum = list("number"_sym, id);
  return standing;
}

std::vector<FactId> ids_from(const store::FactList& facts, FactId first) {
  std::vector<FactId> ids;
  for (const store::StandingFact& standing : facts.from(first)) ids.push_back(standing.fact.id);
  return ids;
}

std::vector<FactId> ids_from(const std::map<FactId, store::StandingFact*>& expected, FactId first) {
  std::vector<FactId> ids;
  for (auto i = expected.lower_bound(first); i != expected.end(); ++i) ids.push_back(i->first);
  return ids;
}

TEST(FactList, HoldsWhatAMapHolds) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    store::FactList facts;
    std::map<FactId, store::StandingFact*> expected;
    FactId last = 0;
    for (int step = 0; step < 1500; ++step) {
      const bool grows = random() % 1000 < (step < 700 ? 600 : 350);
      if (grows || expected.empty()) {
        // Some ids are passed over, and a few of those come later.
        FactId id = last += 1 + random() % 2;
        if (random() % 16 == 0 && !expected.contains(id - 1) && id > 1) --id;
        if (expected.contains(id)) continue;
        expected[id] = &facts.insert(fact_of(id));
      } else {
        const auto gone = std::next(expected.begin(), static_cast<std::ptrdiff_t>(random() % expected.size()));
        EXPECT_EQ(facts.remove(*gone->second).fact.datum, fact_of(gone->first).fact.datum);
        expected.erase(gone);
      }
      ASSERT_EQ(facts.size(), expected.size());
      const FactId any = 1 + random() % (last + 2);
      const auto standing = expected.find(any);
      ASSERT_EQ(facts.find(any), standing == expected.end() ? nullptr : standing->second);
      if (step % 50 == 0) {
        ASSERT_EQ(ids_from(facts, any), ids_from(expected, any));
      }
    }
  }
}

TEST(FactList, AReplacedFactStandsInTheFormersPlaceAndAtTheEndOfTheOrder) {
  store::FactList facts;
  store::StandingFact& first = facts.insert(fact_of(1));
  facts.insert(fact_of(2));
  for (FactId id = 3; id < 300; ++id) {
    EXPECT_EQ(facts.replace(first, fact_of(id).fact).id, id == 3 ? 1 : id - 1);
    ASSERT_EQ(facts.find(id), &first);
    ASSERT_EQ(facts.find(id - 1) == nullptr, id > 3);
    ASSERT_EQ(ids_from(facts, 0), (std::vector<FactId>{2, id}));
  }
  EXPECT_EQ(facts.size(), 2U);
}

TEST(FactList, KeepsAFactsPlaceWhileOthersComeAndGo) {
  store::FactList facts;
  const store::StandingFact& first = facts.insert(fact_of(1));
  for (FactId id = 2; id < 10'000; ++id) facts.remove(facts.insert(fact_of(id)));
  EXPECT_EQ(facts.find(1), &first);
  EXPECT_EQ(first.fact.datum, fact_of(1).fact.datum);
  EXPECT_EQ(facts.size(), 1u);
}

// The marks that are gone through to come to the first fact.
std::ptrdiff_t marks_before_first(const store::FactList& facts) {
  const auto places = facts.from(0).base().base();
  return std::ranges::find_if(places, [](const auto& place) { return place.stands(); }) - places.begin();
}

TEST(FactList, TakingFromTheFrontGoesThroughNoMarks) {
  store::FactList facts;
  std::deque<store::StandingFact*> standing;
  for (FactId id = 1; id <= 4000; ++id) standing.push_back(&facts.insert(fact_of(id)));
  for (FactId id = 4001; !standing.empty(); ++id) {
    ASSERT_EQ(marks_before_first(facts), 0) << "before " << id;
    // Every third goes to the end instead, and comes around again a few times.
    if (id % 3 == 0) {
      facts.replace(*standing.front(), fact_of(id).fact);
      standing.push_back(standing.front());
    } else {
      facts.remove(*standing.front());
    }
    standing.pop_front();
  }
}

TEST(FactList, HasNoMoreMarksThanFactsWhereNoneCome) {
  store::FactList facts;
  std::vector<store::StandingFact*> standing;
  for (FactId id = 1; id <= 4000; ++id) standing.push_back(&facts.insert(fact_of(id)));
  for (std::size_t i = 1; i < standing.size(); ++i) {
    facts.remove(*standing[i]);
    ASSERT_LE(facts.from(0).base().base().size(), 2 * facts.size() + 65);
  }
}

}  // namespace
}  // namespace pizarra
