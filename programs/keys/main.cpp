// pizarra-keys: makes the keys with which clients come to a board of another machine, and shows who may come.

#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/tokens.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {
namespace {

struct KeysChoices {
  std::string name;
  std::string folder = wire::default_key_folder();
  wire::Permissions may;
  bool json = false;
};

int make(const KeysChoices& choices) {
  wire::Permissions may = choices.may;
  if (may == wire::Permissions() && choices.name != wire::board_key_name) may = {{"*"}, {"*"}, {"*"}, {}};
  const Result<wire::KeyPair> made = wire::make_keys(choices.folder, choices.name, may);
  if (!made) return complain(made.error(), made.error().symbol == "cannot-write" ? exit_unavailable : exit_usage);
  const std::string base = text_of_bytes(choices.folder + "/" + choices.name);
  if (choices.json) {
    fmt::print("{{\"name\":{},\"key\":{},\"public\":{},\"secret\":{}}}\n", json_string(made->name),
               json_string(made->public_key), json_string(base + ".key"), json_string(base + ".secret"));
    return exit_reached;
  }
  fmt::print("{}.secret  keep it where the key's owner runs, and show it to nobody\n", base);
  fmt::print("{}.key  {}\n", base,
             choices.name == wire::board_key_name ? "every client needs it, beside its own secret"
                                                  : "goes to the board's folder of keys; it says what the key may do");
  return exit_reached;
}

int make_token(const KeysChoices& choices) {
  const Result<std::string> token = wire::make_token(choices.folder, choices.name);
  if (!token) return complain(token.error(), token.error().symbol == "cannot-write" ? exit_unavailable : exit_usage);
  if (choices.json) {
    fmt::print("{{\"name\":{},\"token\":{}}}\n", json_string(choices.name), json_string(*token));
  } else {
    fmt::print("{}\n", *token);
  }
  return exit_reached;
}

std::string json_list(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(json_string(name));
  return fmt::format("[{}]", fmt::join(quoted, ","));
}

std::string sentence_of(const wire::Permissions& may) {
  std::string sentence;
  const auto add = [&](const char* verb, const std::vector<std::string>& listed) {
    if (!listed.empty()) sentence += fmt::format("{}{} {}", sentence.empty() ? "" : "; ", verb, fmt::join(listed, " "));
  };
  add("tell", may.tell);
  add("take", may.take);
  add("read", may.read);
  add("override", may.override_leases);
  return sentence.empty() ? "nothing" : sentence;
}

void show(const wire::PublicKey& key, bool secret_here, bool json) {
  const bool board = key.name == wire::board_key_name;
  if (json) {
    fmt::print("{{\"name\":{},\"key\":{},\"secret\":{},\"tell\":{},\"take\":{},\"read\":{},\"override\":{}}}\n",
               json_string(key.name), json_string(key.key), secret_here, json_list(key.may.tell),
               json_list(key.may.take), json_list(key.may.read), json_list(key.may.override_leases));
    return;
  }
  fmt::print("{:<16} {}  {}{}\n", key.name, key.key, board ? "the board itself" : sentence_of(key.may),
             secret_here ? "  (its secret is here)" : "");
}

int show_all(const KeysChoices& choices) {
  const Result<std::vector<std::string>> files = wire::public_key_files(choices.folder);
  if (!files) return complain(files.error(), exit_unavailable);
  int status = exit_reached;
  for (const std::string& file : *files) {
    const Result<wire::PublicKey> key = wire::read_public_key(file);
    if (!key) {
      status = complain(key.error(), exit_usage);
      continue;
    }
    const std::filesystem::path secret = std::filesystem::path(file).replace_extension(".secret");
    show(*key, std::filesystem::exists(secret), choices.json);
  }
  return status;
}

void add_common_options(CLI::App* word, KeysChoices& choices) {
  word->add_option("--dir", choices.folder, "The folder of the keys")->capture_default_str();
  word->add_flag("--json", choices.json, "Print one JSON object a line");
  word->footer(help_footer(
      word->get_name() == "list" ? "keys list" : "keys " + word->get_name() + " vision",
      "Exit status: 0 done; 2 a wrong word, option, name or file of keys; 4 a file cannot be read or written."));
}

void add_keys_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<KeysChoices>();
  CLI::App* keys =
      app.add_subcommand("keys", "The keys with which clients come to a board of another machine (docs/security.md).");
  keys->require_subcommand(1);
  CLI::App* fresh = keys->add_subcommand(
      "new", "Make a key: NAME.secret for its owner, NAME.key for the board. The board's own is called board.");
  fresh->add_option("NAME", choices->name, "The owner's name: an agent, a host or a person")->required();
  const auto permission = [&](const char* option, std::vector<std::string>& listed, const char* help) {
    fresh->add_option(option, listed, help)->delimiter(',')->type_name("RELATION,...");
  };
  permission("--tell", choices->may.tell,
             "Relations that it may tell and retract: names, beginnings with a star, or *");
  permission("--take", choices->may.take, "What it may take");
  permission("--read", choices->may.read, "What it may ask for and watch; everything of all, where nothing is named");
  permission("--override", choices->may.override_leases, "What of others' leased facts it may replace and retract");
  add_common_options(fresh, *choices);
  fresh->callback([choices, &status] { status = make(*choices); });
  CLI::App* token = keys->add_subcommand(
      "token", "Make the token with which the owner of a key logs in at a console; the one before is void.");
  token->add_option("NAME", choices->name, "The key, whose secret is in the folder")->required();
  add_common_options(token, *choices);
  token->callback([choices, &status] { status = make_token(*choices); });
  CLI::App* all = keys->add_subcommand("list", "Show the keys of a folder and what each may do.");
  add_common_options(all, *choices);
  all->callback([choices, &status] { status = show_all(*choices); });
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_keys_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
