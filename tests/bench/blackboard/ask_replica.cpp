// A question about one of 100,000 facts of a relation that the client holds, against Redis GET of as many keys.

#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int objects = 100'000;
constexpr int batch = 1000;
constexpr int asks = 20'000;  // in a round
constexpr int gets = 3000;
constexpr int step = 7919;  // through the objects, so that neighbours are not asked for in turn

Task<void> ask_often(Board& board, std::vector<double>& took_us) {
  for (int i = 0; i < asks; ++i) {
    const Datum name = object_name(i * step % objects);
    Query query = query_for(list("seen"_sym, name, "?x"_sym, "?y"_sym, "?d"_sym));
    const double begun = now_us();
    const Result<Answers> answers = co_await board.ask(std::move(query));
    took_us.push_back(now_us() - begun);
    if (!answers || answers->answers.size() != 1) throw std::runtime_error("the replica does not answer");
  }
}

void tell_all(Client& client) {
  for (int i = 0; i < objects; i += batch) {
    Transaction facts;
    for (int object = i; object < i + batch; ++object) facts.tell(object_fact(object, object));
    client.run(client.board().transact(std::move(facts)));
  }
}

}  // namespace

void ask_replica(Figures& figures) {
  const BoardProcess server;
  const std::optional<RedisServer> redis = RedisServer::start();
  Client client(server.address(), "holder");
  tell_all(client);
  client.run(client.board().replicate(object_relation()));
  std::optional<RedisClient> other;
  if (redis) other.emplace(redis->port());
  for (int i = 0; other && i < objects; ++i) other->call({"SET", object_name(i).text(), std::string(26, 'x')});
  const auto ask = [&] {
    std::vector<double> took_us;
    client.run(ask_often(client.board(), took_us));
    return percentile(took_us, 0.5);
  };
  const auto get = [&] {
    std::vector<double> took_us;
    for (int i = 0; other && i < gets; ++i) {
      const double begun = now_us();
      other->call({"GET", object_name(i * step % objects).text()});
      took_us.push_back(now_us() - begun);
    }
    return percentile(took_us, 0.5);
  };
  const std::vector<double> us = medians_of_rounds(rounds, {ask, get});
  const std::optional<double> redis_us = redis ? std::optional(us[1]) : std::nullopt;
  figures.say({"ask on a replica of 100,000 facts, p50", us[0], "us", at_most(1), {{"redis", redis_us}}});
  const Goal goal = redis ? at_most(us[1] / 40, "<= 1/40 of Redis GET") : not_comparable("redis is not installed");
  figures.say({"ask on a replica of 100,000 facts, p50", us[0], "us", goal, {{"redis", redis_us}}});
}

}  // namespace pizarra::bench
