// Facts are told in batches, stored, matched and forwarded to a watcher in another process, until it has the last of
// them. The peers are Redis SET pipelined by 64 and small messages through a ZeroMQ router.

#include <algorithm>

#include "blackboard/time/latch.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/brokers.hpp"
#include "tests/bench/blackboard/raw_zmq.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int batch = 64;
constexpr int batches = 3000;  // in a round
constexpr int in_flight = 32;  // batches told and not yet acknowledged
constexpr int section = 40;    // batches; at most two are told and have not reached the watcher
constexpr int objects = 4'000;

// Says so whenever a section's worth of facts has come.
Task<void> count_objects(Board& board, Pipe& parent) {
  Query query = query_from_datum(read_one("(seen ?name ?x ?y ?d)").value()).value();
  Result<std::unique_ptr<Watch>> watch = co_await board.watch(query);
  if (!watch) throw std::runtime_error(describe(watch.error()));
  bool watching = false;
  for (int come = 0;;) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) throw std::runtime_error(describe(change.error()));
    if (watching && change->resynchronised) throw std::runtime_error("the watcher lagged behind");
    watching = true;
    if (change->resynchronised) {
      parent.say(0);
      continue;
    }
    come += static_cast<int>(change->added.size());
    for (; come >= batch * section; come -= batch * section) parent.say(0);
  }
}

// What is told, and how far that may go.
struct Course {
  std::vector<Transaction> all;
  WaitList waiting;
  std::size_t allowed = 0;
  std::size_t next = 0;
};

Task<void> tell_batches(Board& board, Course& course) {
  while (course.next < course.all.size()) {
    if (course.next == course.allowed) {
      co_await course.waiting.wait();
      continue;
    }
    Transaction transaction = std::move(course.all[course.next++]);
    const Result<Revision> done = co_await board.transact(std::move(transaction));
    if (!done) throw std::runtime_error(describe(done.error()));
  }
}

std::vector<Transaction> prepared(int round) {
  std::vector<Transaction> all(batches);
  for (int i = 0; i < batch * batches; ++i) {
    all[static_cast<std::size_t>(i / batch)].tell(object_fact(i % objects, round * batches + i / objects));
  }
  return all;
}

double told_per_second(Client& client, Pipe& watcher, int round) {
  Course course{prepared(round), WaitList(client.executor())};
  const double seconds = seconds_of([&] {
    std::vector<Job> jobs;
    for (int i = 0; i < in_flight; ++i) jobs.push_back(client.executor().spawn(tell_batches(client.board(), course)));
    while (course.allowed < course.all.size()) {
      if (course.allowed >= 2 * section) watcher.hear();
      course.allowed += section;
      course.waiting.wake_all();
      client.executor().run_until([&] { return course.next == course.allowed; });
    }
    client.executor().run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
    for (int left = 0; left < 2; ++left) watcher.hear();
  });
  return batch * batches / seconds;
}

double set_per_second(RedisClient& client, int round) {
  std::vector<std::string> all(batches);
  for (int i = 0; i < batch * batches; ++i) {
    const std::string name(object_name(i % objects).text());
    std::string value = std::to_string(round * batches + i / objects);
    value.resize(26, 'x');
    all[static_cast<std::size_t>(i / batch)] += RedisClient::command({"SET", name, value});
  }
  const double seconds = seconds_of([&] {
    for (const std::string& commands : all) {
      client.send(commands);
      client.receive(batch);
    }
  });
  return batch * batches / seconds;
}

double routed_per_second(RawDealer& sender, Pipe& watcher) {
  const std::string payload(40, 'x');
  const double seconds = seconds_of([&] {
    for (int i = 0; i < batch * batches; ++i) {
      sender.send(payload);
      if (i >= batch * in_flight) sender.receive();
    }
    watcher.hear();
  });
  for (int i = 0; i < batch * in_flight; ++i) sender.receive();
  return batch * batches / seconds;
}

// Says so whenever a section's worth has come, and when it is ready, where the broker runs.
Child counter_of(const Broker& broker) {
  Child counter = Child::running([&](Pipe& parent) {
    if (!broker.runs()) return;
    const std::unique_ptr<BrokerClient> client = broker.connect(false);
    client->watch();
    parent.say(0);
    for (int come = 1;; ++come) {
      client->message();
      if (come % (batch * section) == 0) parent.say(0);
    }
  });
  if (broker.runs()) counter.pipe().hear();
  return counter;
}

// Nothing is stored, and nobody acknowledges: only the watcher holds the publisher back.
double published_per_second(BrokerClient& client, Pipe& watcher) {
  const std::string payload(40, 'x');
  const auto publish_section = [&] {
    for (int i = 0; i < batch * section; ++i) client.publish(payload);
    client.flush();
  };
  const double seconds = seconds_of([&] {
    publish_section();
    for (int told = section; told < batches; told += section) {
      publish_section();
      watcher.hear();
    }
    watcher.hear();
  });
  return batch * batches / seconds;
}

}  // namespace

void throughput(Figures& figures) {
  const RawRouter router;
  const BoardProcess server;
  const std::optional<RedisServer> redis = RedisServer::start();
  Child ours = Child::running([&](Pipe& parent) {
    Client client(server.address(), "watcher");
    client.run(count_objects(client.board(), parent));
  });
  ours.pipe().hear();
  Child raw = Child::running([&](Pipe& parent) {
    RawDealer dealer(router.address());
    dealer.watch();
    parent.say(0);
    for (int come = 1;; ++come) {
      dealer.receive();
      if (come % (batch * batches) == 0) parent.say(0);
    }
  });
  raw.pipe().hear();
  // CORBA's events go one by one, a call each: nothing is batched.
  const std::vector<Broker> brokers = start({nats(), mqtt()});
  std::vector<Child> counters;
  for (const Broker& broker : brokers) counters.push_back(counter_of(broker));
  Client teller(server.address(), "teller");
  RawDealer sender(router.address());
  std::optional<RedisClient> client;
  if (redis) client.emplace(redis->port());
  int round = 0;
  const auto tell = [&] { return told_per_second(teller, ours.pipe(), ++round); };
  const auto route = [&] { return routed_per_second(sender, raw.pipe()); };
  const auto set = [&] { return client ? set_per_second(*client, round) : 0; };
  std::vector<std::function<double()>> works = {tell, route, set};
  std::vector<std::unique_ptr<BrokerClient>> publishers;
  for (std::size_t i = 0; i < brokers.size(); ++i) {
    publishers.push_back(brokers[i].connect(false));
    const auto publish = [&, client = publishers.back().get(), i] {
      return client ? published_per_second(*client, counters[i].pipe()) : 0;
    };
    works.emplace_back(publish);
  }
  const std::vector<double> rates = medians_of_rounds(rounds, works);
  const std::optional<double> set_rate = redis ? std::optional(rates[2]) : std::nullopt;
  std::vector<Peer> peers = {{"zeromq", rates[1]}, {"redis", set_rate}};
  add_peers(peers, brokers, std::span(rates).subspan(3));
  const char* name = "facts stored, matched, forwarded";
  const char* limit =
      "what the board, the teller and the watcher compute for a fact: their sum over the cores there are";
  figures.say({name, rates[0], "1/s", at_least(1e6), peers, "", limit});
  const Goal goal =
      redis ? at_least(1.5 * rates[2], ">= 1.5 x Redis SET by 64") : not_comparable("redis is not installed");
  figures.say({name, rates[0], "1/s", goal, peers, "", limit});
}

}  // namespace pizarra::bench
