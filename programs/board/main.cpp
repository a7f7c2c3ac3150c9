// pizarra-board: a board alone, for agents of other processes. It links neither OpenCV nor Guile, so that it starts at
// once and stays small.

#include <CLI/CLI.hpp>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {
namespace {

enum Exit : int { stopped = 0, bad_usage = 2, bad_address = 3, bad_journal = 4 };

constexpr const char* exit_codes =
    "Exit codes: 0 stopped by SIGINT or SIGTERM, 2 wrong arguments, 3 an address or its keys cannot be used, 4 the "
    "journal cannot be read or opened.";

int complain(const Failure& failure, Exit code) {
  fmt::print(stderr, "pizarra-board: {}\n", describe(failure));
  return code;
}

struct Options {
  server::BoardServerOptions server;
  std::string journal;
  std::string history = "200000";
  std::uint64_t history_bytes = journal::History().bytes;
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

// A board that lives again from its journal, where there is one, and goes on writing it.
class KeptBoard {
 public:
  explicit KeptBoard(Executor& executor) : executor_(executor) {}

  // Null where it keeps none.
  Result<void> begin(const std::shared_ptr<journal::JournalFile>& file) {
    // Leases are numbered from the time, so that one of an earlier life is not taken for one of this.
    auto store = std::make_unique<store::Store>(static_cast<LeaseId>(executor_.now().time_since_epoch().count()));
    if (file != nullptr) {
      const Result<void> recovered = recover(file, *store);
      if (!recovered) return recovered;
    }
    board_ = std::make_unique<memory::MemoryBoard>(executor_, std::move(store));
    if (journal_ != nullptr) board_->set_journal([this](std::string_view line) { journal_->append(line); });
    board_->resume();
    return {};
  }
  memory::MemoryBoard& board() { return *board_; }
  journal::JournalWriter* journal() { return journal_.get(); }
  // When the board ends.
  void say_what_is_lacking() const {
    if (journal_ == nullptr || !journal_->failure()) return;
    fmt::print(stderr, "pizarra-board: ends while its journal lacks what came last: {}\n",
               describe(*journal_->failure()));
  }
  std::vector<journal::RememberedReply> take_remembered() { return std::exchange(remembered_, {}); }

 private:
  Result<void> recover(const std::shared_ptr<journal::JournalFile>& file, store::Store& store) {
    Result<std::vector<journal::RememberedReply>> remembered = file->recover(store);
    if (!remembered) return fail(remembered);
    remembered_ = std::move(*remembered);
    journal_ = std::make_unique<journal::JournalWriter>(executor_, file);
    journal_->on_failure = say_how_it_goes;
    if (journal_->failure()) say_how_it_goes(journal_->failure());
    return {};
  }

  static void say_how_it_goes(const std::optional<Failure>& failure) {
    const std::string news =
        failure ? describe(*failure) + "; what adds to durable facts is refused until it can be written"
                : std::string("the journal can be written again");
    fmt::print(stderr, "pizarra-board: {}\n", news);
  }

  Executor& executor_;
  std::vector<journal::RememberedReply> remembered_;
  std::unique_ptr<journal::JournalWriter> journal_;
  std::unique_ptr<memory::MemoryBoard> board_;
};

// The wall clock's, unless that was set back since the journal's end: a board's times only grow, from life to life, and
// so do its leases' numbers.
Time first_moment(const std::string& journal) {
  Time end{};
  std::error_code unseen;
  if (std::filesystem::is_regular_file(journal, unseen)) {
    // One that cannot be read is reported by whoever goes on from it.
    const Result<journal::LineStart> last = journal::end_of_journal(journal);
    if (last) end = last->when;
  }
  // Read last: the executor's clock goes on from here.
  return std::max(RealExecutor::wall_clock(), end);
}

// Null where none is kept.
Result<std::shared_ptr<journal::JournalFile>> journal_of(const Options& options) {
  if (options.journal.empty()) return nullptr;
  journal::History history = *history_from(options.history);
  history.bytes = options.history_bytes;
  return journal::JournalFile::open(options.journal, history);
}

int serve(Options options) {
  // First of all: one that another board has is left alone.
  const Result<std::shared_ptr<journal::JournalFile>> file = journal_of(options);
  if (!file) return complain(file.error(), bad_journal);
  RealExecutor executor(first_moment(options.journal));
  const StopSignals signals(executor);
  // A file that may not grow is a failure of its journal, not the board's end.
  std::signal(SIGXFSZ, SIG_IGN);
  KeptBoard kept(executor);
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
  kept.say_what_is_lacking();
  if ((*server)->sessions() == 0) return stopped;
  (*server)->say_goodbye();
  executor.call_at(executor.now() + server::BoardServer::goodbye_length, [&executor] { executor.stop(); });
  executor.run_until([] { return false; });
  return stopped;
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  CLI::App app("The blackboard that agents of other processes meet at.", "pizarra-board");
  pizarra::programs::Options options;
  app.add_option("--listen", options.server.addresses,
                 "ipc://PATH or tcp://HOST:PORT (port * for any); may be repeated")
      ->required()
      ->type_name("ADDRESS");
  app.add_option("--journal", options.journal, "keep every transaction in FILE, and durable facts beyond a restart")
      ->check([](const std::string& file) { return file.empty() ? "names no file" : std::string(); })
      ->type_name("FILE");
  app.add_option("--history", options.history,
                 "how much of the past the journal keeps at least: revisions, or a time such as 90s, 30min, 12h, 7d")
      ->check([](const std::string& text) {
        return pizarra::programs::history_from(text)
                   ? std::string()
                   : "not a number of revisions, 1000000000 at most, nor a time such as 30min, "
                     "36500d at most";
      })
      ->capture_default_str();
  app.add_option("--history-size", options.history_bytes,
                 "how much space the past may take at most, such as 64MB or 2GB; less is kept then")
      ->transform(CLI::AsSizeValue(false))
      ->type_name("SIZE")
      ->default_str("1GB");
  app.add_option("--keys", options.server.keys,
                 "ask who comes over tcp for a key of this folder, made by `pizarra keys new`")
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
