// pizarra-bench-cluster: what durable facts take through an etcd cluster of three members, beside etcd's own
// transactions in the same run, and how long a takeover takes.

#include <atomic>
#include <fmt/format.h>
#include <thread>

#include "blackboard/cluster/etcd_client.hpp"
#include "tests/bench/bench_main.hpp"
#include "tests/bench/cluster/recovery_rows.hpp"
#include "tests/bench/cluster/standby_rows.hpp"
#include "tests/bench/cluster/takeovers.hpp"
#include "tests/bench/cluster/tells.hpp"
#include "tests/bench/figures.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/stopping.hpp"

namespace pizarra::bench {
namespace {

constexpr std::size_t entry_bytes = 160;  // as of one tell with what is remembered of it

struct Choices {
  int rounds = 20;
  int tells = 4000;
  std::uint64_t entries = 1'000'000;
  bool json = false;
};

// A compare of two keys and two puts, as an entry of the log is.
TellTimes own_transactions(const cluster::LogAddress& log, int clients, int each, bool compares) {
  std::vector<std::vector<double>> ms(static_cast<std::size_t>(clients));
  std::vector<std::thread> threads;
  const auto begun = std::chrono::steady_clock::now();
  for (int client = 0; client < clients; ++client) {
    threads.emplace_back([&, client] {
      const auto etcd = cluster::EtcdClient::open(log).value();
      const std::string base = fmt::format("bench/{}/", client);
      std::string head = "0";
      (void)etcd->transact({.compares = {}, .puts = {{base + "epoch", "1"}, {base + "head", head}}}, 5s);
      for (int i = 1; i <= each && stopped_by() == 0; ++i) {
        cluster::KeyValues::Transaction transaction{
            .compares = {}, .puts = {{fmt::format("{}{:020}", base, i), std::string(entry_bytes, 'x')}}};
        const std::string next = std::to_string(i);
        if (compares) {
          transaction.compares = {{base + "epoch", "1"}, {base + "head", head}};
          transaction.puts.push_back({base + "head", next});
        }
        const auto sent = std::chrono::steady_clock::now();
        if (etcd->transact(transaction, 5s)) ms[static_cast<std::size_t>(client)].push_back(ms_since(sent));
        head = next;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  throw_if_stopped();
  const double took_s = ms_since(begun) / 1000;
  TellTimes measured;
  for (const std::vector<double>& some : ms) measured.ms.insert(measured.ms.end(), some.begin(), some.end());
  measured.per_s = static_cast<double>(measured.ms.size()) / took_s;
  return measured;
}

void say_rates(Figures& figures, RealExecutor& executor, const ClusterCell& cell, int count) {
  cluster::LogAddress log = cluster::LogAddress::from(cell.log(), "", true).value();
  const auto board = board_for_tells(executor, cell);
  // Of all members, the leading board asks that of its host: so does the peer.
  log.members = {log.members[cell.await_leading_board()]};
  const TellTimes put = own_transactions(log, 1, 200, false);
  const TellTimes serial = own_transactions(log, 1, 300, true);
  const TellTimes one = tells(executor, *board, 1, 300);
  const TellTimes many = own_transactions(log, in_flight, std::max(1, count / in_flight / 2), true);
  const TellTimes all = tells(executor, *board, in_flight, count);
  const double serial_p50 = percentile(serial.ms, 0.5);
  const double many_p50 = percentile(many.ms, 0.5);
  const Peer own{"etcd, a transaction of the same bytes", serial_p50};
  figures.say({"durable tell, one in flight, p50",
               percentile(one.ms, 0.5),
               "ms",
               at_most(1.3 * serial_p50, "<= 1.3 x etcd"),
               {own}});
  figures.say({"durable tell, 64 in flight, p50",
               percentile(all.ms, 0.5),
               "ms",
               at_most(2.2 * serial_p50, "<= 2.2 x etcd with one"),
               {own, {"etcd, 64 in flight", many_p50}}});
  figures.say({"durable tell, 64 in flight, p99",
               percentile(all.ms, 0.99),
               "ms",
               {},
               {{"etcd, 64 in flight", percentile(many.ms, 0.99)}}});
  figures.say(
      {"durable tells, 64 in flight",
       all.per_s,
       "facts/s",
       at_least(10 * serial.per_s, ">= 10 x etcd's one by one"),
       {{"etcd, one by one", serial.per_s}, {"etcd, 64 in flight", many.per_s}, {"etcd, puts alone", put.per_s}}});
}

double worst(const std::vector<double>& samples) { return percentile(samples, 1); }

void say_takeovers(Figures& figures, Takeovers& takeovers, const std::string& what, const std::function<void()>& kill,
                   int rounds, double goal_p50, double goal_worst) {
  const Waits waits = takeovers.of(kill, rounds);
  const std::string note = fmt::format("{} rounds, acknowledged and lost {}", rounds, waits.lost);
  figures.say({what + ": first tell, p50", percentile(waits.tell_s, 0.5), "s", at_most(goal_p50), {}, note});
  figures.say({what + ": first tell, worst", worst(waits.tell_s), "s", at_most(goal_worst), {}, note});
  figures.say({what + ": first ask, p50", percentile(waits.ask_s, 0.5), "s", at_most(goal_p50), {}, note});
  figures.say({what + ": first ask, worst", worst(waits.ask_s), "s", at_most(goal_worst), {}, note});
  figures.say({what + ": an agent is there again, p50", percentile(waits.present_s, 0.5), "s", {}, {}, note});
  figures.say({what + ": an agent is there again, worst", worst(waits.present_s), "s", {}, {}, note});
  figures.must_be_none(what + ": acknowledged and lost", waits.lost);
}

int run(const Choices& choices) {
  if (const std::string why = ClusterCell::unavailable(); !why.empty()) {
    fmt::print("skipped: {}\n", why);
    return 0;
  }
  ClusterCell cell(network::Network::Wires::veth);
  cell.enter(2);
  RealExecutor executor;
  throw_when_stopped(executor);
  Figures figures("cluster", choices.json ? Figures::Style::json : Figures::Style::plain);
  Takeovers takeovers(executor, cell);
  say_rates(figures, executor, cell, choices.tells);
  say_standbys(figures, executor, cell, choices.tells);
  if (choices.entries > 0) say_recovery(figures, cell, choices.entries);
  if (choices.rounds == 0) return figures.finish();
  say_takeovers(
      figures, takeovers, "the leading board killed", [&] { cell.kill_board(cell.await_leading_board()); },
      choices.rounds, 0.5, 1);
  say_takeovers(
      figures, takeovers, "its host killed", [&] { cell.kill_host(cell.await_leading_board()); }, choices.rounds, 1.5,
      3);
  say_takeovers(
      figures, takeovers, "etcd's leader killed", [&] { cell.kill_member(cell.await_leading_member()); },
      choices.rounds, 1.5, 3);
  say_takeovers(
      figures, takeovers, "etcd's leader and the leading board killed",
      [&] {
        const std::size_t board = cell.await_leading_board();
        cell.kill_member(cell.await_leading_member());
        cell.kill_board(board);
      },
      choices.rounds, 1.5, 3);
  return figures.finish();
}

}  // namespace
}  // namespace pizarra::bench

int main(int argc, char** argv) {
  CLI::App app("Durable facts through an etcd cluster of three members, and takeovers.", "pizarra bench cluster");
  pizarra::bench::Choices choices;
  app.add_option("--rounds", choices.rounds, "takeovers of each kind, some 3 s each; 0 for none")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  app.add_option("--tells", choices.tells, "durable tells with 64 in flight")
      ->check(CLI::Range(64, 10'000'000))
      ->capture_default_str();
  app.add_option("--entries", choices.entries, "entries of the log from which a board recovers; 0 for none")
      ->check(CLI::Range(0, 100'000'000))
      ->capture_default_str();
  app.add_flag("--json", choices.json, "one JSON object a line");
  app.footer(
      "As root; elsewhere it says why it is skipped. Status 0 when every figure was measured, short or not, and no\n"
      "acknowledged fact was lost; 1 otherwise; 2 for wrong arguments; 130 or 143 when it was stopped by SIGINT or\n"
      "SIGTERM.");
  // So that the hosts are taken down.
  pizarra::bench::stop_in_order();
  return pizarra::bench::bench_main(app, argc, argv, [&] { return pizarra::bench::run(choices); });
}
