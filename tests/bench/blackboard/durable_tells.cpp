// Durable facts told one by one, each acknowledged when the disk has it, 64 under way, against Redis with an
// append-only file that is synchronised for every reply, SET pipelined by 64.

#include <fmt/format.h>

#include "tests/bench/blackboard/kept_facts.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int in_flight = 64;
constexpr int tells = in_flight * 40;  // in a round
constexpr int objects = 4'000;

Transaction one_fact(int number) {
  Transaction transaction;
  transaction.tell(kept_fact(number % objects, number));
  return transaction;
}

void set_all(RedisClient& client, int round) {
  for (int done = 0; done < tells; done += in_flight) {
    std::string commands;
    for (int i = done; i < done + in_flight; ++i) {
      std::string value = std::to_string(round * tells + i);
      value.resize(26, 'x');
      commands += RedisClient::command({"SET", fmt::format("object-{:06}", i % objects), value});
    }
    client.send(commands);
    client.receive(in_flight);
  }
}

}  // namespace

void durable_tells(Figures& figures) {
  const JournalFolder folder;
  const BoardProcess server(folder.board_options());
  const std::optional<RedisServer> redis = RedisServer::start({"--appendonly", "yes", "--appendfsync", "always"});
  Client teller(server.address(), "teller");
  const std::vector<Relation> relations = {kept_relation()};
  teller.run(teller.board().declare(relations));
  std::optional<RedisClient> client;
  if (redis) client.emplace(redis->port());
  int round = 0;
  const auto ours = [&] {
    ++round;
    return tells /
           seconds_of([&] { tell_all(teller, tells, in_flight, [&](int i) { return one_fact(round * tells + i); }); });
  };
  const auto theirs = [&] { return client ? tells / seconds_of([&] { set_all(*client, round); }) : 0; };
  const std::vector<double> rates = medians_of_rounds(rounds, {ours, theirs});
  const Goal goal =
      redis ? at_least(rates[1], ">= Redis appendfsync always") : not_comparable("redis is not installed");
  const std::optional<double> redis_rate = redis ? std::optional(rates[1]) : std::nullopt;
  figures.say({"durable tells, acknowledged, 64 in flight", rates[0], "1/s", goal, {{"redis", redis_rate}}});
}

}  // namespace pizarra::bench
