#include <algorithm>
#include <gtest/gtest.h>

#include "blackboard/client/clock_offset.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/memory/client_requests.hpp"
#include "blackboard/memory/latencies.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "blackboard/watch/watch_queue.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

Relation named(const std::string& name) {
  return {.name = name, .arguments = {{"n", ArgumentType::integer}}, .key = {0}, .durable = false, .lease = {}};
}

TEST(Latencies, AreKnownToAFifthOfThemselves) {
  constexpr std::uint64_t seed = 4;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  memory::Latencies latencies;
  std::vector<std::int64_t> took;
  for (int i = 0; i < 1000; ++i) {
    took.push_back(static_cast<std::int64_t>(random.below(1U << (4 + random.below(16)))));
    latencies.add(Duration(took.back()), Time(1s));
  }
  std::ranges::sort(took);
  const memory::Latencies::Summary summary = latencies.summary(Time(2s));
  EXPECT_EQ(summary.count, 1000U);
  const auto near = [](Duration said, std::int64_t exact) {
    return said.count() >= exact - 1 && static_cast<double>(said.count()) <= 1.2 * static_cast<double>(exact) + 1;
  };
  EXPECT_TRUE(near(summary.p50, took[499])) << summary.p50.count() << " of " << took[499];
  EXPECT_TRUE(near(summary.p90, took[899])) << summary.p90.count() << " of " << took[899];
  EXPECT_TRUE(near(summary.p99, took[989])) << summary.p99.count() << " of " << took[989];
}

TEST(Latencies, AreThoseOfTheLastTwentySecondsAtMost) {
  memory::Latencies latencies;
  latencies.add(100us, Time(100s));
  EXPECT_EQ(latencies.summary(Time(112s)).count, 1U);
  latencies.add(200us, Time(113s));
  EXPECT_EQ(latencies.summary(Time(119s)).count, 2U);
  EXPECT_EQ(latencies.summary(Time(125s)).count, 1U);
  EXPECT_EQ(latencies.summary(Time(200s)).count, 0U);
  latencies.add(std::chrono::hours(3), Time(200s));
  latencies.add(-5s, Time(200s));
  EXPECT_EQ(latencies.summary(Time(200s)).count, 2U);
}

TEST(ClockOffset, IsSaidBestByTheQuickestAnswer) {
  client::ClockOffset other;
  EXPECT_FALSE(other.there(Time(1s)));
  other.heard(Time(10s), Time(10s + 100ms), Time(5s + 50ms));
  EXPECT_EQ(other.there(Time(20s)), Time(15s));
  other.heard(Time(11s), Time(11s + 400ms), Time(6s + 1ms));
  EXPECT_EQ(other.there(Time(20s)), Time(15s)) << "a slower answer says it less well";
  other.heard(Time(12s), Time(12s + 10ms), Time(7s + 6ms));
  EXPECT_EQ(other.there(Time(20s)), Time(15s + 1ms));
  other.heard(Time(50s), Time(50s + 300ms), Time(46s + 150ms));
  EXPECT_EQ(other.there(Time(60s)), Time(56s)) << "clocks drift: what was said long ago counts no more";
}

TEST(Statistics, CountWhatOneTransactionChangesOfSeveralRelations) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  ASSERT_TRUE(board.declare("test", {named("one"), named("two")}).has_value());
  Transaction first;
  first.tell(list("one"_sym, 1)).tell(list("two"_sym, 1)).tell(list("one"_sym, 2));
  Transaction second;
  second.retract(list("one"_sym, "?"_sym)).tell(list("two"_sym, 2)).tell(list("one"_sym, 3));
  ASSERT_TRUE(board.transact("alice", first).has_value());
  ASSERT_TRUE(board.transact("bob", second).has_value());
  const auto said_of = [&](const char* relation) {
    const Datum said = board.ask(query(std::string("(query (relation-stats ") + relation + " ? ? ? ? ? ?))"))
                           ->answers.front()
                           .facts.front()
                           .datum;
    return list(said[2], said[3], said[4], said[6]);
  };
  EXPECT_EQ(said_of("one"), read("(1 3 2 ((\"alice\" 2) (\"bob\" 1)))"));
  EXPECT_EQ(said_of("two"), read("(2 2 0 ((\"alice\" 1) (\"bob\" 1)))"));
}

TEST(Statistics, SayWhoAskedForFactsAndWhoTookThem) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  ASSERT_TRUE(board.declare("test", {named("job"), named("hint")}).has_value());
  Transaction jobs;
  jobs.tell(list("job"_sym, 1)).tell(list("job"_sym, 2)).tell(list("job"_sym, 3));
  ASSERT_TRUE(board.transact("alice", jobs).has_value());
  ASSERT_TRUE(board.take("bob", list("job"_sym, "?n"_sym), 0).value().has_value());
  ASSERT_TRUE(board.take("bob", list("job"_sym, "?n"_sym), 0).value().has_value());
  ASSERT_TRUE(board.take("carol", list("job"_sym, "?n"_sym), 0).value().has_value());
  ASSERT_FALSE(board.take("carol", list("job"_sym, "?n"_sym), 0).value().has_value());
  board.ask(query("(and (job ?n) (not (hint ?n)))"), "dan").value();
  board.ask(query("(job ?n)"), "dan").value();
  board.ask(query("(job ?n)")).value();
  const auto said_of = [&](const char* relation) {
    return board.ask(query(std::string("(reader-stats ") + relation + " ? ?)"))->answers.front().facts.front().datum;
  };
  EXPECT_EQ(said_of("job"), read("(reader-stats job ((\"dan\" 2)) ((\"bob\" 2) (\"carol\" 1)))"));
  EXPECT_EQ(said_of("hint"), read("(reader-stats hint ((\"dan\" 1)) ())"));
}

TEST(Statistics, SayWhatWaitsForEachWatcher) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  ASSERT_TRUE(board.declare("test", {relation("(relation note ((n integer) (text datum)) (key n))")}).has_value());
  const auto fast = board.watch("fast", query("(note ?n ?text)"), [] {}).value();
  const auto slow = board.watch("slow", query("(and (note ?n ?text) (not (note ?n a)))"), [] {}).value();
  const auto also_slow = board.watch("slow", query("(note 1 ?text)"), [] {}).value();
  for (watch::WatchQueue* queue : {fast.get(), slow.get(), also_slow.get()}) queue->pop().value();
  for (int n = 0; n < 3; ++n) {
    Transaction transaction;
    transaction.tell(list("note"_sym, n, "x"_sym));
    ASSERT_TRUE(board.transact("test", transaction).has_value());
    fast->pop().value();
  }
  const auto said_of = [&](const std::string& watcher) {
    const Result<Answers> answers = board.ask(query("(watcher-stats \"" + watcher + "\" ?watches ?queued ?bytes)"));
    return answers->answers.front().facts.front().datum;
  };
  EXPECT_EQ(said_of("fast"), read("(watcher-stats \"fast\" 1 0 0)"));
  EXPECT_EQ(said_of("slow")[2], to_datum(2)) << "a watch of two patterns is one";
  EXPECT_EQ(said_of("slow")[3], to_datum(4));
  EXPECT_GT(said_of("slow")[4].integer(), 0);
  EXPECT_EQ(board.ask(query("(and (watcher-stats ?w ? ? ?) (note ?n ?))")).error().symbol, "bad-query");
  EXPECT_EQ(board.declare("test", {relation("(relation journey ((n integer)))")}).has_value(), true);
  EXPECT_FALSE(relation_from_datum(read("(relation watcher-stats ((n integer)))")).has_value());
}

// However many there are, and whatever they are called.
TEST(Statistics, FitAnAnswerWhateverClientsDo) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  // Quotes are written with two letters each.
  const auto name_of = [](std::size_t n, char filling) {
    const std::string number = std::to_string(n);
    return number + std::string(limits::name_bytes - number.size(), filling);
  };
  const auto relation_of = [&](std::size_t n) { return "r" + name_of(n, 'x').substr(1); };
  std::vector<Relation> relations;
  for (std::size_t n = 0; n < limits::relations; ++n) relations.push_back(named(relation_of(n + 10'000)));
  ASSERT_TRUE(board.declare("test", relations).has_value());
  EXPECT_EQ(board.declare("test", {named("one-more")}).error().symbol, "too-large");
  std::vector<std::unique_ptr<watch::WatchQueue>> watches;
  for (std::size_t who = 0; who < memory::Statistics::max_names + 1; ++who) {
    for (std::size_t n = 0; n < relations.size(); ++n) {
      const Datum form = Datum::symbol(relations[n].name);
      Transaction told;
      told.tell(list(form, who));
      ASSERT_TRUE(board.transact(name_of(who, '"'), told).has_value());
      if (who >= 16) continue;
      watches.push_back(board.watch(name_of(who, '"'), query_for(list(form, "?"_sym)), [] {}).value());
    }
  }
  for (const Relation& relation : relations) {
    board.statistics().came(relation.name, executor.now() - 5ms, executor.now());
    board.statistics().delivered(relation.name, 5ms, executor.now());
  }
  for (std::size_t n = 0; n < 2 * memory::ClientRequests::most_clients; ++n) {
    ASSERT_TRUE(board.statistics().requests().ask(name_of(n, '"'), executor.now()).has_value());
  }
  for (const auto& [asked, fewest] :
       {std::pair("(relation-stats ? ? ? ? ? ? ?)", relations.size()),
        std::pair("(reader-stats ? ? ?)", relations.size()), std::pair("(journey-stats ? ? ?)", relations.size()),
        std::pair("(watcher-stats ? ? ? ?)", std::size_t{16}),
        std::pair("(client-stats ? ? ? ?)", memory::ClientRequests::most_clients)}) {
    const Result<Answers> answers = board.ask(query(asked));
    ASSERT_TRUE(answers.has_value()) << asked << ": " << answers.error().sentence;
    EXPECT_GE(answers->answers.size(), fewest) << asked;
  }
}

TEST(Statistics, NameTheTellersAndWatchersOfACellOfUsualSize) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  std::vector<Relation> relations;
  for (int n = 0; n < 60; ++n) relations.push_back(named("relation-" + std::to_string(n)));
  ASSERT_TRUE(board.declare("test", relations).has_value());
  for (int who = 0; who < 20; ++who) {
    Transaction told;
    told.tell(list("relation-0"_sym, who));
    ASSERT_TRUE(board.transact("agent-" + std::to_string(who), told).has_value());
  }
  const Result<Answers> answers = board.ask(query("(relation-stats relation-0 ? ? ? ? ?tellers ?)"));
  EXPECT_EQ(answers->answers.front().bindings.find("?tellers")->size(), 20U);
}

TEST(Statistics, ForgetTheTellersThatAreGoneAndThenTheIdle) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  ASSERT_TRUE(board.declare("test", {named("noise")}).has_value());
  int noise = 0;
  const auto tell = [&](const std::string& who, int times = 1) {
    for (int n = 0; n < times; ++n) {
      Transaction told;
      told.tell(list("noise"_sym, ++noise));
      ASSERT_TRUE(board.transact(who, told).has_value());
    }
  };
  const auto told_by = [&](const std::string& who) -> std::int64_t {
    const Result<Answers> answers = board.ask(query("(relation-stats noise ? ? ? ? ?tellers ?)"));
    for (const Datum& teller : answers->answers.front().bindings.find("?tellers")->items()) {
      if (teller[0].text() == who) return teller[1].integer();
    }
    return 0;
  };
  tell("quiet", 2);
  for (std::size_t n = 0; n < 2 * memory::Statistics::max_names; ++n) {
    const std::string word = "prompt-" + std::to_string(n);
    tell(word);
    board.statistics().left(word);
  }
  tell("robot", 3000);
  EXPECT_EQ(told_by("robot"), 3000);
  EXPECT_EQ(told_by("quiet"), 2) << "it told before all the others, and is still there";
  for (std::size_t n = 0; n < memory::Statistics::max_names - 1; ++n) tell("agent-" + std::to_string(n));
  EXPECT_EQ(told_by("robot"), 3000);
  EXPECT_EQ(told_by("quiet"), 0) << "of as many as are named it told nothing for longest";
}

// There is no room for the names of all.
TEST(Statistics, NameThoseWhoAreThereBeforeThoseWhoAreGone) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  std::vector<Relation> relations;
  for (int n = 0; n < 60; ++n) relations.push_back(named("relation-" + std::to_string(n)));
  ASSERT_TRUE(board.declare("test", relations).has_value());
  Transaction told;
  told.tell(list("relation-0"_sym, 1));
  ASSERT_TRUE(board.transact("robot", told).has_value());
  for (std::size_t n = 0; n < memory::Statistics::max_names - 1; ++n) {
    const std::string word = "prompt-" + std::to_string(n);
    Transaction other;
    other.tell(list("relation-0"_sym, n + 2));
    ASSERT_TRUE(board.transact(word, other).has_value());
    board.statistics().left(word);
  }
  const Result<Answers> answers = board.ask(query("(relation-stats relation-0 ? ? ? ? ?tellers ?)"));
  const Datum* tellers = answers->answers.front().bindings.find("?tellers");
  EXPECT_LT(tellers->size(), memory::Statistics::max_names);
  EXPECT_EQ((*tellers)[tellers->size() - 1], list("robot", 1));
}

// How many of so many requests, `apart` from one another, were served.
int served(memory::ClientRequests& requests, const std::string& client, Time& now, int count, Duration apart) {
  int served = 0;
  for (int i = 0; i < count; ++i, now += apart) served += requests.ask(client, now).has_value() ? 1 : 0;
  return served;
}

TEST(ClientRequests, AloneAClientAsksAsFastAsItCan) {
  memory::ClientRequests requests;
  Time now(100s);
  EXPECT_EQ(served(requests, "alice", now, 100'000, 1us), 100'000);
}

TEST(ClientRequests, WhileOthersAskAFloodIsServedItsShareAndTheyAllThatTheyAsk) {
  memory::ClientRequests requests;
  requests.set_limit({.most = 100, .window = 100ms});
  Time now(100s);
  int flooder = 0;
  int polite = 0;
  // Ten thousand a second, and one each 50 ms.
  for (int i = 0; i < 20; ++i) {
    polite += served(requests, "polite", now, 1, 1us);
    flooder += served(requests, "flooder", now, 500, 100us);
  }
  EXPECT_EQ(polite, 20);
  EXPECT_GE(flooder, 900);
  EXPECT_LE(flooder, 1100);
  EXPECT_EQ(served(requests, "polite", now, 100, 1us), 100) << "a hundred at once";
  served(requests, "flooder", now, 100, 1us);
  EXPECT_EQ(requests.ask("flooder", now).error().symbol, "too-many");
  now += 1s;
  EXPECT_EQ(served(requests, "flooder", now, 5000, 10us), 5000) << "nobody else asks any more";
}

TEST(ClientRequests, AreCountedByTheSecond) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  memory::ClientRequests& requests = board.statistics().requests();
  requests.set_limit({.most = 2, .window = 100ms});
  for (int i = 0; i < 3; ++i) {
    [[maybe_unused]] const Result<void> first = requests.ask("alice", executor.now());
    [[maybe_unused]] const Result<void> second = requests.ask("bob", executor.now());
  }
  executor.run_for(1s);
  const Result<Answers> answers = board.ask(query("(client-stats ?client ?requests ?refused ?per-second)"));
  ASSERT_EQ(answers->answers.size(), 2U);
  EXPECT_EQ(answers->answers[0].facts.front().datum, read("(client-stats \"alice\" 3 1 3)"));
  EXPECT_EQ(answers->answers[1].facts.front().datum, read("(client-stats \"bob\" 3 1 3)"));
}

TEST(ClientRequests, OfMoreNamesThanAreKeptAreCountedTogether) {
  memory::ClientRequests requests;
  Time now(100s);
  for (std::size_t i = 0; i < memory::ClientRequests::most_clients + 10; ++i) {
    EXPECT_EQ(served(requests, "client-" + std::to_string(i), now, 1, 1us), 1);
  }
  EXPECT_EQ(requests.clients(now).at("others").requests, 10U);
  now += 61s;
  EXPECT_EQ(served(requests, "newcomer", now, 1, 1us), 1);
  EXPECT_LE(requests.clients(now).size(), 3U) << "who asked nothing for a minute is forgotten";
}

TEST(Statistics, CountWhatTheyAreMadeUpOfAndMakeUpWhatIsNamedAlone) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  std::vector<Relation> relations;
  for (int i = 0; i < 200; ++i) relations.push_back(named("relation-" + std::to_string(i)));
  ASSERT_TRUE(board.declare("test", relations).has_value());
  std::vector<std::unique_ptr<watch::WatchQueue>> queues;
  for (int i = 0; i < 1000; ++i) queues.push_back(board.watch("many", query("(relation-0 ?n)"), [] {}).value());
  queues.push_back(board.watch("few", query("(relation-1 ?n)"), [] {}).value());
  const auto looks_for = [&](const std::string& asked) {
    std::size_t examined = 0;
    EXPECT_TRUE(board.ask(query(asked), examined).has_value()) << asked;
    return examined;
  };
  EXPECT_GE(looks_for("(watcher-stats ?w ?a ?b ?c)"), queues.size());
  EXPECT_GE(looks_for("(watcher-stats \"many\" ?a ?b ?c)"), queues.size() - 1);
  EXPECT_LE(looks_for("(watcher-stats \"few\" ?a ?b ?c)"), 4U);
  EXPECT_LE(looks_for("(watcher-stats \"nobody\" ?a ?b ?c)"), 4U);
  EXPECT_GE(looks_for("(relation-stats ?r ?a ?b ?c ?d ?e ?f)"), 2 * relations.size());
  for (const std::string name : {"relation-0", "nothing"}) {
    EXPECT_LE(looks_for("(relation-stats " + name + " ?a ?b ?c ?d ?e ?f)"), 20U);
    EXPECT_LE(looks_for("(journey-stats " + name + " ?a ?b)"), 20U);
  }
  std::size_t spent = limits::examined;
  EXPECT_EQ(board.ask(query("(watcher-stats ?w ?a ?b ?c)"), spent).error().symbol, "too-costly");
  queues.resize(queues.size() - 2);
  EXPECT_EQ(board.ask(query("(watcher-stats ?w ?a ?b ?c)"))->answers.size(), 1U);
}

}  // namespace
}  // namespace pizarra
