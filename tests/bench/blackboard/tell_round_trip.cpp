// A fact told and acknowledged, against a message of as many bytes sent to a router and answered.

#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/brokers.hpp"
#include "tests/bench/blackboard/raw_zmq.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int trips = 1500;  // in a round

Task<void> tell_often(Board& board, int count, std::vector<double>& took_us) {
  for (int i = 0; i < count; ++i) {
    Datum fact = object_fact(i % 100, i);
    const double begun = now_us();
    const Result<Revision> told = co_await board.tell(fact);
    took_us.push_back(now_us() - begun);
    if (!told) throw std::runtime_error(describe(told.error()));
  }
}

double median_of(int count, const std::function<void()>& trip) {
  std::vector<double> took_us;
  for (int i = 0; i < count; ++i) {
    const double begun = now_us();
    trip();
    took_us.push_back(now_us() - begun);
  }
  return percentile(took_us, 0.5);
}

}  // namespace

void tell_round_trip(Figures& figures) {
  const RawRouter router;
  const BoardProcess server;
  const std::optional<RedisServer> redis = RedisServer::start();
  const std::vector<Broker> brokers = start({nats(), mqtt(), omni_events()});
  Client client(server.address(), "teller");
  RawDealer dealer(router.address());
  std::optional<RedisClient> other;
  if (redis) other.emplace(redis->port());
  const std::string payload(40, 'x');
  int told = 0;
  const auto tell = [&] {
    std::vector<double> took_us;
    client.run(tell_often(client.board(), trips, took_us));
    told += trips;
    return percentile(took_us, 0.5);
  };
  const auto raw = [&] {
    return median_of(trips, [&] {
      dealer.send(payload);
      dealer.receive();
    });
  };
  const auto set = [&] {
    return median_of(other ? trips : 0, [&] { other->call({"SET", "object-000042", payload}); });
  };
  std::vector<std::function<double()>> works = {tell, raw, set};
  std::vector<std::unique_ptr<BrokerClient>> publishers;
  for (const Broker& broker : brokers) {
    publishers.push_back(broker.connect(true));
    const auto publish = [&payload, publisher = publishers.back().get()] {
      return median_of(publisher ? trips : 0, [&] { publisher->publish_acknowledged(payload); });
    };
    works.emplace_back(publish);
  }
  const std::vector<double> us = medians_of_rounds(rounds, works);
  const std::optional<double> redis_us = redis ? std::optional(us[2]) : std::nullopt;
  std::vector<Peer> peers = {{"zeromq", us[1]}, {"redis", redis_us}};
  add_peers(peers, brokers, std::span(us).subspan(3));
  figures.say({"tell, acknowledged, p50", us[0], "us", at_most(1.15 * us[1], "<= 1.15 x ZeroMQ's round trip"), peers,
               "", "polling sockets and timers at both ends, where the peer waits in one call"});
}

}  // namespace pizarra::bench
