#pragma once

// Boards that name other boards, so that one address leads to a hall of cells. Two durable facts, one on either side:
//
//   (context-board NAME "ADDRESS")        of the board that names another one; key NAME
//   (parent-board "ADDRESS" NAME)         of the board that is named: by whom, and how; key ADDRESS
//
//   Contexts contexts(executor, "alice", keys);
//   Result<std::string> address = co_await contexts.resolve("tcp://hall:7943", "north/blocks");
//   std::vector<Contexts::Row> rows = co_await contexts.list("tcp://hall:7943");
//   rows = co_await contexts.ascend(*address);    // those above it, up to the boards that nobody names
//
// It is the client that goes from board to board; boards know nothing of each other. Failures: no-context, unreachable
// (which board of the way does not answer), context-loop, name-taken, too-deep, orphan (the parent does not name
// it back), and those of the boards. A board is known by its address as it is written.

#include <optional>
#include <string>
#include <vector>

#include "blackboard/client/remote_board.hpp"

namespace pizarra::client {

class Contexts {
 public:
  static constexpr std::size_t most_deep = 16;
  static constexpr std::size_t most_listed = 10'000;
  static constexpr std::size_t most_asked_at_once = 64;

  Contexts(Executor& executor, std::string teller, std::optional<wire::ClientKeys> keys, Duration patience = 2s)
      : executor_(executor), teller_(std::move(teller)), keys_(std::move(keys)), patience_(patience) {}

  // Of (context-board NAME ADDRESS). To follow it on a board that may name none yet, declare it first.
  static Relation context_relation();

  // Both facts. Failures: context-loop for the root itself, and for a board above it; name-taken where the root names
  // another address so.
  Task<Result<void>> add(std::string root, std::string name, std::string address);
  // The address that the path of names with `/` between them leads to; that of the root for an empty one.
  Task<Result<std::string>> resolve(std::string root, std::string path);

  struct Row {
    std::string path;
    std::string address;
    std::optional<Failure> fault = {};  // why nothing beyond it is listed
  };
  // The boards below the root, each once and `most` at most, level by level. Where there are more, one row more says
  // so, with the fault `too-many`. Boards of a level are asked together, so that silent ones are waited for together.
  Task<std::vector<Row>> list(std::string root, std::size_t most = most_listed);
  // The same in the other direction, by all parents of each board. A path leads from the row's board to the first.
  Task<std::vector<Row>> ascend(std::string board);

  // A session with the board there.
  Result<std::unique_ptr<RemoteBoard>> reach(const std::string& address) const;

 private:
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  // The two parts of each fact of the relation on that board, sorted.
  Task<Result<Pairs>> pairs_of(std::string address, std::string relation);
  enum class Direction : std::uint8_t { down, up };
  // A board of a list, and those that it names, or that name it.
  struct Listed {
    Row row;
    std::string from = {};  // the address of the board that led here
    std::string name = {};  // of the lower one of both
    Pairs next = {};        // name and address
  };
  static std::optional<Row> first_left_out(const std::vector<Listed>& level, std::size_t room);
  Task<std::vector<Row>> walk(std::string first, Direction direction, std::size_t most);
  Task<Result<Pairs>> next_of(Listed* listed, Direction direction);
  Task<void> ask(Listed* listed, Direction direction);
  Task<void> ask_all(std::vector<Listed>* level, Direction direction);

  Executor& executor_;
  const std::string teller_;
  const std::optional<wire::ClientKeys> keys_;
  const Duration patience_;
};

}  // namespace pizarra::client
