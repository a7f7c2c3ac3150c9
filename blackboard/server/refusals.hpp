#pragma once

// The board's refusals, as facts: all that is malformed, forged or in no session, and every request that fails for
// another reason than that its precondition does not hold or that the journal cannot be written.
//
//   (board-refusal CLIENT SYMBOL COUNT SENTENCE)       ; key CLIENT SYMBOL
//
// CLIENT is who said it: the name of the session's key; without a key, its teller; a public key that is not known; or
// "" for a client without a session. COUNT is how often since the server began or forgot it. SENTENCE is about the
// newest refusal, 256 bytes of it. At most 256 pairs of client and symbol are told: a new pair replaces the one that
// was refused longest ago, whose count is added to the pair of "others" and refused. So the newest refusal always has
// its name, whatever strangers did before. A flood of refusals changes the facts ten times a second at most.
//
//   Refusals refusals(board);
//   refusals.note("alice", failure);

#include <map>
#include <set>
#include <string>

#include "blackboard/memory/memory_board.hpp"

namespace pizarra::server {

class Refusals {
 public:
  static constexpr std::size_t most_kinds = 256;
  static constexpr std::size_t longest_sentence = 256;
  static constexpr Duration pause = 100ms;

  // Failure wrong-shape: the relation is declared differently.
  static Result<void> declare(memory::MemoryBoard& board);

  explicit Refusals(memory::MemoryBoard& board) : board_(board) {}
  Refusals(const Refusals&) = delete;
  Refusals& operator=(const Refusals&) = delete;
  ~Refusals();

  void note(const std::string& client, const Failure& failure);

 private:
  using Kind = std::pair<std::string, std::string>;
  struct Count {
    std::int64_t count = 0;
    std::string sentence;
    std::uint64_t newest = 0;  // the number of its newest refusal
  };
  void forget_the_oldest();
  void tell();

  memory::MemoryBoard& board_;
  std::uint64_t noted_ = 0;
  std::map<Kind, Count> counts_;
  Count others_;           // of the forgotten
  std::set<Kind> untold_;  // of counts_
  std::set<Kind> told_;    // what stands on the board, `others` apart
  Executor::TimerId timer_ = 0;
};

}  // namespace pizarra::server
