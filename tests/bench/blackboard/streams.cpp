// Frames for 64 subscribers of this machine, each a process: how many a second reach them all, how long the last one
// waits, and what one of them that is stopped costs the others; against ZeroMQ's PUB/SUB and Redis.

#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <unistd.h>

#include "blackboard/streams/remote_streams.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/redis.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/blackboard/tally.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr std::size_t subscribers = Tally::max_subscribers;
constexpr int width = 200;
constexpr int height = 100;  // 20 KB
constexpr int large = 7;     // times as wide and as high: 980 KB
constexpr std::uint64_t frames_at_once = 300;
constexpr std::uint64_t large_frames_at_once = 30;
constexpr int paced_frames = 100;
constexpr useconds_t pace_us = 8000;
// Frames that others have under way: with theirs, one may be sent before the one before has arrived.
constexpr std::uint64_t their_window = 4;

const std::string zeromq_address = fmt::format("ipc://@pizarra-bench-{}", getpid());

// One of those compared: it sends frames, its subscribers tally them.
struct Contestant {
  Tally tally;
  std::vector<Child> children;
  std::function<void(std::uint64_t number, int scale)> send;
  std::function<void()> rest = [] { usleep(pace_us); };
  std::uint64_t window = their_window;
  std::uint64_t number = 0;

  void subscribe(const std::function<void(std::size_t subscriber)>& work) {
    tally.expect(subscribers);
    for (std::size_t i = 0; i < subscribers; ++i) children.push_back(Child::running([&](Pipe&) { work(i); }));
  }
  void send_next(int scale = 1) {
    tally.sent(++number);
    send(number, scale);
  }
  // Until the first frame has come to everybody: they have all subscribed then.
  void warm_up() {
    constexpr int tries = 1000;
    for (int i = 0; i < tries; ++i) {
      send_next();
      rest();
      if (tally.arrived(number) == subscribers) return;
    }
    throw std::runtime_error("not all have subscribed");
  }
  double frames_per_second(std::uint64_t frames, int scale) {
    const double seconds = seconds_of([&] {
      for (std::uint64_t i = 1; i <= frames; ++i) {
        send_next(scale);
        if (i >= window) tally.await(number - window + 1);
      }
      tally.await(number);
    });
    return static_cast<double>(frames) / seconds;
  }
  // At a pace that everybody keeps: what the last subscriber waits, p50.
  double last_us() {
    std::vector<double> took;
    for (int i = 0; i < paced_frames; ++i) {
      send_next();
      rest();
      tally.await(number);
      took.push_back(tally.last_us(number));
    }
    return percentile(took, 0.5);
  }
  // Of all but the first subscriber, p99.
  double others_us() {
    std::vector<double> took;
    for (int i = 0; i < paced_frames; ++i) {
      send_next();
      rest();
      tally.await(number);
      for (std::size_t other = 1; other < subscribers; ++other) took.push_back(tally.took_us(other, number));
    }
    return percentile(took, 0.99);
  }
};

Image blank(int scale) {
  Image image{width * scale, height * scale, 1, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  return image;
}

// What others send: the number and then nothing of interest.
std::string payload(std::uint64_t number, int scale) {
  std::string text(blank(scale).pixels.size(), 'x');
  std::memcpy(text.data(), fmt::format("{:<16}", number).data(), 16);
  return text;
}

void watch_ours(const std::string& board, Tally& tally, std::size_t subscriber) {
  Client client(board, fmt::format("subscriber-{}", subscriber));
  const auto streams = streams::RemoteStreams::open(client.executor(), client.board()).value();
  const auto subscription =
      streams->subscribe("eyes", [&](const StreamFrame& frame) { tally.received(subscriber, frame.number); });
  client.executor().run_until([] { return false; });
}

void watch_zeromq(Tally& tally, std::size_t subscriber) {
  zmq::context_t context(1);
  zmq::socket_t socket(context, zmq::socket_type::sub);
  socket.set(zmq::sockopt::subscribe, "");
  socket.connect(zeromq_address);
  for (zmq::message_t message; socket.recv(message);) tally.received(subscriber, std::stoull(message.to_string()));
}

void watch_redis(int port, Tally& tally, std::size_t subscriber) {
  RedisClient client(port);
  client.call({"SUBSCRIBE", "eyes"});
  client.receive(3);
  while (true) tally.received(subscriber, std::stoull(client.message()));
}

void announce(Client& client, const Streams& streams) {
  const std::vector<Relation> relations{stream_relation()};
  client.run(client.board().declare(relations));
  client.run(client.board().tell(stream_fact("eyes", "left", streams)));
}

}  // namespace

void streams(Figures& figures) {
  const BoardProcess server;
  const std::optional<RedisServer> redis = RedisServer::start();
  Contestant ours;
  Contestant zeromq;
  Contestant other;
  ours.subscribe([&](std::size_t i) { watch_ours(server.address(), ours.tally, i); });
  zeromq.subscribe([&](std::size_t i) { watch_zeromq(zeromq.tally, i); });
  if (redis) other.subscribe([&](std::size_t i) { watch_redis(redis->port(), other.tally, i); });

  Client client(server.address(), "publisher");
  const auto publisher = streams::RemoteStreams::open(client.executor(), client.board()).value();
  announce(client, *publisher);
  const auto small_image = std::make_shared<const Image>(blank(1));
  const auto large_image = std::make_shared<const Image>(blank(large));
  // The newest wins here: only one that has arrived may be followed by the next, if all are to be seen.
  ours.window = 1;
  ours.send = [&](std::uint64_t number, int scale) {
    publisher->publish("eyes", {number, {}, scale == 1 ? small_image : large_image});
  };
  // Lets in who has come, meanwhile.
  ours.rest = [&] {
    bool rested = false;
    client.executor().call_at(client.executor().now() + Duration(pace_us), [&] { rested = true; });
    client.executor().run_until([&] { return rested; });
  };
  zmq::context_t context(1);
  zmq::socket_t socket(context, zmq::socket_type::pub);
  socket.set(zmq::sockopt::linger, 0);
  socket.bind(zeromq_address);
  zeromq.send = [&](std::uint64_t number, int scale) { socket.send(zmq::buffer(payload(number, scale))); };
  std::optional<RedisClient> redis_publisher;
  if (redis) redis_publisher.emplace(redis->port());
  other.send = [&](std::uint64_t number, int scale) {
    redis_publisher->call({"PUBLISH", "eyes", payload(number, scale)});
  };

  ours.warm_up();
  zeromq.warm_up();
  if (redis) other.warm_up();
  const auto with_peers = [&](const std::function<double(Contestant&)>& measure) {
    return medians_of_rounds(rounds, {[&] { return measure(ours); }, [&] { return measure(zeromq); },
                                      [&] { return redis ? measure(other) : 0; }});
  };
  const auto peers = [&](const std::vector<double>& values) {
    return std::vector<Peer>{{"zeromq", values[1]}, {"redis", redis ? std::optional(values[2]) : std::nullopt}};
  };
  const std::vector<double> rate = with_peers([](Contestant& c) { return c.frames_per_second(frames_at_once, 1); });
  figures.say({"20 KB frames to all of 64 subscribers", rate[0], "frames/s",
               at_least(3 * rate[1], ">= 3 x ZeroMQ's PUB/SUB"), peers(rate)});
  const std::vector<double> last = with_peers([](Contestant& c) { return c.last_us(); });
  figures.say({"20 KB frame to the last of 64, p50", last[0], "us",
               at_most(0.55 * last[1], "<= 0.55 x ZeroMQ's PUB/SUB"), peers(last)});
  const std::vector<double> large_rate =
      with_peers([](Contestant& c) { return c.frames_per_second(large_frames_at_once, large); });
  figures.say({"980 KB frames to all of 64 subscribers", large_rate[0], "frames/s", {}, peers(large_rate)});

  const auto beside = [&](int signal, std::uint32_t expected) {
    ours.children.front().signal(signal);
    ours.tally.expect(expected);
    return ours.others_us();
  };
  const std::vector<double> stalled = medians_of_rounds(
      rounds, {[&] { return beside(SIGCONT, subscribers); }, [&] { return beside(SIGSTOP, subscribers - 1); }});
  figures.say({"20 KB frame to 63 subscribers, p99, another stalled",
               stalled[1],
               "us",
               at_most(1.2 * stalled[0], "<= 1.2 x with it running"),
               {{"running", stalled[0]}}});
}

}  // namespace pizarra::bench
