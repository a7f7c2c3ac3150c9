// Watches of several patterns are followed fact by fact. Here they are compared with what the query answers anew.

#include <gtest/gtest.h>

#include "blackboard/limits.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/watch/watch_table.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

const std::vector<Relation> relations = {
    relation("(relation on ((a datum) (b datum)))"), relation("(relation at ((a datum) (b datum)) (key a))"),
    relation("(relation big ((a datum)))"), relation("(relation mode ((a datum)) (key))"),
    relation("(relation seen ((a datum) (b datum) (c datum)) (key a b))")};

struct WatchedStore {
  WatchedStore() {
    store.on_commit([this](const store::Commit& commit) { watches.committed(commit); });
    EXPECT_TRUE(store.declare(relations).has_value());
  }

  store::Store store;
  watch::WatchTable watches{store};
};

std::string any_choice(Random& random, const std::vector<std::string>& choices) {
  return choices[random.below(choices.size())];
}

// A pattern, or a fact where there are no variables to choose from.
std::string pattern(Random& random, const std::vector<std::string>& variables) {
  const Relation& chosen = relations[random.below(relations.size())];
  std::string text = "(" + chosen.name;
  for (std::size_t i = 0; i < chosen.arguments.size(); ++i) {
    const bool variable = !variables.empty() && random.below(4) != 0;
    text += " " + (variable ? any_choice(random, variables) : any_choice(random, {"1", "2", "3", "2.5", "x"}));
  }
  return text + ")";
}

// Most of what chance writes is a query.
Query random_joined_query(Random& random) {
  while (true) {
    std::string text = "(and";
    for (std::uint64_t clauses = 1 + random.below(4); clauses > 0; --clauses) {
      const std::string fact = pattern(random, {"?x", "?y", "?z", "?"});
      const std::string comparison = any_choice(random, {"<", ">=", "=", "/="});
      const std::uint64_t kind = random.below(7);
      if (kind == 0) text += " (" + comparison + " ?x " + any_choice(random, {"?y", "?z", "2"}) + ")";
      if (kind == 1 || kind == 2) text += " (not " + fact + ")";
      if (kind > 2) text += " " + fact;
    }
    text = "(query " + text + ")";
    if (random.below(3) == 0) text += " " + any_choice(random, {"(order ?x)", "(order (down ?y))"});
    if (random.below(3) == 0) text += " (limit " + std::to_string(random.below(4)) + ")";
    const Result<Query> made = query_from_datum(read(text + ")"));
    if (made) return *made;
  }
}

std::vector<FactId> ids(const Answer& answer) {
  std::vector<FactId> ids;
  for (const Fact& fact : answer.facts) ids.push_back(fact.id);
  return ids;
}

struct Watched {
  Query query;
  std::unique_ptr<watch::WatchQueue> queue;
  std::set<std::vector<FactId>> known;

  void follow(bool first) {
    while (queue->ready()) {
      const Change change = queue->pop().value();
      ASSERT_EQ(change.resynchronised, first);
      for (const Answer& answer : change.removed) ASSERT_EQ(known.erase(ids(answer)), 1U);
      for (const Answer& answer : change.added) ASSERT_TRUE(known.insert(ids(answer)).second);
      ASSERT_TRUE(first || change.added.size() + change.removed.size() > 0);
    }
  }
  void compare(const store::Store& store) const {
    std::set<std::vector<FactId>> anew;
    const Result<Answers> answers = store.ask(query);
    for (const Answer& answer : answers->answers) anew.insert(ids(answer));
    ASSERT_EQ(known, anew) << write(query_to_datum(query));
  }
};

void commit_something(Random& random, store::Store& store, std::vector<LeaseId>& leases) {
  const LeaseId lease = leases[random.below(leases.size())];
  if (random.below(12) == 0) {
    static_cast<void>(store.release(lease, {}).has_value());
    leases.push_back(store.lease(1s, {}).value());
    return;
  }
  if (random.below(8) == 0) {
    static_cast<void>(store.take("taker", read(pattern(random, {"?"})), leases.back(), {}).has_value());
    return;
  }
  Transaction transaction;
  for (std::uint64_t steps = 1 + random.below(4); steps > 0; --steps) {
    if (random.below(3) == 0) {
      transaction.retract(read(pattern(random, {"?"})));
    } else {
      transaction.tell(read(pattern(random, {})), {}, random.below(4) == 0 && store.stands(lease) ? lease : 0);
    }
  }
  ASSERT_TRUE(store.transact("teller", transaction, {}).has_value());
}

TEST(JoinedWatch, FollowsWhateverChangesAsAnsweringAnewWould) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    WatchedStore both;
    auto& [store, watches] = both;
    std::vector<LeaseId> leases = {store.lease(1s, {}).value()};
    std::vector<Watched> watched;
    for (int i = 0; i < 8; ++i) {
      const Query query = random_joined_query(random);
      watched.push_back({query, watches.add(query, nullptr).value(), {}});
      watched.back().follow(true);
    }
    for (int step = 0; step < 120 && !testing::Test::HasFailure(); ++step) {
      commit_something(random, store, leases);
      for (Watched& watch : watched) {
        watch.follow(false);
        watch.compare(store);
      }
    }
    if (testing::Test::HasFailure()) return;
  }
}

// The order of the answers that came at once.
TEST(JoinedWatch, SaysWhatComesInTheOrderOfTheQuery) {
  WatchedStore both;
  auto& [store, watches] = both;
  const auto queue = watches.add(query("(query (and (big ?x) (mode ?m)) (order (down ?x)))"), nullptr).value();
  queue->pop().value();
  Transaction transaction;
  for (const char* fact : {"(big 2)", "(big 10)", "(big 2.5)", "(mode 1)"}) transaction.tell(read(fact));
  ASSERT_TRUE(store.transact("teller", transaction, {}).has_value());
  std::vector<Datum> came;
  const Change change = queue->pop().value();
  for (const Answer& answer : change.added) came.push_back(*answer.bindings.find("?x"));
  EXPECT_EQ(came, (std::vector<Datum>{to_datum(10), Datum::real(2.5), to_datum(2)}));
}

// How many facts are looked at to follow a hundred changes of a hundred chains of facts, among `size` others that are
// no part of any.
std::uint64_t facts_looked_at(const std::string& watched, int size) {
  WatchedStore both;
  auto& [store, watches] = both;
  for (int i = 0; i < size; ++i) {
    const std::string n = std::to_string(i);
    Transaction chain;
    if (i < 100) chain.tell(read("(on " + n + " link-" + n + ")")).tell(read("(at link-" + n + " place-" + n + ")"));
    chain.tell(read("(on loose-" + n + " end)")).tell(read("(at start-" + n + " place-" + n + ")"));
    EXPECT_TRUE(store.transact("teller", chain, {}).has_value());
  }
  const auto queue = watches.add(query(watched), nullptr).value();
  queue->pop().value();
  for (int i = 0; i < 100; ++i) {
    const std::string n = std::to_string(i % 50);
    Transaction change;
    if (i % 3 == 0) change.tell(read("(at link-" + n + " elsewhere-" + std::to_string(i) + ")"));
    if (i % 3 == 1) change.retract(read("(on " + n + " ?)")).tell(read("(on fresh-" + n + " link-" + n + ")"));
    if (i % 3 == 2) change.tell(read("(big link-" + n + ")")).retract(read("(big ?)"));
    if (i % 3 == 2) change.tell(read("(big place-" + n + ")"));
    EXPECT_TRUE(store.transact("teller", change, {}).has_value());
    while (queue->ready()) EXPECT_FALSE(queue->pop().value().resynchronised);
  }
  return queue->examined();
}

TEST(JoinedWatch, CostsWhatAChangeConcernsHoweverMuchIsOnTheBoard) {
  for (const std::string watched :
       {"(and (on ?x ?y) (at ?y ?z))", "(and (on ?x ?y) (not (big ?y)) (at ?y ?z))",
        "(and (at ?y ?z) (not (big ?z)) (on ?x ?y) (/= ?x 7))", "(query (and (on ?x ?y) (at ?y ?z)) (order ?z))"}) {
    const std::uint64_t among_few = facts_looked_at(watched, 200);
    EXPECT_GT(among_few, 0U);
    EXPECT_LT(among_few, 5000U);
    EXPECT_EQ(facts_looked_at(watched, 4000), among_few) << watched;
  }
}

// However many watches a commit concerns, it has so many facts looked at; who is left out begins anew in its own turn.
TEST(JoinedWatch, AllTogetherLookAtABoundedNumberOfFactsToFollowACommit) {
  WatchedStore both;
  auto& [store, watches] = both;
  constexpr int facts = 60'000;
  for (int n = 0; n < facts; n += 5000) {
    Transaction some;
    for (int i = n; i < n + 5000; ++i) some.tell(list("on"_sym, i, -i));
    ASSERT_TRUE(store.transact("teller", some, {}).has_value());
  }
  const Query all_over = query("(and (mode ?m) (on ?x ?y) (big ?y))");
  const Query cheap = query("(and (mode ?m) (at 1 ?z))");
  std::vector<std::unique_ptr<watch::WatchQueue>> queues;
  constexpr std::size_t readers = 5;
  for (std::size_t reader = 0; reader < readers; ++reader) {
    const auto backlog = std::make_shared<watch::Backlog>();
    for (int i = 0; i < 4; ++i) queues.push_back(watches.add(all_over, nullptr, "greedy", backlog).value());
  }
  const auto modest = watches.add(cheap, nullptr).value();
  for (const auto& queue : queues) queue->pop().value();
  modest->pop().value();
  ASSERT_TRUE(store.transact("teller", Transaction().tell(read("(at 1 here)")), {}).has_value());
  ASSERT_TRUE(store.transact("teller", Transaction().tell(read("(big -7)")).tell(read("(mode 1)")), {}).has_value());
  std::uint64_t examined = 0;
  std::size_t followed = 0;
  for (const auto& queue : queues) {
    examined += queue->examined();
    const Change change = queue->pop().value();
    followed += change.resynchronised ? 0 : 1;
    EXPECT_EQ(change.added.size(), 1U);
  }
  EXPECT_LE(examined, limits::examined + readers * (limits::examined_a_turn + 4));
  EXPECT_GE(followed, limits::examined / facts / 3);
  EXPECT_LT(followed, queues.size());
  const Change change = modest->pop().value();
  EXPECT_FALSE(change.resynchronised);
  EXPECT_EQ(change.added.size(), 1U);
}

TEST(JoinedWatch, MissesNothingWhereWhatItIsJoinedWithHasManyValuesOrFewAgain) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    WatchedStore both;
    auto& [store, watches] = both;
    std::vector<Watched> watched;
    const auto begin_watches = [&] {
      for (const char* text : {"(and (seen 7 ?s ?) (on ?s ?v))", "(and (seen 7 ?s ?) (not (on ?s 1)))",
                               "(query (and (on ?s ?v) (seen 7 ?s ?)) (limit 3))", "(and (on 1 ?s) (seen 7 ?s ?))"}) {
        watched.push_back({query(text), watches.add(query(text), nullptr).value(), {}});
        watched.back().follow(true);
      }
    };
    begin_watches();
    for (int step = 0; step < 300 && !testing::Test::HasFailure(); ++step) {
      // First more and more of them come, then go.
      const bool comes = step < 150;
      const std::string thing = std::to_string(random.below(40)) + (random.below(4) == 0 ? ".0" : "");
      const std::string key = "(seen " + any_choice(random, {"7", "8"}) + " " + thing;
      Transaction change;
      if (random.below(3) == 0 || comes) change.tell(read(key + " " + std::to_string(step) + ")"));
      if (random.below(3) == 0 || !comes) change.retract(read(key + " ?)"));
      if (random.below(2) == 0) change.tell(read("(on " + thing + " " + std::to_string(random.below(3)) + ")"));
      if (random.below(2) == 0) change.retract(read("(on " + thing + " ?)"));
      ASSERT_TRUE(store.transact("teller", change, {}).has_value());
      if (step == 100 || step == 280) begin_watches();
      for (Watched& watch : watched) {
        watch.follow(false);
        watch.compare(store);
      }
    }
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace pizarra
