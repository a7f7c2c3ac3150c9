#pragma once

// A board that keeps its journal, and durable facts to tell it.

#include "tests/bench/blackboard/board_process.hpp"

namespace pizarra::bench {

// Gone with everything in it.
class JournalFolder {
 public:
  std::string file(const std::string& name) const { return folder_.path() + "/" + name; }
  std::vector<std::string> board_options() const { return {"--journal", file("board.journal")}; }
  double megabytes() const;

 private:
  TemporaryFolder folder_;
};

// `(kept NAME X Y D)`, durable, its key the name, 40 bytes of text.
Relation kept_relation();
Datum kept_fact(int object, int count);

// Tells transactions made by `make`, so many of them at once.
void tell_all(Client& client, int transactions, int in_flight, const std::function<Transaction(int)>& make);

}  // namespace pizarra::bench
