// Python's clients beside the C++ one, on one board: a tell acknowledged, and facts told in batches.

#include <cstdlib>
#include <fmt/format.h>

#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {

namespace {

constexpr int trips = 1500;   // in a round
constexpr int batch = 64;     // facts
constexpr int batches = 100;  // in a round

Transaction batch_of(int number) {
  Transaction transaction;
  for (int i = 0; i < batch; ++i) transaction.tell(object_fact(i, number));
  return transaction;
}

Task<void> tell_often(Board& board, std::vector<double>& took_us) {
  for (int i = 0; i < trips; ++i) {
    Datum fact = object_fact(i % batch, i);
    const double begun = now_us();
    const Result<Revision> told = co_await board.tell(fact);
    took_us.push_back(now_us() - begun);
    if (!told) throw std::runtime_error(describe(told.error()));
  }
}

Task<void> tell_batches(Board& board) {
  for (int i = 0; i < batches; ++i) {
    Transaction transaction = batch_of(i);
    const Result<Revision> told = co_await board.transact(std::move(transaction));
    if (!told) throw std::runtime_error(describe(told.error()));
  }
}

double median_trip_us(Client& client) {
  std::vector<double> took_us;
  client.run(tell_often(client.board(), took_us));
  return percentile(took_us, 0.5);
}

double facts_per_second(Client& client) {
  return batch * batches / seconds_of([&] { client.run(tell_batches(client.board())); });
}

// The figure that the script measures in a process of its own.
double measured_in_python(const std::string& address, const std::string& client, const std::string& what) {
  const std::string script = source_dir() + "/tests/bench/blackboard/python_client.py";
  Child python = Child::program({"/usr/bin/python3", "-B", script, address, client, what, std::to_string(trips),
                                 std::to_string(batch), std::to_string(batches)});
  return std::stod(python.pipe().hear_line());
}

}  // namespace

void python_client(Figures& figures) {
  setenv("PYTHONPATH", (source_dir() + "/blackboard/python").c_str(), 1);
  const BoardProcess server;
  Client client(server.address(), "teller");
  const auto python = [&](const char* kind, const char* what) {
    return [&server, kind, what] { return measured_in_python(server.address(), kind, what); };
  };
  const std::vector<double> us = medians_of_rounds(
      rounds, {[&] { return median_trip_us(client); }, python("plain", "trip"), python("asyncio", "trip")});
  const std::vector<double> rates = medians_of_rounds(
      rounds, {[&] { return facts_per_second(client); }, python("plain", "facts"), python("asyncio", "facts")});
  figures.say({"tell from Python, p50", us[1], "us", {}, {{"C++", us[0]}}});
  figures.say({"tell from Python, asyncio, p50", us[2], "us", {}, {{"C++", us[0]}}});
  figures.say({"facts from Python", rates[1], "facts/s", {}, {{"C++", rates[0]}}, "64 a transaction, one at a time"});
  figures.say({"facts from Python, asyncio", rates[2], "facts/s", {}, {{"C++", rates[0]}}});
}

}  // namespace pizarra::bench
