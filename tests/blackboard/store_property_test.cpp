#include <gtest/gtest.h>

#include "blackboard/journal/journal.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/watch/watch_table.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/store_model.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

const std::vector<Relation> relations = {relation("(relation at ((thing symbol) (place symbol)) (key thing))"),
                                         relation("(relation on ((upper symbol) (lower symbol)))"),
                                         relation("(relation mode ((name symbol)) (key))")};
const std::vector<std::string> queries = {"(on ?x ?y)",
                                          "(at a ?p)",
                                          "(and (on ?x ?y) (at ?x ?p))",
                                          "(and (on ?x ?y) (on ?y ?z))",
                                          "(and (on ?x ?y) (not (on ?z ?x)))",
                                          "(and (mode ?m) (not (at ?m ?)))",
                                          "(on ?x ?x)"};

// The same random operations on a store and on its model.
class Pair {
 public:
  explicit Pair(std::uint64_t seed) : random_(seed), model_(relations), watches_(store_) {
    store_.on_commit([this](const store::Commit& commit) {
      journal_ += journal::journal_line(commit) + "\n";
      watches_.committed(commit);
    });
    journal_ += journal::journal_line(0, {}, "test", relations) + "\n";
    EXPECT_TRUE(store_.declare(relations).has_value());
    for (const std::string& text : queries) {
      watched_.push_back({query(text), watches_.add(query(text), nullptr).value(), {}});
    }
  }

  void step() {
    now_ += Duration(random_.below(20));
    store_.expire(now_, now_);
    model_.pass_to(now_);
    switch (random_.below(8)) {
      case 0:
        return lease();
      case 1:
        return renew_or_release();
      case 2:
        return take();
      case 3:
        return settle();
      default:
        return transact();
    }
  }

  void compare() {
    std::multiset<std::pair<Datum, std::string>> held;
    std::multiset<std::pair<Datum, std::string>> expected;
    for (const auto& [name, table] : store_.tables()) {
      for (const store::StandingFact& standing : table.facts()) held.emplace(standing.fact.datum, standing.fact.teller);
    }
    for (const StoreModel::Entry& entry : model_.facts()) expected.emplace(entry.datum, entry.teller);
    ASSERT_EQ(held, expected);
    for (Watched& watched : watched_) compare_answers(watched);
  }

  // A store that the journal is replayed into ends like the one that wrote it.
  void compare_replayed() {
    store::Store replayed;
    const Result<std::string_view> result = journal::replay(journal_, replayed);
    ASSERT_TRUE(result.has_value()) << describe(result.error());
    EXPECT_EQ(replayed.revision(), store_.revision());
    for (const Relation& declared : relations) {
      const auto facts_of = [&](const store::Store& store) {
        std::vector<Fact> facts;
        for (const store::StandingFact& standing : store.tables().at(declared.name).facts())
          facts.push_back(standing.fact);
        return facts;
      };
      EXPECT_EQ(facts_of(replayed), facts_of(store_));
    }
  }

 private:
  struct Watched {
    Query query;
    std::unique_ptr<watch::WatchQueue> queue;
    std::map<std::vector<FactId>, Answer> known;
  };

  static std::vector<FactId> ids(const Answer& answer) {
    std::vector<FactId> ids;
    for (const Fact& fact : answer.facts) ids.push_back(fact.id);
    return ids;
  }

  void compare_answers(Watched& watched) {
    const auto written = [](const Bindings& bindings) {
      std::string text;
      for (const auto& [variable, value] : bindings.all()) text += write(variable) + "=" + write(value) + " ";
      return text;
    };
    std::multiset<std::string> expected;
    for (const Bindings& bindings : model_.answers(watched.query)) expected.insert(written(bindings));
    std::multiset<std::string> asked;
    const Result<Answers> answers = store_.ask(watched.query);
    for (const Answer& answer : answers->answers) asked.insert(written(answer.bindings));
    ASSERT_EQ(asked, expected) << write(query_to_datum(watched.query));
    while (watched.queue->ready()) {
      const Change change = watched.queue->pop().value();
      if (change.resynchronised) watched.known.clear();
      for (const Answer& answer : change.removed) ASSERT_EQ(watched.known.erase(ids(answer)), 1U);
      for (const Answer& answer : change.added) ASSERT_TRUE(watched.known.emplace(ids(answer), answer).second);
    }
    std::multiset<std::string> followed;
    for (const auto& [key, answer] : watched.known) followed.insert(written(answer.bindings));
    ASSERT_EQ(followed, expected) << "watching " << write(query_to_datum(watched.query));
  }

  Datum symbol() { return Datum::symbol(std::string(1, static_cast<char>('a' + random_.below(5)))); }
  Datum part(bool pattern) { return pattern && random_.below(3) == 0 ? Datum::symbol("?") : symbol(); }
  Datum fact_or_pattern(bool pattern) {
    const Relation& chosen = relations[random_.below(relations.size())];
    if (chosen.arguments.size() == 1) return list(Datum::symbol(chosen.name), part(pattern));
    const Datum first = part(pattern);
    return list(Datum::symbol(chosen.name), first, part(pattern));
  }
  LeaseId some_lease() { return leases_.empty() ? 0 : leases_[random_.below(leases_.size())]; }

  void transact() {
    Transaction transaction;
    if (random_.below(3) == 0) transaction.require(Transaction::Present{fact_or_pattern(true)});
    if (random_.below(3) == 0) transaction.require(Transaction::Absent{fact_or_pattern(true)});
    for (std::uint64_t steps = random_.below(4); steps > 0; --steps) {
      if (random_.below(4) == 0) {
        transaction.retract(fact_or_pattern(true));
      } else {
        transaction.tell(fact_or_pattern(false), {}, random_.below(4) == 0 ? some_lease() : 0);
      }
    }
    const std::string teller = random_.below(2) == 0 ? "alice" : "bob";
    const Result<Revision> result = store_.transact(teller, transaction, now_);
    ASSERT_EQ(result.has_value(), model_.transact(teller, transaction));
  }

  void lease() {
    const Duration length(1 + random_.below(200));
    leases_.push_back(store_.lease(length, now_).value());
    lengths_[leases_.back()] = length;
    model_.lease(leases_.back(), now_ + length);
  }

  void renew_or_release() {
    const LeaseId chosen = some_lease();
    const bool known = model_.has_lease(chosen);
    if (random_.below(2) == 0) {
      ASSERT_EQ(store_.renew(chosen, now_).has_value(), known);
      if (known) model_.renew(chosen, now_ + lengths_[chosen]);
    } else {
      ASSERT_EQ(store_.release(chosen, now_).has_value(), known);
      if (known) model_.lapse(chosen);
    }
  }

  void take() {
    const LeaseId holder = some_lease();
    if (holder == 0) return;
    const Datum pattern = fact_or_pattern(true);
    const Result<std::optional<Fact>> taken = store_.take("carol", pattern, holder, now_);
    ASSERT_EQ(taken.has_value(), model_.has_lease(holder));
    if (!taken) return;
    const std::optional<Datum> expected = model_.take(pattern, holder, *taken ? (*taken)->id : 0);
    ASSERT_EQ(*taken ? std::optional((*taken)->datum) : std::nullopt, expected);
    if (*taken) taken_.push_back((*taken)->id);
  }

  void settle() {
    if (taken_.empty()) return;
    const FactId chosen = taken_[random_.below(taken_.size())];
    Transaction transaction;
    transaction.settle(chosen);
    ASSERT_EQ(store_.transact("carol", transaction, now_).has_value(), model_.settle(chosen));
  }

  Random random_;
  Time now_{};
  store::Store store_;
  StoreModel model_;
  watch::WatchTable watches_;
  std::vector<Watched> watched_;
  std::vector<LeaseId> leases_;
  std::map<LeaseId, Duration> lengths_;
  std::vector<FactId> taken_;
  std::string journal_;
};

TEST(StoreProperty, RandomOperationsDoWhatTheModelDoes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Pair pair(seed);
    for (int step = 0; step < 250; ++step) {
      pair.step();
      if (step % 5 == 0) pair.compare();
      if (testing::Test::HasFatalFailure()) FAIL() << "after step " << step;
    }
    pair.compare();
    pair.compare_replayed();
    if (testing::Test::HasFailure()) return;
  }
}

TEST(StoreProperty, IndexesFindWhatLookingThroughFinds) {
  const Relation wide = relation("(relation wide ((a integer) (b integer) (c integer) (d integer)))");
  Random random(3);
  store::Store store;
  ASSERT_TRUE(store.declare({wide}).has_value());
  StoreModel model({wide});
  const auto number = [&] { return to_datum(random.below(4)); };
  for (int round = 0; round < 400; ++round) {
    Transaction transaction;
    std::vector<Datum> fact = {"wide"_sym, number(), number(), number(), number()};
    if (round % 4 == 0) {
      transaction.retract(Datum::list(fact));
    } else {
      transaction.tell(Datum::list(fact));
    }
    ASSERT_TRUE(store.transact("t", transaction, {}).has_value());
    model.transact("t", transaction);
    // Every one of the sixteen sets of bound arguments comes up, which is more than there are indexes.
    for (std::size_t i = 1; i < fact.size(); ++i) {
      if (random.below(2) == 0) fact[i] = Datum::symbol("?v" + std::to_string(i));
    }
    Query asked;
    asked.clauses.push_back({Query::Clause::Kind::fact, Datum::list(fact)});
    ASSERT_EQ(store.ask(asked)->answers.size(), model.answers(asked).size()) << write(Datum::list(fact));
  }
}

// Says by its facts' ids what answers there are, in their order: every choice of facts is looked at.
std::vector<std::vector<FactId>> looked_through(const Query& asked, const store::Tables& tables) {
  std::vector<std::pair<Datum, std::vector<FactId>>> found;
  const auto extend = [&](const auto& self, std::size_t clause, const Bindings& bindings,
                          const std::vector<FactId>& ids) -> void {
    if (clause == asked.clauses.size()) {
      const Datum* value = asked.order.empty() ? nullptr : bindings.find(asked.order);
      return found.push_back({value == nullptr ? Datum() : *value, ids});
    }
    const auto& [kind, form] = asked.clauses[clause];
    if (kind == Query::Clause::Kind::compare) {
      if (store::holds(form, bindings)) self(self, clause + 1, bindings, ids);
      return;
    }
    for (const store::StandingFact& standing : tables.find(form.head())->second.facts()) {
      Bindings both = bindings;
      if (!match(form, standing.fact.datum, both)) continue;
      std::vector<FactId> more = ids;
      more.push_back(standing.fact.id);
      self(self, clause + 1, both, more);
    }
  };
  extend(extend, 0, {}, {});
  std::ranges::stable_sort(found, [&](const auto& a, const auto& b) {
    if (asked.order.empty()) return false;
    return asked.descending ? store::compare_values(b.first, a.first) < 0 : store::compare_values(a.first, b.first) < 0;
  });
  std::vector<std::vector<FactId>> ids;
  for (const auto& [value, facts] : found) ids.push_back(facts);
  if (asked.limit && ids.size() > *asked.limit) ids.resize(*asked.limit);
  return ids;
}

TEST(StoreProperty, ComparisonsOrdersAndLimitsFindWhatLookingThroughFinds) {
  const std::vector<Relation> measured = {relation("(relation wide ((a datum) (b number) (c datum)))"),
                                          relation("(relation next ((a datum) (b datum)) (key a))")};
  const std::vector<std::string> values = {"1", "1.0", "2", "2.5", "-3", "-0.0", "0", "0.0", "7", "8", "9", "12.25"};
  constexpr std::uint64_t seed = 17;
  Random random(seed);
  store::Store store;
  ASSERT_TRUE(store.declare(measured).has_value());
  const auto one_of = [&](const std::vector<std::string>& choices) { return choices[random.below(choices.size())]; };
  const auto any = [&] { return random.below(5) == 0 ? one_of({"x", "(f 1)", "\"s\""}) : one_of(values); };
  const auto pattern = [&](const std::string& a, const std::string& b) {
    const auto part = [&](const std::string& v) { return random.below(5) == 0 ? one_of(values) : v; };
    if (random.below(3) == 0) return "(next " + part(a) + " " + part(b) + ")";
    return "(wide " + part(a) + " " + part(b) + " " + part(one_of({"?c", "?", a})) + ")";
  };
  std::size_t answered = 0;
  for (int round = 0; round < 2000; ++round) {
    Transaction transaction;
    transaction.tell(read("(wide " + any() + " " + one_of(values) + " " + any() + ")"));
    transaction.tell(read("(next " + any() + " " + any() + ")"));
    if (round % 4 == 0) transaction.retract(read("(wide " + any() + " ? ?)"));
    ASSERT_TRUE(store.transact("t", transaction, {}).has_value());
    const bool joined = random.below(3) == 0;
    std::string text = "(query (and " + pattern("?a", "?b");
    if (joined) text += " " + pattern(one_of({"?a", "?d"}), one_of({"?b", "?e"}));
    for (std::uint64_t i = random.below(4); i > 0; --i) {
      const std::string variable = one_of({"?a", "?b", "?c", "?d"});
      const std::string other = one_of({"?a", "?b", "?e", one_of(values), one_of(values)});
      const std::string sides = random.below(2) == 0 ? variable + " " + other : other + " " + variable;
      text += " (" + one_of({"<", "<=", ">", ">=", "=", "=", "/="}) + " " + sides + ")";
    }
    text += ")";
    if (random.below(2) == 0)
      text += one_of({" (order ?a)", " (order (down ?a))", " (order ?b)", " (order (down ?b))"});
    if (random.below(2) == 0) text += " (limit " + std::to_string(random.below(5)) + ")";
    const Result<Query> asked = query_from_datum(read(text + ")"));
    if (!asked) continue;
    std::vector<std::vector<FactId>> ids;
    const Result<Answers> answers = store.ask(*asked);
    ASSERT_TRUE(answers.has_value()) << describe(answers.error());
    for (const Answer& answer : answers->answers) {
      ids.emplace_back();
      for (const Fact& fact : answer.facts) ids.back().push_back(fact.id);
    }
    ASSERT_EQ(ids, looked_through(*asked, store.tables())) << text << ", round " << round << " of seed " << seed;
    answered += ids.empty() ? 0 : 1;
  }
  EXPECT_GT(answered, 500U);
}

// How many facts a question looks at among so many.
std::size_t looked_at(const std::string& text, int facts) {
  store::Store store;
  EXPECT_TRUE(store.declare({relation("(relation e ((a integer) (b integer)))")}).has_value());
  for (int n = 0; n < facts;) {
    Transaction transaction;
    for (const int last = n + 1000; n < last; ++n) transaction.tell(list("e"_sym, n, n % 100));
    EXPECT_TRUE(store.transact("t", transaction, {}).has_value());
  }
  std::size_t examined = 0;
  const Result<std::vector<Answer>> answers = store::evaluate(query(text), store.tables(), examined);
  EXPECT_TRUE(answers.has_value());
  EXPECT_FALSE(answers->empty()) << text;
  return examined;
}

TEST(StoreProperty, AQuestionLooksAtFactsByItsAnswersHoweverManyThereAre) {
  for (const std::string text :
       {"(and (e ?a ?b) (= ?a 900))", "(and (e ?a ?b) (>= ?a 990) (< ?a 1000))", "(and (e ?a ?b) (< ?a 3) (> ?a 0))",
        "(and (e ?a ?b) (e ?c ?d) (= ?a 1) (= ?c 900))", "(and (e ?a ?b) (= 7 ?a) (e ?c ?d) (= ?c ?b))",
        "(query (e ?a ?b) (order (down ?a)) (limit 1))", "(query (e ?a ?b) (order ?a) (limit 5))",
        "(query (e ?a ?b) (limit 2))", "(query (and (e ?a ?b) (> ?a 0)) (limit 2))",
        "(query (and (e ?a ?b) (= ?a 900)) (order ?b) (limit 1))",
        "(query (and (e ?a ?b) (> ?a 300) (< ?a 900)) (order (down ?a)) (limit 3))"}) {
    const std::size_t among_few = looked_at(text, 1000);
    EXPECT_LT(among_few, 100U) << text;
    EXPECT_EQ(looked_at(text, 9000), among_few) << text;
  }
}

}  // namespace
}  // namespace pizarra
