// A device at the text door beside the client in C++: one fact told and answered, and facts told in batches of which
// some are under way. Board, door and device are each a process.

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/wire/keys.hpp"
#include "lisp/writer.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/blackboard/tcp_client.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int trips = 1500;    // in a round
constexpr int batches = 1500;  // in a round
constexpr int batch = 64;
constexpr int in_flight = 16;  // batches
constexpr int objects = 1000;

void expect_ok(std::string_view answer) {
  if (!answer.starts_with("(ok")) throw std::runtime_error(fmt::format("the text door says {}", answer));
}

std::string line_of(int first, int count, int facts) {
  std::string line = "(tell";
  for (int i = first; i < first + facts; ++i) write_to(line += ' ', object_fact(i % objects, count));
  return line + ")\n";
}

Task<void> tell_batches(Board& board, int& next, int facts) {
  while (next < batches) {
    const int first = batch * next++;
    Transaction transaction;
    for (int i = first; i < first + facts; ++i) transaction.tell(object_fact(i % objects, next));
    const Result<Revision> told = co_await board.transact(std::move(transaction));
    if (!told) throw std::runtime_error(describe(told.error()));
  }
}

Task<void> tell_one(Board& board, Datum fact) {
  const Result<Revision> told = co_await board.tell(std::move(fact));
  if (!told) throw std::runtime_error(describe(told.error()));
}

double through_door_us(TcpClient& device, int round) {
  std::vector<double> took_us;
  for (int i = 0; i < trips; ++i) {
    const std::string line = line_of(i, round + i, 1);
    const double begun = now_us();
    device.send(line);
    expect_ok(device.line());
    took_us.push_back(now_us() - begun);
  }
  return percentile(took_us, 0.5);
}

double by_client_us(Client& client, int round) {
  std::vector<double> took_us;
  for (int i = 0; i < trips; ++i) {
    Datum fact = object_fact(i % objects, round + i);
    const double begun = now_us();
    client.run(tell_one(client.board(), std::move(fact)));
    took_us.push_back(now_us() - begun);
  }
  return percentile(took_us, 0.5);
}

double through_door_per_second(TcpClient& device, int round) {
  std::vector<std::string> lines;
  for (int i = 0; i < batches; ++i) lines.push_back(line_of(batch * i, round + i, batch));
  return batch * batches / seconds_of([&] {
           for (int i = 0; i < batches + in_flight; ++i) {
             if (i < batches) device.send(lines[static_cast<std::size_t>(i)]);
             if (i >= in_flight) expect_ok(device.line());
           }
         });
}

double by_client_per_second(Client& client) {
  return batch * batches / seconds_of([&] {
           int next = 0;
           std::vector<Job> jobs;
           for (int i = 0; i < in_flight; ++i) {
             jobs.push_back(client.executor().spawn(tell_batches(client.board(), next, batch)));
           }
           client.executor().run_until([&] { return std::ranges::all_of(jobs, &Job::done); });
         });
}

}  // namespace

void text_door(Figures& figures) {
  const BoardProcess board;
  const TemporaryFolder folder;
  const std::string keys = folder.path() + "/keys";
  const auto key = wire::make_keys(keys, "device", {{"seen"}, {}, {}, {}});
  if (!key) throw std::runtime_error(describe(key.error()));
  Child door = Child::program(
      {program_beside("pizarra-door"), "door", "--keys", keys, "--board", board.address(), "--tcp", "127.0.0.1:0"});
  const std::string ready = door.pipe().hear_line();
  Client client(board.address(), "teller");
  TcpClient device(std::stoi(ready.substr(ready.rfind(':') + 1)), "the text door");
  device.send("(hello device \"" + key->secret_key + "\")\n");
  device.line();
  int round = 0;
  const std::vector<double> us = medians_of_rounds(
      rounds, {[&] { return through_door_us(device, ++round); }, [&] { return by_client_us(client, ++round); }});
  const std::vector<double> rates = medians_of_rounds(
      rounds, {[&] { return through_door_per_second(device, ++round); }, [&] { return by_client_per_second(client); }});
  figures.say({"tell by the text door, p50", us[0], "us", {}, {{"C++ client", us[1]}}});
  figures.say({"facts by the text door, 64 a line", rates[0], "1/s", {}, {{"C++ client", rates[1]}}});
}

}  // namespace pizarra::bench
