// From the start of the server's process to the first fact that it acknowledged, and its memory then.

#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

struct Started {
  double ms = 0;
  double memory_mb = 0;
};

// The server's end, and its client's, are not of its start.
Started start_ours() {
  const double begin_us = now_us();
  const BoardProcess server;
  Client client(server.address(), "first");
  client.run(client.board().tell(object_fact(1, 1)));
  return {1e-3 * (now_us() - begin_us), server.process().memory_mb("VmRSS")};
}

std::optional<double> start_redis_ms() {
  const double begin_us = now_us();
  const std::optional<RedisServer> server = RedisServer::start();
  if (!server) return std::nullopt;
  RedisClient client(server->port());
  client.call({"SET", "a", "b"});
  return 1e-3 * (now_us() - begin_us);
}

}  // namespace

void start_and_memory(Figures& figures) {
  std::vector<double> starts_ms;
  std::vector<double> idle_mb;
  std::vector<double> redis_ms;
  for (int round = 0; round < rounds; ++round) {
    const Started ours = start_ours();
    starts_ms.push_back(ours.ms);
    idle_mb.push_back(ours.memory_mb);
    if (const std::optional<double> theirs_ms = start_redis_ms()) redis_ms.push_back(*theirs_ms);
  }
  figures.say({"start to first fact",
               percentile(starts_ms, 0.5),
               "ms",
               at_most(20),
               {{"redis", redis_ms.empty() ? std::nullopt : std::optional(percentile(redis_ms, 0.5))}}});
  figures.say({"idle memory", percentile(idle_mb, 0.5), "MB", at_most(15)});
}

}  // namespace pizarra::bench
