// `top`: who is on a board and what goes on there, live.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "blackboard/client/keyed_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/board_sample.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

constexpr std::size_t relations_shown = 20;
constexpr std::size_t clients_shown = 20;

struct TopChoices {
  BoardChoices board;
  double interval_s = 1;
  bool once = false;
  bool json = false;
};

// The half, and ninety-nine in a hundred.
std::string spread_text(const Spread& spread) {
  return spread.count == 0 ? "-" : fmt::format("{} / {}", spread.p50_us, spread.p99_us);
}

void print_clients(const std::vector<ClientSample>& clients) {
  fmt::print("\n{:<20} {:>10} {:>9}  {}\n", "CLIENT", "REQUESTS/S", "REFUSED", "NEWEST REFUSAL");
  std::size_t shown = 0;
  for (const ClientSample& client : clients) {
    // Whoever is refused is shown, however little it asks.
    if (client.refused == 0 && ++shown > clients_shown) continue;
    fmt::print("{:<20} {:>10} {:>9}  {}\n", client.name.empty() ? "(no hello)" : client.name,
               client.requests_per_second, client.refused, text_of_bytes(client.newest_refusal));
  }
}

void print_text(const BoardSample& sample, const std::string& address) {
  // A terminal shows each in the place of the one before.
  if (isatty(STDOUT_FILENO) != 0) fmt::print("\x1b[H\x1b[2J");
  fmt::print("{}   revision {}, {} facts, {:.1f} transactions/s\n", address, sample.revision, sample.facts,
             sample.transactions_per_second);
  if (const std::optional<Journey>& journey = sample.journey) {
    fmt::print("a fact is committed after {:.0f} us, acknowledged after {:.0f} us, delivered after {:.0f} us\n",
               journey->committed_us, journey->acknowledged_us, journey->delivered_us);
  }
  fmt::print("\n{:<20} {:<14} {:<16} {:>9} {:>9} {:>9}\n", "AGENT", "KIND", "HOST", "TOLD/S", "WAITING", "QUEUED");
  if (sample.agents_unknown) fmt::print("unknown: {}\n", describe(*sample.agents_unknown));
  for (const AgentSample& agent : sample.agents) {
    fmt::print("{:<20} {:<14} {:<16} {:>9.1f} {:>9} {:>9}\n", agent.name, agent.kind, agent.host, agent.told_per_second,
               agent.waiting, agent.queued);
  }
  fmt::print("\n{:<20} {:>9} {:>9} {:>9} {:>13} {:>13}  {}\n", "RELATION", "FACTS", "TOLD/S", "WATCHES", "TO BOARD us",
             "TO WATCHER us", "TELLERS");
  std::size_t shown = 0;
  for (const RelationSample& relation : sample.relations) {
    if (relation.facts == 0 && relation.told_per_second == 0 && relation.watches == 0) continue;
    if (++shown > relations_shown) break;
    fmt::print("{:<20} {:>9} {:>9.1f} {:>9} {:>13} {:>13}  {}\n", relation.name, relation.facts,
               relation.told_per_second, relation.watches, spread_text(relation.told), spread_text(relation.delivered),
               fmt::join(relation.tellers, " "));
  }
  print_clients(sample.clients);
}

Task<void> show(const TopChoices& choices, const std::string& address, Executor& executor, Board& board, int& status) {
  const repl::Style style = choices.json ? repl::Style::json : repl::Style::text;
  const Duration interval(static_cast<std::int64_t>(choices.interval_s * 1e6));
  BoardSampler sampler(executor, board, fmt::format("top-{}", getpid()));
  const Result<void> begun = co_await sampler.begin();
  if (!begun) {
    status = complain_of_board(style, begun.error());
    co_return;
  }
  bool going_on = true;
  while (going_on) {
    co_await sleep(executor, interval);
    const Result<BoardSample> sample = co_await sampler.next();
    if (!sample) {
      status = complain_of_board(style, sample.error());
      co_return;
    }
    if (choices.json) {
      fmt::print("{}\n", json_of(*sample));
    } else {
      print_text(*sample, address);
    }
    std::fflush(stdout);
    going_on = !choices.once;
    if (going_on && !choices.json) fmt::print("\n");
  }
}

int run_top(const TopChoices& choices) {
  const repl::Style style = choices.json ? repl::Style::json : repl::Style::text;
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain_as(style, to.error(), exit_unavailable);
  RealExecutor executor;
  const auto board = client::keyed_board(executor, to->address, to->key, "top");
  if (!board) return complain_as(style, board.error(), exit_usage);
  int status = exit_reached;
  const Job job = executor.spawn(show(choices, to->address, executor, **board, status));
  executor.run_until([&job] { return job.done(); });
  return status;
}

}  // namespace

void add_top_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<TopChoices>();
  CLI::App* top = app.add_subcommand("top",
                                     "Show the clients of a board, the facts they tell and wait for, and how long a "
                                     "fact is under way, until interrupted.");
  top->add_flag("--once", choices->once, "Print one look and end");
  top->add_option("--interval", choices->interval_s, "The time between two looks, in seconds")
      ->check(number_check(0.1, 3600))
      ->capture_default_str();
  top->add_flag("--json", choices->json, "Print one JSON object a look");
  add_board_options(top, choices->board);
  top->footer(help_footer("top --once"));
  top->callback([choices, &status] { status = run_top(*choices); });
}

}  // namespace pizarra::programs
