#include "blackboard/client/contexts.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/time/together.hpp"
#include "lisp/reader.hpp"

namespace pizarra::client {

namespace {

Relation relation(const char* text) { return relation_from_datum(read_one(text).value()).value(); }

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

Failure name_taken(const std::string& root, const std::string& name, const std::string& by) {
  return {"name-taken",
          fmt::format("{} names {} {}: take another name, or first retract (context-board {} ?)", root, by, name, name),
          to_datum(by),
          {}};
}

}  // namespace

Relation Contexts::context_relation() {
  return relation("(relation context-board ((name symbol) (address string)) (key name) (durable))");
}

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
  const std::vector<Row> way_up = co_await ascend(root);
  // One that names it no more is none.
  const auto is_above = [&](const Row& row) {
    return row.address == address && !(row.fault && row.fault->symbol == "orphan");
  };
  if (std::ranges::any_of(way_up, is_above)) {
    const std::string where = address == root ? "itself" : "a board above it";
    co_return fail("context-loop", fmt::format("{} cannot name {}: the names would lead back to it", root, where),
                   to_datum(address));
  }
  const Result<Pairs> named_so_far = co_await pairs_of(root, "context-board");
  if (!named_so_far) co_return fail(of_board(named_so_far.error(), "", root));
  const auto same_name = std::ranges::find(*named_so_far, name, &Pairs::value_type::first);
  const bool taken = same_name != named_so_far->end() && same_name->second != address;
  if (taken) co_return fail(name_taken(root, name, same_name->second));
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

// Upwards, of a board that names the lower one still.
Task<Result<Contexts::Pairs>> Contexts::next_of(Listed* listed, Direction direction) {
  const std::string address = listed->row.address;
  if (direction == Direction::down) co_return co_await pairs_of(address, "context-board");
  const Result<Pairs> named = co_await pairs_of(address, "context-board");
  if (!named) co_return fail(named);
  const bool names_it = listed->from.empty() || std::ranges::count(*named, std::pair(listed->name, listed->from)) > 0;
  if (!names_it) {
    co_return fail("orphan", fmt::format("{} does not name {} as {} any more", address, listed->from, listed->name),
                   to_datum(listed->from));
  }
  Result<Pairs> parents = co_await pairs_of(address, "parent-board");
  if (!parents) co_return parents;
  for (auto& [parent, name] : *parents) std::swap(parent, name);
  co_return parents;
}

Task<void> Contexts::ask(Listed* listed, Direction direction) {
  Result<Pairs> next = co_await next_of(listed, direction);
  if (next && !listed->row.fault) listed->next = std::move(*next);
  if (!next && next.error().symbol == "orphan") listed->row.fault = next.error();
  if (!next && !listed->row.fault) listed->row.fault = of_board(next.error(), listed->row.path, listed->row.address);
}

Task<void> Contexts::ask_all(std::vector<Listed>* level, Direction direction) {
  std::vector<Task<void>> asking;
  for (Listed& listed : *level) {
    // Upwards, one that leads back may do so only because it was not told that it is named no more.
    const bool is_asked = !listed.row.fault || direction == Direction::up;
    if (is_asked) asking.push_back(ask(&listed, direction));
  }
  co_await run_together(executor_, std::move(asking), most_asked_at_once);
}

std::optional<Contexts::Row> Contexts::first_left_out(const std::vector<Listed>& level, std::size_t room) {
  if (level.size() <= room) return std::nullopt;
  Row row = level[room].row;
  const std::size_t others = level.size() - room - 1;
  row.fault =
      Failure{"too-many",
              fmt::format("the list is full: it lacks this one, {} more of the same level, and all below", others),
              {},
              {}};
  return row;
}

Task<std::vector<Contexts::Row>> Contexts::walk(std::string first, Direction direction, std::size_t most) {
  std::vector<Row> rows;
  std::map<std::string, std::string> paths;  // of the boards, by address
  std::vector<Listed> level = {{Row{"", first}}};
  for (std::size_t deep = 0; !level.empty(); ++deep) {
    const std::size_t room = most - rows.size();
    const std::optional<Row> left_out = first_left_out(level, room);
    level.resize(std::min(level.size(), room));
    for (Listed& listed : level) {
      Row& row = listed.row;
      const auto [known, is_new] = paths.emplace(row.address, row.path);
      if (!is_new) {
        const std::string back = known->second.empty() ? "the first board" : known->second;
        row.fault = Failure{"context-loop", fmt::format("it is {}, listed already", back), to_datum(row.address), {}};
      }
      if (is_new && deep == most_deep) row.fault = Failure{"too-deep", "nothing beyond it is listed", {}, {}};
    }
    co_await ask_all(&level, direction);
    std::vector<Listed> beyond;
    for (Listed& listed : level) {
      const Row& row = listed.row;
      for (const auto& [name, address] : listed.next) {
        const bool down = direction == Direction::down;
        const std::string path = row.path.empty() ? name : down ? row.path + "/" + name : name + "/" + row.path;
        beyond.push_back({Row{path, address}, row.address, name});
      }
      rows.push_back(std::move(listed.row));
    }
    if (left_out) {
      rows.push_back(*left_out);
      co_return rows;
    }
    level = std::move(beyond);
  }
  co_return rows;
}

Task<std::vector<Contexts::Row>> Contexts::list(std::string root, std::size_t most) {
  return walk(std::move(root), Direction::down, most);
}

Task<std::vector<Contexts::Row>> Contexts::ascend(std::string board) {
  return walk(std::move(board), Direction::up, most_listed);
}

}  // namespace pizarra::client
