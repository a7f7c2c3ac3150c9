#include "tests/bench/crash/client_tools.hpp"

#include <unistd.h>

#include "lisp/reader.hpp"

namespace pizarra::bench {

std::vector<Relation> crash_relations() {
  std::vector<Relation> relations;
  for (const char* text : {"(relation item ((writer integer) (n integer)) (durable))",
                           "(relation counter ((writer integer) (n integer)) (key writer) (durable))",
                           "(relation effect ((writer integer) (n integer) (serial integer)) (durable))",
                           "(relation register ((k integer) (value integer)) (key k) (durable))",
                           "(relation token ((who integer) (n integer)) (durable))"}) {
    relations.push_back(relation_from_datum(read_one(text).value()).value());
  }
  return relations;
}

void report(int reports, const Report& what) {
  // The one who listens has gone: so do we.
  if (write(reports, &what, sizeof what) != sizeof what) _exit(0);
}

Task<void> declare(Board& board) {
  while (true) {
    std::vector<Relation> relations = crash_relations();
    const Result<void> declared = co_await board.declare(std::move(relations));
    if (declared) co_return;
  }
}

std::unique_ptr<client::RemoteBoard> connect(Executor& executor, const std::string& address, const std::string& kind,
                                             int who) {
  return client::RemoteBoard::connect(executor, address, kind + "-" + std::to_string(who)).value();
}

}  // namespace pizarra::bench
