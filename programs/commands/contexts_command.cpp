// `contexts`: the boards that a board names, and where a path of names leads.

#include <fmt/format.h>

#include "blackboard/client/contexts.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "lisp/reader.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

using client::Contexts;

struct ContextsChoices {
  std::string path;
  std::string add;
  bool up = false;
  bool json = false;
  BoardChoices board;
};

struct Named {
  std::string name;
  std::string address;
};

Result<Named> named_from(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const Result<Datum> symbol = read_one(name);
  const bool fits = equals != std::string::npos && symbol && symbol->is_symbol() && !name.contains('/');
  if (!fits) return fail("bad-option", "a board is named as NAME=ADDRESS, NAME a word without /", to_datum(text));
  return Named{name, text.substr(equals + 1)};
}

template <class T>
Task<void> put(Task<T> task, std::optional<T>* into) {
  T value = co_await std::move(task);
  into->emplace(std::move(value));
}

template <class T>
T wait_for(Executor& executor, Task<T> task) {
  std::optional<T> result;
  const Job job = executor.spawn(put(std::move(task), &result));
  executor.run_until([&] { return job.done(); });
  return std::move(*result);
}

std::string json_row(const Contexts::Row& row) {
  const std::string fault = row.fault ? json_string(describe(*row.fault)) : "null";
  return fmt::format("{{\"path\":{},\"address\":{},\"fault\":{}}}", json_string(row.path), json_string(row.address),
                     fault);
}

int print_tree(const std::vector<Contexts::Row>& rows, bool json) {
  bool whole = true;
  for (const Contexts::Row& row : rows) {
    whole = whole && !row.fault;
    if (json) {
      fmt::print("{}\n", json_row(row));
      continue;
    }
    const std::string path = row.path.empty() ? "." : row.path;
    fmt::print("{:<24} {:<32} {}\n", path, text_of_bytes(row.address),
               row.fault ? text_of_bytes(describe(*row.fault)) : "there");
  }
  return whole ? exit_reached : exit_failed;
}

int print_place(const Result<std::string>& address, bool json) {
  if (!address) return complain_of_board(json ? repl::Style::json : repl::Style::text, address.error());
  if (json) fmt::print("{{\"address\":{}}}\n", json_string(*address));
  if (!json) fmt::print("{}\n", text_of_bytes(*address));
  return exit_reached;
}

int run_contexts(const ContextsChoices& choices) {
  const Result<Destination> to = destination(choices.board);
  if (!to) return complain(to.error(), exit_unavailable);
  const Result<std::optional<wire::ClientKeys>> keys = client::keys_from(to->key);
  if (!keys) return complain(keys.error(), exit_usage);
  RealExecutor executor;
  Contexts contexts(executor, prompt_name(), *keys);
  if (!choices.add.empty()) {
    const Result<Named> named = named_from(choices.add);
    if (!named) return complain(named.error(), exit_usage);
    const Result<void> added = wait_for(executor, contexts.add(to->address, named->name, named->address));
    return added ? exit_reached : complain_of_board(repl::Style::text, added.error());
  }
  if (choices.up) return print_tree(wait_for(executor, contexts.ascend(to->address)), choices.json);
  if (choices.path.empty()) return print_tree(wait_for(executor, contexts.list(to->address)), choices.json);
  return print_place(wait_for(executor, contexts.resolve(to->address, choices.path)), choices.json);
}

}  // namespace

void add_contexts_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ContextsChoices>();
  CLI::App* contexts = app.add_subcommand(
      "contexts", "List the boards that a board names, and those that these name; or say where a path of names leads.");
  CLI::Option* path = contexts->add_option("PATH", choices->path, "Names with / between them, such as north/blocks");
  CLI::Option* add = contexts->add_option("--add", choices->add, "Have the board name another one: NAME=ADDRESS")
                         ->type_name("NAME=ADDRESS")
                         ->excludes(path);
  contexts
      ->add_flag("--up", choices->up, "List the boards above this one, by all parents, up to those that nobody names")
      ->excludes(path, add);
  contexts->add_flag("--json", choices->json, "Print one JSON object a line");
  add_board_options(contexts, choices->board);
  contexts->footer(help_footer("contexts north/blocks --board tcp://hall:7943"));
  contexts->callback([choices, &status] { status = run_contexts(*choices); });
}

}  // namespace pizarra::programs
