#include "agents/runtime/program.hpp"

#include <array>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <unistd.h>

#include "blackboard/client/keyed_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::runtime {

namespace {

constexpr int ended_by_signal = 0, failed = 1, wrong_words = 2;

struct Words {
  std::string board;
  std::string name;
  std::string key;  // the file of its secret; empty: none
};

Result<Words> words_from(const std::string& name, std::span<char* const> typed) {
  Words words{.board = {}, .name = name, .key = {}};
  for (std::size_t i = 0; i < typed.size(); ++i) {
    const std::string word = typed[i];
    std::string* of_option = word == "--name" ? &words.name : word == "--key" ? &words.key : nullptr;
    const bool misplaced = of_option != nullptr ? i + 1 == typed.size() : word.starts_with('-') || !words.board.empty();
    if (misplaced) return fail("malformed", "not understood: " + text_of_bytes(word));
    if (of_option != nullptr) {
      *of_option = typed[++i];
    } else {
      words.board = word;
    }
  }
  if (words.board.empty()) return fail("malformed", "it needs a board's address, as `pizarra ps` shows it");
  return words;
}

std::string this_host() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? text_of_bytes(name.data()) : "localhost";
}

Task<void> run_to_its_end(Agent& agent, std::optional<Result<void>>& ended) {
  Result<void> result = co_await agent.run();
  ended = std::move(result);
}

int complain(const std::string& name, const Failure& failure, int status) {
  fmt::print(stderr, "{}: {}\n", name, describe(failure));
  return status;
}

}  // namespace

int agent_main(const std::string& name, int argc, char** argv, const MakeAgent& make) {
  const Result<Words> words = words_from(name, std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
  if (!words) {
    fmt::print(stderr, "usage: {} BOARD-ADDRESS [--name NAME] [--key FILE]\n", name);
    return complain(name, words.error(), wrong_words);
  }
  RealExecutor executor;
  const StopSignals signals(executor);
  const auto board = client::keyed_board(executor, words->board, words->key, words->name);
  if (!board) return complain(name, board.error(), wrong_words);
  const std::unique_ptr<Agent> agent =
      make({words->name, this_host(), executor, **board, Random(1).split(words->name)});
  std::optional<Result<void>> ended;
  const Job job = executor.spawn(run_to_its_end(*agent, ended));
  executor.run_until([&ended] { return ended.has_value(); });
  if (!ended || *ended) return ended_by_signal;
  return complain(name, ended->error(), failed);
}

}  // namespace pizarra::runtime
