// Durable facts told one by one, each acknowledged when the disk has it, 64 under way, against Redis with an
// append-only file that is synchronised for every reply, SET pipelined by 64. `fdatasync` is what the disk would take
// of tells if nothing else were to do: 64 times how often it synchronises what a group of 64 writes.

#include <array>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdexcept>
#include <unistd.h>

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

// A file that is written over, as SQLite's log is.
class BareDisk {
 public:
  explicit BareDisk(const std::string& path) : file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    for (int group = 0; group < groups; ++group) write_group(group);
    sync();
  }
  BareDisk(const BareDisk&) = delete;
  BareDisk& operator=(const BareDisk&) = delete;
  ~BareDisk() { close(file_); }

  void write_all() {
    for (int group = 0; group < groups; ++group) {
      write_group(group);
      sync();
    }
  }

 private:
  static constexpr int groups = tells / in_flight;
  static constexpr std::size_t group_bytes = 20 << 10;  // of SQLite's log, for 64 tells

  void write_group(int group) {
    bytes_.fill(static_cast<char>(++writes_));
    const auto at = static_cast<off_t>(static_cast<std::size_t>(group) * group_bytes);
    if (pwrite(file_, bytes_.data(), bytes_.size(), at) != ssize_t{group_bytes}) throw std::runtime_error("pwrite");
  }
  void sync() const {
    if (fdatasync(file_) != 0) throw std::runtime_error("fdatasync");
  }

  const int file_;
  int writes_ = 0;
  std::array<char, group_bytes> bytes_{};
};

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
  BareDisk disk(folder.file("disk"));
  const auto bare = [&] { return tells / seconds_of([&] { disk.write_all(); }); };
  const std::vector<double> rates = medians_of_rounds(rounds, {ours, theirs, bare});
  const Goal goal =
      redis ? at_least(rates[1], ">= Redis appendfsync always") : not_comparable("redis is not installed");
  const std::optional<double> redis_rate = redis ? std::optional(rates[1]) : std::nullopt;
  figures.say({"durable tells, acknowledged, 64 in flight",
               rates[0],
               "1/s",
               goal,
               {{"redis", redis_rate}, {"fdatasync", rates[2]}},
               "",
               "what client, board and journal compute for a fact"});
}

}  // namespace pizarra::bench
