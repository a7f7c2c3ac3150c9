#include "blackboard/client/contexts.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/reader.hpp"

namespace pizarra::client {

namespace {

Relation relation(const char* text) { return relation_from_datum(read_one(text).value()).value(); }

Relation context_relation() {
  return relation("(relation context-board ((name symbol) (address string)) (key name) (durable))");
}

Relation parent_relation() {
  return relation("(relation parent-board ((address string) (name symbol)) (key address) (durable))");
}

Task<Result<void>> tell_fact(RemoteBoard& board, Relation relation, Datum fact) {
  std::vector<Relation> relations = {std::move(relation)};
  const Result<void> declared = co_await board.declare(std::move(relations));
  if (!declared) co_return declared;
  const Result<Revision> told = co_await board.tell(std::move(fact));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

// The board that failed, as a person knows it.
Failure of_board(Failure failure, const std::string& path, const std::string& address) {
  failure.sentence += path.empty() ? ": the board at " + address : ": " + path + " at " + address;
  failure.subject = to_datum(address);
  return failure;
}

}  // namespace

Result<std::unique_ptr<RemoteBoard>> Contexts::reach(const std::string& address) const {
  return RemoteBoard::connect(executor_, address, teller_, patience_, keys_);
}

Task<Result<Contexts::Pairs>> Contexts::pairs_of(std::string address, std::string relation) {
  const auto board = reach(address);
  if (!board) co_return fail(board);
  Query query = query_for(pizarra::list(Datum::symbol(relation), "?"_sym, "?"_sym));
  const Result<Answers> answers = co_await (*board)->ask(std::move(query));
  // Who has said nothing of the kind has none.
  const bool undeclared = !answers && answers.error().symbol == "undeclared-relation";
  if (undeclared) co_return Pairs();
  if (!answers) co_return fail(answers);
  Pairs pairs;
  for (const Answer& answer : answers->answers) {
    const Datum& fact = answer.facts.front().datum;
    pairs.emplace_back(fact[1].text(), fact[2].text());
  }
  std::ranges::sort(pairs);
  co_return pairs;
}

Task<Result<void>> Contexts::add(std::string root, std::string name, std::string address) {
  const auto above = reach(root);
  if (!above) co_return fail(above);
  const auto below = reach(address);
  if (!below) co_return fail(below);
  // That one first: a context that nobody answers is worse than a parent that does not know of it.
  Datum parent = pizarra::list("parent-board"_sym, root, Datum::symbol(name));
  const Result<void> told = co_await tell_fact(**below, parent_relation(), std::move(parent));
  if (!told) co_return fail(of_board(told.error(), name, address));
  Datum context = pizarra::list("context-board"_sym, Datum::symbol(name), address);
  const Result<void> named = co_await tell_fact(**above, context_relation(), std::move(context));
  if (!named) co_return fail(of_board(named.error(), "", root));
  co_return Result<void>();
}

Task<Result<std::string>> Contexts::resolve(std::string root, std::string path) {
  std::string address = root;
  std::string walked;
  std::size_t begun = 0;
  for (std::size_t deep = 0; begun < path.size(); ++deep) {
    if (deep == most_deep) co_return fail("too-deep", "a path has 16 names at most", to_datum(path));
    const std::size_t end = std::min(path.find('/', begun), path.size());
    const std::string name = path.substr(begun, end - begun);
    const Result<Pairs> contexts = co_await pairs_of(address, "context-board");
    if (!contexts) co_return fail(of_board(contexts.error(), walked, address));
    const auto found = std::ranges::find(*contexts, name, &Pairs::value_type::first);
    if (found == contexts->end()) {
      const std::string where = walked.empty() ? "the board at " + address : walked;
      co_return fail("no-context", fmt::format("{} names no board {}", where, name), to_datum(name));
    }
    address = found->second;
    walked += (walked.empty() ? "" : "/") + name;
    begun = end + 1;
  }
  co_return address;
}

Task<void> Contexts::ask(Listed* listed, std::size_t* waiting, Event* answered) {
  Result<Pairs> named = co_await pairs_of(listed->row.address, "context-board");
  if (named) listed->named = std::move(*named);
  if (!named) listed->row.fault = of_board(named.error(), listed->row.path, listed->row.address);
  --*waiting;
  answered->set();
}

Task<void> Contexts::ask_all(std::vector<Listed>* level) {
  Event answered(executor_);
  std::size_t waiting = 0;
  std::vector<Job> asking;
  for (Listed& listed : *level) {
    if (listed.row.fault) continue;
    while (waiting == most_asked_at_once) {
      answered.reset();
      co_await answered.wait();
    }
    ++waiting;
    asking.push_back(executor_.spawn(ask(&listed, &waiting, &answered)));
  }
  while (waiting > 0) {
    answered.reset();
    co_await answered.wait();
  }
}

Task<std::vector<Contexts::Row>> Contexts::list(std::string root) {
  std::vector<Row> rows;
  std::map<std::string, std::string> paths;  // of the boards, by address
  std::vector<Listed> level = {{Row{"", root}}};
  for (std::size_t deep = 0; !level.empty(); ++deep) {
    level.resize(std::min(level.size(), most_listed - rows.size()));
    for (auto& [row, named] : level) {
      const auto [known, is_new] = paths.emplace(row.address, row.path);
      if (!is_new) {
        const std::string back = known->second.empty() ? "the first board" : known->second;
        row.fault = Failure{"context-loop", fmt::format("it is {}, listed already", back), to_datum(row.address), {}};
      }
      if (is_new && deep == most_deep) row.fault = Failure{"too-deep", "nothing below it is listed", {}, {}};
    }
    co_await ask_all(&level);
    std::vector<Listed> below;
    for (Listed& listed : level) {
      for (const auto& [name, address] : listed.named) {
        const std::string path = listed.row.path.empty() ? name : fmt::format("{}/{}", listed.row.path, name);
        below.push_back({Row{path, address}});
      }
      rows.push_back(std::move(listed.row));
    }
    level = std::move(below);
  }
  co_return rows;
}

Task<Result<std::vector<std::string>>> Contexts::ascend(std::string board) {
  std::vector<std::string> way = {board};
  while (true) {
    const std::string here = way.back();
    const Result<Pairs> parents = co_await pairs_of(here, "parent-board");
    if (!parents) co_return fail(of_board(parents.error(), "", here));
    if (parents->empty()) co_return way;
    const auto& [parent, name] = parents->front();
    const bool was_here = std::ranges::count(way, parent) > 0;
    if (was_here) {
      co_return fail("context-loop", fmt::format("{} is above and below {}", parent, here), to_datum(parent));
    }
    if (way.size() == most_deep) {
      co_return fail("too-deep", fmt::format("there are more than {} boards above each other", most_deep));
    }
    const Result<Pairs> contexts = co_await pairs_of(parent, "context-board");
    if (!contexts) co_return fail(of_board(contexts.error(), "", parent));
    const auto found = std::ranges::find(*contexts, name, &Pairs::value_type::first);
    const bool names_it = found != contexts->end() && found->second == here;
    if (!names_it) {
      co_return fail("orphan", fmt::format("{} does not name {} as {} any more", parent, here, name), to_datum(here));
    }
    way.push_back(parent);
  }
}

}  // namespace pizarra::client
