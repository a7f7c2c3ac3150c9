// From the start of the server's process to the first fact that it acknowledged, and its memory then.

#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

void start_and_memory(Figures& figures) {
  std::vector<double> starts_ms;
  std::vector<double> idle_mb;
  std::vector<double> redis_ms;
  for (int round = 0; round < rounds; ++round) {
    starts_ms.push_back(1e3 * seconds_of([&] {
                          const BoardProcess server;
                          Client client(server.address(), "first");
                          client.run(client.board().tell(object_fact(1, 1)));
                          idle_mb.push_back(server.process().memory_mb("VmRSS"));
                        }));
    redis_ms.push_back(1e3 * seconds_of([&] {
                         const std::optional<RedisServer> server = RedisServer::start();
                         if (!server) return;
                         RedisClient client(server->port());
                         client.call({"SET", "a", "b"});
                       }));
  }
  const bool redis = find_program("redis-server").has_value();
  figures.say({"start to first fact",
               percentile(starts_ms, 0.5),
               "ms",
               at_most(20),
               {{"redis", redis ? std::optional(percentile(redis_ms, 0.5)) : std::nullopt}}});
  figures.say({"idle memory", percentile(idle_mb, 0.5), "MB", at_most(15)});
}

}  // namespace pizarra::bench
