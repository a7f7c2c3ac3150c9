// pizarra-board: a board alone, for agents of other processes. It links neither OpenCV nor Guile, so that it starts at
// once and stays small.

#include <CLI/CLI.hpp>
#include <charconv>
#include <csignal>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/server/kept_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "programs/board/cluster_board.hpp"
#include "programs/board/exits.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {
namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 stopped by SIGINT or SIGTERM, 2 wrong arguments, 3 an address or its keys cannot be used, 4 the "
    "journal or log cannot be read or opened, or is not this cell's.";

struct Options {
  server::BoardServerOptions server;
  std::string journal;
  std::string history = "200000";
  std::uint64_t history_bytes = journal::History().bytes;
  std::string log;
  std::string past;
  std::string certificates;
  bool log_insecure = false;
  std::string name;
  std::string cell;
};

constexpr std::uint64_t most_history = 1'000'000'000;  // revisions
constexpr Duration longest_history = std::chrono::hours(24 * 36'500);

// `200000` revisions, or `90s`, `30min`, `12h`, `7d`.
std::optional<journal::History> history_from(const std::string& text) {
  std::uint64_t count = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, count);
  const std::string_view unit(read.ptr, end);
  if (read.ec != std::errc() || count > most_history) return std::nullopt;
  if (unit.empty()) return journal::History{.revisions = count};
  const auto lasting = [&](std::chrono::seconds unit_length) -> std::optional<journal::History> {
    if (count > static_cast<std::uint64_t>(longest_history / unit_length)) return std::nullopt;
    return journal::History{.time = unit_length * count};
  };
  if (unit == "s") return lasting(1s);
  if (unit == "min") return lasting(std::chrono::minutes(1));
  if (unit == "h") return lasting(std::chrono::hours(1));
  if (unit == "d") return lasting(std::chrono::hours(24));
  return std::nullopt;
}

void say_how_it_goes(const std::optional<Failure>& failure) {
  const std::string news = failure
                               ? describe(*failure) + "; what adds to durable facts is refused until it can be written"
                               : std::string("the journal can be written again");
  fmt::print(stderr, "pizarra-board: {}\n", news);
}

// When the board ends.
void say_what_is_lacking(const journal::JournalWriter* journal) {
  if (journal == nullptr || !journal->failure()) return;
  fmt::print(stderr, "pizarra-board: ends while its journal lacks what came last: {}\n", describe(*journal->failure()));
}

journal::History history_of(const Options& options) {
  journal::History history = *history_from(options.history);
  history.bytes = options.history_bytes;
  return history;
}

// Null where none is kept.
Result<std::shared_ptr<journal::JournalFile>> journal_of(const Options& options) {
  if (options.journal.empty()) return nullptr;
  return journal::JournalFile::open(options.journal, history_of(options));
}

// A board that stands by listens only when it leads. Its addresses and keys are checked before: with wrong ones it
// could not take over.
Result<void> check_listening(const server::BoardServerOptions& options) {
  RealExecutor executor;
  memory::MemoryBoard board(executor);
  const Result<std::unique_ptr<server::BoardServer>> server = server::BoardServer::open(executor, board, options);
  return server ? Result<void>() : fail(server);
}

int serve_with_log(const Options& options) {
  const Result<cluster::LogAddress> log =
      cluster::LogAddress::from(options.log, options.certificates, options.log_insecure);
  if (!log) return complain(log.error(), bad_address);
  const Result<void> can_listen = check_listening(options.server);
  if (!can_listen) return complain(can_listen.error(), bad_address);
  char machine[256] = "board";
  gethostname(machine, sizeof machine - 1);
  return serve_in_cluster({*log,
                           options.name.empty() ? machine : options.name,
                           options.cell,
                           options.server,
                           {.folder = options.past, .history = history_of(options)}});
}

int serve(Options options) {
  if (!options.log.empty()) return serve_with_log(options);
  // First of all: one that another board has is left alone.
  const Result<std::shared_ptr<journal::JournalFile>> file = journal_of(options);
  if (!file) return complain(file.error(), bad_journal);
  RealExecutor executor(server::first_moment(RealExecutor::wall_clock, options.journal));
  const StopSignals signals(executor);
  // A file that may not grow is a failure of its journal, not the board's end.
  std::signal(SIGXFSZ, SIG_IGN);
  server::KeptBoard kept(executor, say_how_it_goes);
  const Result<void> begun = kept.begin(*file);
  if (!begun) return complain(begun.error(), bad_journal);
  options.server.journal = kept.journal();
  options.server.remembered = kept.take_remembered();
  const Result<std::unique_ptr<server::BoardServer>> server =
      server::BoardServer::open(executor, kept.board(), options.server);
  if (!server) return complain(server.error(), bad_address);
  fmt::print("pizarra-board: ready on {}\n", fmt::join((*server)->addresses(), " "));
  std::fflush(stdout);
  executor.run_until([] { return false; });
  say_what_is_lacking(kept.journal());
  if ((*server)->sessions() == 0) return stopped;
  (*server)->say_goodbye();
  executor.call_at(executor.now() + server::BoardServer::goodbye_length, [&executor] { executor.stop(); });
  executor.run_until([] { return false; });
  return stopped;
}

void add_journal_options(CLI::App& app, Options& options) {
  app.add_option("--journal", options.journal, "keep every transaction in FILE, and durable facts beyond a restart")
      ->check([](const std::string& file) { return file.empty() ? "names no file" : std::string(); })
      ->type_name("FILE");
  app.add_option("--history", options.history,
                 "how much of the past a journal keeps at least: a number of revisions, or a time such as 90s, "
                 "30min, 12h, 7d")
      ->check([](const std::string& text) {
        return history_from(text) ? std::string()
                                  : "not a number of revisions, 1000000000 at most, nor a time such as 30min, "
                                    "36500d at most";
      })
      ->capture_default_str();
  app.add_option("--history-size", options.history_bytes,
                 "the most space that the past may take, such as 64MB or 2GB; less past is kept then")
      ->transform(CLI::AsSizeValue(false))
      ->type_name("SIZE")
      ->default_str("1GB");
}

void add_log_options(CLI::App& app, Options& options) {
  CLI::Option* log =
      app.add_option("--log", options.log,
                     "keep durable facts in an etcd cluster, etcd://A,B,C/CELL: of the boards with the same log one "
                     "leads, and another takes over when it is gone")
          ->excludes("--journal")
          ->type_name("ADDRESS");
  app.add_option("--past", options.past,
                 "with a log: keep what this board serves, also what is not durable, in journals in this folder, one "
                 "each time that it leads")
      ->needs(log)
      ->type_name("DIR");
  app.add_option("--log-certificates", options.certificates,
                 "the folder of ca.crt, client.crt and client.key for a log that is not on this machine")
      ->needs(log)
      ->type_name("DIR");
  app.add_flag("--log-insecure", options.log_insecure, "speak to a log that is not on this machine unencrypted")
      ->needs(log);
  app.add_option("--name", options.name, "the name of this board in the log; default: this machine's")->needs(log);
  app.add_option("--cell", options.cell, "the cell whose board this is: a log of another cell is refused")
      ->needs(log)
      ->type_name("NAME");
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  CLI::App app("Run a blackboard for agents of other processes.", "pizarra-board");
  pizarra::programs::Options options;
  app.add_option("--listen", options.server.addresses,
                 "ipc://PATH or tcp://HOST:PORT (port * for any); may be repeated")
      ->required()
      ->type_name("ADDRESS");
  pizarra::programs::add_journal_options(app, options);
  pizarra::programs::add_log_options(app, options);
  app.add_option("--keys", options.server.keys,
                 "ask every tcp client for a key of this folder, made by `pizarra keys new`")
      ->type_name("DIR");
  app.add_flag("--insecure", options.server.insecure,
               "listen, unencrypted and to anybody, at addresses that other machines reach")
      ->excludes("--keys");
  app.footer(pizarra::programs::help_footer("board --listen ipc:///tmp/board.ipc --journal facts.journal",
                                            pizarra::programs::exit_codes));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return pizarra::programs::end_of_parsing(app, error);
  }
  return pizarra::programs::serve(std::move(options));
}
