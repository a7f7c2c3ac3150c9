// From telling a fact to its arrival at a watcher in another process, with 10,000 other watches on the board, against a
// message that a ZeroMQ router forwards.

#include <cstring>
#include <fmt/format.h>

#include "lisp/reader.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/brokers.hpp"
#include "tests/bench/blackboard/raw_zmq.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int tells = 1000;  // in a round
constexpr int other_clients = 50;
constexpr int watches_each = 200;

Query parse(const std::string& text) { return query_from_datum(read_one(text).value()).value(); }

// Says the median after every round's worth of latencies.
class Medians {
 public:
  explicit Medians(Pipe& parent) : parent_(parent) {}
  void add(double sent_us) {
    took_us_.push_back(now_us() - sent_us);
    if (took_us_.size() < tells) return;
    parent_.say(percentile(took_us_, 0.5));
    took_us_.clear();
  }

 private:
  Pipe& parent_;
  std::vector<double> took_us_;
};

Task<void> watch_objects(Board& board, Pipe& parent) {
  Query query = parse("(seen \"watched\" ?x ?y ?d)");
  Result<std::unique_ptr<Watch>> watch = co_await board.watch(query);
  if (!watch) throw std::runtime_error(describe(watch.error()));
  co_await (*watch)->next();
  parent.say(0);
  Medians medians(parent);
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) throw std::runtime_error(describe(change.error()));
    for (const Answer& answer : change->added) medians.add(answer.facts[0].datum[2].number());
  }
}

// Of other objects, of other values, of another relation, and of what is not there.
std::string other_query(int number) {
  switch (number % 4) {
    case 0:
      return fmt::format("(seen \"other-{}\" ?x ?y ?d)", number);
    case 1:
      return fmt::format("(seen ?name ?x ?y {})", 1'000'000 + number);
    case 2:
      return fmt::format("(and (elsewhere ?a ?b) (> ?b {}))", number);
    default:
      return fmt::format("(and (elsewhere ?a {}) (not (seen \"other-{}\" ?x ?y ?d)))", number, number);
  }
}

Task<void> watch_others(Board& board, int first, int& watching) {
  std::vector<std::unique_ptr<Watch>> watches;
  for (int i = 0; i < watches_each; ++i) {
    Query query = parse(other_query(first + i));
    Result<std::unique_ptr<Watch>> watch = co_await board.watch(query);
    if (!watch) throw std::runtime_error(describe(watch.error()));
    co_await (*watch)->next();
    watches.push_back(std::move(*watch));
  }
  ++watching;
  co_await std::suspend_always();
}

void be_the_others(Pipe& parent, const std::string& address) {
  RealExecutor executor;
  std::vector<std::unique_ptr<client::RemoteBoard>> boards;
  std::vector<Job> jobs;
  int watching = 0;
  for (int i = 0; i < other_clients; ++i) {
    boards.push_back(client::RemoteBoard::connect(executor, address, fmt::format("other-{}", i)).value());
    jobs.push_back(executor.spawn(watch_others(*boards.back(), i * watches_each, watching)));
    executor.run_until([&] { return watching == i + 1; });
  }
  parent.say(0);
  executor.run_until([] { return false; });
}

Task<void> tell_often(Board& board) {
  for (int i = 0; i < tells; ++i) {
    Datum fact = list("seen"_sym, "watched", now_us(), 87.5, i);
    const Result<Revision> told = co_await board.tell(fact);
    if (!told) throw std::runtime_error(describe(told.error()));
  }
}

// Says how long each message took. Ready when it has said so, where the broker runs.
Child listener_of(const Broker& broker) {
  Child listener = Child::running([&](Pipe& parent) {
    if (!broker.runs()) return;
    const std::unique_ptr<BrokerClient> client = broker.connect(false);
    client->watch();
    parent.say(0);
    while (true) {
      const double sent_us = std::stod(client->message());
      parent.say(now_us() - sent_us);
    }
  });
  if (broker.runs()) listener.pipe().hear();
  return listener;
}

}  // namespace

void tell_to_watcher(Figures& figures) {
  const RawRouter router;
  const BoardProcess server;
  const std::optional<RedisServer> redis = RedisServer::start();
  Child ours = Child::running([&](Pipe& parent) {
    Client client(server.address(), "watcher");
    client.run(watch_objects(client.board(), parent));
  });
  ours.pipe().hear();
  Child raw = Child::running([&](Pipe& parent) {
    RawDealer dealer(router.address());
    dealer.watch();
    parent.say(0);
    for (Medians medians(parent);;) medians.add(std::stod(std::string(dealer.receive())));
  });
  raw.pipe().hear();
  Child subscriber = Child::running([&](Pipe& parent) {
    if (!redis) return;
    RedisClient client(redis->port());
    client.call({"SUBSCRIBE", "seen"});
    client.receive(3);
    parent.say(0);
    for (Medians medians(parent);;) medians.add(std::stod(client.message()));
  });
  if (redis) subscriber.pipe().hear();
  const std::vector<Broker> brokers = start({nats(), mqtt(), omni_events()});
  std::vector<Child> listeners;
  for (const Broker& broker : brokers) listeners.push_back(listener_of(broker));
  Child others = [&] {
    {
      Client client(server.address(), "teller");
      const std::vector<Relation> elsewhere = {
          relation_from_datum(read_one("(relation elsewhere ((a symbol) (b number)))").value()).value()};
      client.run(client.board().declare(elsewhere));
    }
    return Child::running([&](Pipe& parent) { be_the_others(parent, server.address()); });
  }();
  others.pipe().hear();

  Client teller(server.address(), "teller");
  RawDealer dealer(router.address());
  std::optional<RedisClient> publisher;
  if (redis) publisher.emplace(redis->port());
  const auto stamped = [] { return fmt::format("{:<40.2f}", now_us()); };
  const auto tell = [&] {
    teller.run(tell_often(teller.board()));
    return ours.pipe().hear();
  };
  const auto forward = [&] {
    for (int i = 0; i < tells; ++i) {
      dealer.send(stamped());
      dealer.receive();
    }
    return raw.pipe().hear();
  };
  const auto publish = [&] {
    for (int i = 0; publisher && i < tells; ++i) publisher->call({"PUBLISH", "seen", stamped()});
    return publisher ? subscriber.pipe().hear() : 0;
  };
  std::vector<std::function<double()>> works = {tell, forward, publish};
  std::vector<std::unique_ptr<BrokerClient>> publishers;
  for (std::size_t i = 0; i < brokers.size(); ++i) {
    publishers.push_back(brokers[i].connect(true));
    // One at a time: a broker may acknowledge quicker than it delivers, and what waits in it is not its latency.
    const auto publish_there = [&, client = publishers.back().get(), i] {
      std::vector<double> took_us;
      for (int n = 0; client && n < tells; ++n) {
        client->publish_acknowledged(stamped());
        took_us.push_back(listeners[i].pipe().hear());
      }
      return percentile(took_us, 0.5);
    };
    works.emplace_back(publish_there);
  }
  const std::vector<double> us = medians_of_rounds(rounds, works);
  const std::optional<double> redis_us = redis ? std::optional(us[2]) : std::nullopt;
  std::vector<Peer> peers = {{"zeromq", us[1]}, {"redis", redis_us}};
  add_peers(peers, brokers, std::span(us).subspan(3));
  const Goal goal = at_most(1.2 * us[1], "<= 1.2 x ZeroMQ's forwarding");
  const char* limit = "polling sockets and timers at three ends, where the peer waits in one call";
  figures.say({"tell to watcher, p50, 10,000 other watches", us[0], "us", goal, peers, "", limit});
}

}  // namespace pizarra::bench
