// pizarra-board: a board alone, for agents of other processes. It links neither OpenCV nor Guile, so that it starts at
// once and stays small.

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "agents/launcher/command_line.hpp"
#include "blackboard/board_server.hpp"
#include "blackboard/journal_file.hpp"
#include "blackboard/memory_board.hpp"
#include "blackboard/store.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"

namespace pizarra {
namespace {

enum Exit : int { stopped = 0, bad_usage = 2, bad_address = 3, bad_journal = 4 };

constexpr const char* exit_codes =
    "Exit codes: 0 stopped by SIGINT or SIGTERM, 2 wrong arguments, 3 an address cannot be used, 4 the journal cannot "
    "be "
    "read or written.";

int complain(const Failure& failure, Exit code) {
  fmt::print(stderr, "pizarra-board: {}\n", describe(failure));
  return code;
}

struct Options {
  BoardServerOptions server;
  std::string journal;
};

int serve(const Options& options) {
  RealExecutor executor;
  const StopSignals signals(executor);
  // Leases are numbered from the time, so that one of an earlier life is not taken for one of this.
  auto store = std::make_unique<Store>(static_cast<LeaseId>(executor.now().time_since_epoch().count()));
  std::unique_ptr<JournalFile> journal;
  if (!options.journal.empty()) {
    Result<std::unique_ptr<JournalFile>> opened = JournalFile::open(options.journal, *store);
    if (!opened) return complain(opened.error(), bad_journal);
    journal = std::move(*opened);
  }
  MemoryBoard board(executor, std::move(store));
  int code = stopped;
  if (journal != nullptr) {
    journal->on_failure = [&](const Failure& failure) {
      code = complain(failure, bad_journal);
      executor.stop();
    };
    board.set_journal([&](std::string_view line) { journal->append(line); });
  }
  board.resume();
  const Result<std::unique_ptr<BoardServer>> server = BoardServer::open(executor, board, options.server);
  if (!server) return complain(server.error(), bad_address);
  fmt::print("pizarra-board: ready on {}\n", fmt::join((*server)->addresses(), " "));
  std::fflush(stdout);
  executor.run_until([] { return false; });
  return code;
}

}  // namespace
}  // namespace pizarra

int main(int argc, char** argv) {
  CLI::App app("The blackboard that agents of other processes meet at.", "pizarra-board");
  pizarra::Options options;
  app.add_option("--listen", options.server.addresses,
                 "ipc://PATH or tcp://HOST:PORT (port * for any); may be repeated")
      ->required()
      ->type_name("ADDRESS");
  app.add_option("--journal", options.journal, "keep every transaction in FILE, and durable facts beyond a restart")
      ->type_name("FILE");
  app.add_flag("--insecure", options.server.insecure, "allow addresses that other machines reach, unencrypted");
  app.footer(pizarra::exit_codes);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return pizarra::end_of_parsing(app, error);
  }
  return pizarra::serve(options);
}
